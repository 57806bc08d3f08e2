"""A perception that breaks a promise is told which, and at which step."""

from typing import Any

import numpy as np
import pytest

from uniteam.interface import Detection, Instruction, Observation, Segmentation
from uniteam.testing import CheckFailedError, check_perception
from uniteam.testing.depth_bands import DepthBands

STEPS = 4
NOTHING = Segmentation(np.full((320, 240), -1, np.int16), ())


class Sound:
    """Sees one thing wherever it is near, and makes a little noise of its own."""

    def reset(self, instruction: Instruction, seed: int) -> None:
        self.name = instruction.object_category
        self.dice = np.random.default_rng(seed)

    def perceive(self, observation: Observation) -> Segmentation:
        return self.near(observation, 1.0 + self.dice.random())

    def near(self, observation: Observation, limit: float) -> Segmentation:
        embedding = np.ones(3, np.float32)
        instances = np.where(observation.depth < limit, 0, -1).astype(np.int16)
        return Segmentation(instances, (Detection(((self.name, 0.9), ("box", 0.1)), embedding),))


class Rememberer(Sound):
    """Sees less far the longer it lives."""

    def __init__(self) -> None:
        self.frames = 0

    def perceive(self, observation: Observation) -> Segmentation:
        self.frames += 1
        return self.near(observation, 5.0 / self.frames)


class GlobalDice(Sound):
    """Makes noise with the dice that belong to everybody."""

    def perceive(self, observation: Observation) -> Segmentation:
        return self.near(observation, 1.0 + float(np.random.random()))


class Painter(Sound):
    """Whitens the picture where it lies."""

    def perceive(self, observation: Observation) -> Segmentation:
        observation.rgb[:] = 255
        return NOTHING


class Peeker(Sound):
    """Returns the truth where it is there."""

    def perceive(self, observation: Observation) -> Segmentation:
        return NOTHING if observation.truth is None else observation.truth


class Thrifty(Sound):
    """Uses one array for all of its segmentations."""

    def __init__(self) -> None:
        self.instances = np.zeros((320, 240), np.int16)

    def perceive(self, observation: Observation) -> Segmentation:
        self.instances[:] = np.where(observation.depth < 1.0 + observation.step, 0, -1)
        return Segmentation(self.instances, (Detection((("cup", 1.0),)),))


class Half(Sound):
    """Answers with a quarter of the pixels."""

    def perceive(self, observation: Observation) -> Segmentation:
        return Segmentation(np.full((160, 120), -1, np.int16), ())


def seeing(answer: Any) -> type[Sound]:
    """Return a perception that always sees one thing."""

    class Stubborn(Sound):
        def perceive(self, observation: Observation) -> Segmentation:
            return answer

    return Stubborn


def detecting(*candidates: tuple[str, float], embedding: Any = None) -> type[Sound]:
    return seeing(Segmentation(NOTHING.instances, (Detection(candidates, embedding),)))


def test_a_sound_perception_passes() -> None:
    check_perception(Sound, steps=STEPS)


def test_the_stand_in_that_agents_see_with_passes_by_its_reference() -> None:
    check_perception(f"{DepthBands.__module__}:DepthBands", steps=STEPS)


@pytest.mark.parametrize(
    ("perception", "sentence"),
    [
        (Rememberer, r"perception 'Rememberer': what was played before leaks.*in segmentation\.instances"),
        (GlobalDice, r"two copies made alike.*in segmentation\.instances"),
        (Painter, r"perception 'Painter' wrote into observation\.rgb of step 0"),
        (Peeker, r"it reads observation\.truth, though it is not registered"),
        (Thrifty, r"segmentation\.instances, which perceive returned at step \d, was changed afterwards"),
        (Half, r"perceive at step 0 returned instances of \(160, 120\) for a frame of \(320, 240\)"),
        (seeing(None), "perceive at step 0 must return a Segmentation, but returned None"),
        (seeing(NOTHING.instances), "must return a Segmentation, but returned a ndarray"),
        (seeing(Segmentation(NOTHING.instances, [])), "detections in a list"),  # type: ignore[arg-type]
        (detecting(("", 1.0)), "a detection 0 with a candidate without a name"),
        (detecting(("cup", 0.1), ("mug", 0.9)), "put the best first"),
        (detecting(("cup", 1.0), embedding=np.ones(3)), r"embedding is \(3,\) float64; it must be \(D,\) float32"),
        (dict, "making it raised InvalidInputError: .*dict has no reset and no perceive"),
    ],
)
def test_a_perception_that_breaks_a_promise_is_told_which(perception: Any, sentence: str) -> None:
    with pytest.raises(CheckFailedError, match=sentence):
        check_perception(perception, steps=STEPS)
