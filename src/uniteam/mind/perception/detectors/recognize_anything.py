"""Perception `recognize-anything`: a tagger says which names are in the frame, and only those a detector is asked for.

Recognize Anything (Zhang et al. 2023) is such a tagger; it cannot be installed by pip beside what is of today, so the
tagger is brought by reference, as an agent is.
"""

from collections.abc import Callable, Collection
from dataclasses import dataclass
from typing import Protocol, cast

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError
from uniteam.interface import Observation
from uniteam.mind.perception.detectors.detector import Detector, DetectorFactory, Found
from uniteam.registry import Family, Registry

NAME = "recognize-anything"


class Tagger(Protocol):
    """Says what is in a picture, not where."""

    def tags(self, rgb: NDArray[np.uint8], names: tuple[str, ...]) -> Collection[str]:
        """Return which of the names something in the (H, W, 3) frame bears; the same for the same frame."""


TaggerFactory = Callable[[], Tagger]


def _checked(name: str, value: object) -> TaggerFactory:
    if not callable(value):
        raise InvalidInputError(
            f"tagger '{name}' must be a class, or a function without arguments, that makes an object with "
            f"tags(rgb, names), got {type(value).__name__}"
        )
    return cast(TaggerFactory, value)


TAGGERS: Registry[TaggerFactory] = Registry("tagger", "uniteam.taggers", _checked)


@dataclass(frozen=True)
class Tagged:
    """A detector that is asked for what a tagger sees."""

    tagger: Tagger
    detector: Detector

    def detect(self, observation: Observation, names: tuple[str, ...]) -> list[Found]:
        """Return what the detector finds of the names that the tagger sees; nothing where it sees none."""
        tags = set(self.tagger.tags(observation.rgb, names))
        seen = tuple(name for name in names if name in tags)
        return list(self.detector.detect(observation, seen)) if seen else []


def tagged_of(argument: str, detector_of: Callable[[str], object]) -> DetectorFactory:
    """Return what makes perceptions of "TAGGER+DETECTOR".

    Args:
        argument: a reference to what makes a tagger, and the name of a detector, with its argument if it has one.
        detector_of: returns what makes perceptions of a name, and raises UniteamError where there is none.

    Raises:
        InvalidInputError: one of the two is missing, or what the second names is no detector.
    """
    tagger, plus, name = argument.partition("+")
    if not plus or not tagger or not name:
        raise InvalidInputError(
            f"perception '{NAME}' needs a tagger and a detector, got '{argument}'; give TAGGER+DETECTOR, such as "
            f"{NAME}:my_tagger:Tagger+owlv2"
        )
    make_tagger, factory = TAGGERS.get(tagger), detector_of(name)
    if not isinstance(factory, DetectorFactory):
        raise InvalidInputError(
            f"perception '{name}' cannot be asked for some names only; give a detector to {NAME}, such as owlv2"
        )
    return DetectorFactory(
        lambda: Tagged(_made(tagger, make_tagger), factory.load()),
        factory.libraries,
        (*factory.outside_modules, tagger.partition(":")[0]),
    )


def _made(name: str, make: TaggerFactory) -> Tagger:
    made = make()
    if not callable(getattr(made, "tags", None)):
        raise InvalidInputError(f"tagger '{name}' needs tags(rgb, names); {type(made).__name__} has none")
    return made


def recognize_anything(detector_of: Callable[[str], object]) -> Family[DetectorFactory]:
    """Return the family of perceptions; `detector_of` as in `tagged_of`."""
    return Family(
        "a detector that is asked only for what a tagger of yours sees",
        "TAGGER+DETECTOR",
        "my_tagger:Tagger+owlv2",
        lambda argument: tagged_of(argument, detector_of),
    )
