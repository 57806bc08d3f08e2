"""The kinds of perception by name."""

from collections.abc import Callable
from typing import cast

from uniteam.errors import InvalidInputError
from uniteam.interface import Perception
from uniteam.mind.perception.detectors.detic import DETIC
from uniteam.mind.perception.detectors.grounded_sam import GROUNDED_SAM
from uniteam.mind.perception.detectors.owlv2 import OWLV2
from uniteam.mind.perception.detectors.recognize_anything import recognize_anything
from uniteam.mind.perception.detectors.remote import REMOTE
from uniteam.mind.perception.detectors.yoloe import YOLOE
from uniteam.mind.perception.learned.learned_perception import LearnedPerception
from uniteam.mind.perception.noise.noisy import noisy_of
from uniteam.mind.perception.truth import TruthPerception
from uniteam.registry import Family, Registry

PerceptionFactory = Callable[[], Perception]
"""Builds a perception afresh; often its class."""


def _checked(name: str, value: object) -> PerceptionFactory:
    if not callable(value):
        raise InvalidInputError(
            f"perception '{name}' must be a class, or a function without arguments, that makes an object with reset "
            f"and perceive, got {type(value).__name__}"
        )
    return cast(PerceptionFactory, value)


PERCEPTIONS: Registry[PerceptionFactory] = Registry("perception", "uniteam.perceptions", _checked)
PERCEPTIONS.register("truth", TruthPerception)
PERCEPTIONS.register("learned", LearnedPerception)
PERCEPTIONS.register("noisy", Family("the truth with a detector's errors, few to many", "LEVEL", "0.6", noisy_of))
PERCEPTIONS.register("owlv2", OWLV2)
PERCEPTIONS.register("grounded-sam", GROUNDED_SAM)
PERCEPTIONS.register("detic", DETIC)
PERCEPTIONS.register("yoloe", YOLOE)
PERCEPTIONS.register("recognize-anything", recognize_anything(PERCEPTIONS.get))
PERCEPTIONS.register("remote", REMOTE)


def make_perception(name: str) -> Perception:
    """Return a new perception by name or reference.

    Raises:
        UnknownNameError: there is none of this name; the message offers the nearest.
        InvalidInputError: what the factory makes cannot perceive.
    """
    return build_perception(name, PERCEPTIONS.get(name))


def build_perception(name: str, factory: PerceptionFactory) -> Perception:
    """Return a new perception; raises InvalidInputError, with what it is called, where what is made cannot perceive."""
    made = factory()
    missing = [method for method in ("reset", "perceive") if not callable(getattr(made, method, None))]
    if missing:
        raise InvalidInputError(
            f"perception '{name}' needs reset(instruction, seed) and perceive(observation); "
            f"{type(made).__name__} has no {' and no '.join(missing)}"
        )
    return made


def check_ready(name: str) -> None:
    """Let a perception say what it lacks before a run begins, by a function `check_ready` of its factory's.

    Raises:
        UnknownNameError: there is none of this name.
        UniteamError: what is to be installed.
    """
    check = getattr(PERCEPTIONS.get(name), "check_ready", None)
    if callable(check):
        check()


def needs_truth(name: str) -> bool:
    """Return whether observations must carry the simulator's own segmentation. Raises what `make_perception` does."""
    return bool(getattr(PERCEPTIONS.get(name), "needs_truth", False))
