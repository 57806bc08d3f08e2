"""Perception `learned` on rendered frames of a training home that it was not trained in."""

import numpy as np
import pytest

from uniteam.geometry import PinholeCamera
from uniteam.interface import Instruction, Observation
from uniteam.mind.perception.learned.learned_perception import LearnedPerception
from uniteam.mind.perception.registry import needs_truth
from uniteam.stretch import HEAD_CAMERA_FULL, HEAD_CAMERA_HALF
from uniteam.training.calibration import FIRST_HOME
from uniteam.training.sightings import observation_of
from uniteam.training.views import View, training_home, views_of
from uniteam.world.homes.home import Home


@pytest.fixture(scope="module")
def home() -> Home:
    return training_home(FIRST_HOME + 1)


@pytest.fixture(scope="module")
def views(home: Home) -> list[View]:
    return list(views_of(home, 16, np.random.default_rng(5), 0.0, 0.0))


def best_overlaps(home: Home, view: View, observation: Observation, instruction: Instruction) -> list[float]:
    """Return, for each detection of the start receptacle, its best overlap with one that is there."""
    perception = LearnedPerception()
    perception.reset(instruction, 0)
    seen = perception.perceive(observation)
    factor = observation.camera.height // HEAD_CAMERA_HALF.height
    instances = view.half.instances.repeat(factor, axis=0).repeat(factor, axis=1)
    overlaps: list[float] = []
    for index, detection in enumerate(seen.detections):
        if detection.name == instruction.start_receptacle and detection.score > 0.2:
            own = seen.instances == index
            truths = [instances == k for k, i in enumerate(home.instances) if i.category == detection.name]
            overlaps.append(max(np.count_nonzero(own & t) / np.count_nonzero(own | t) for t in truths))
    return overlaps


@pytest.mark.parametrize("camera", [HEAD_CAMERA_HALF, HEAD_CAMERA_FULL])
@pytest.mark.parametrize(("number", "name"), [(0, "bathtub"), (5, "bed")])
def test_it_finds_what_is_large(home: Home, views: list[View], number: int, name: str, camera: PinholeCamera) -> None:
    observation = observation_of(views[number], camera)
    assert max(best_overlaps(home, views[number], observation, Instruction("cup", name, "table")), default=0.0) > 0.6


def test_what_is_not_asked_for_is_not_named(views: list[View]) -> None:
    perception = LearnedPerception()
    perception.reset(Instruction("mug", "sofa", "dresser"), 0)
    names = {
        d.name for view in views[:6] for d in perception.perceive(observation_of(view, HEAD_CAMERA_HALF)).detections
    }
    assert names <= {"mug", "sofa", "dresser"}
    assert not needs_truth("learned")
