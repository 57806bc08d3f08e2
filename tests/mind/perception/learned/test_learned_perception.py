"""Perception `learned` on rendered frames of a training home that it was not trained in."""

from dataclasses import replace

import numpy as np
import pytest

from uniteam.geometry import PinholeCamera
from uniteam.interface import Instruction, Observation
from uniteam.mind.perception.learned.eyes import Eyes
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


def test_eyes_that_have_just_seen_a_frame_say_of_each_what_new_ones_say(home: Home, views: list[View]) -> None:
    eyes = Eyes()
    first = observation_of(views[0], HEAD_CAMERA_HALF)
    raised = first.camera_to_start.copy()
    raised[2, 3] += 0.3
    darker, nearer = (first.rgb * 0.5).astype(np.uint8), first.depth * np.float32(0.8)
    others = (
        first,
        replace(first, step=first.step + 1),
        replace(first, rgb=darker),
        replace(first, depth=nearer),
        replace(first, camera_to_start=raised),
        replace(first, camera=replace(first.camera, fx=first.camera.fx * 1.1)),
        observation_of(views[5], HEAD_CAMERA_HALF),
    )
    for observation in others:
        eyes.look(first)
        seen, expected = eyes.look(observation), Eyes().look(observation)
        assert len(seen) == len(expected) > 0
        for one, other in zip(seen, expected, strict=True):
            assert np.array_equal(one.vector, other.vector) and one.junk == other.junk
            assert np.array_equal(one.region.mask, other.region.mask)


def test_eyes_see_anew_what_has_been_written_over(home: Home, views: list[View]) -> None:
    eyes, observation = Eyes(), observation_of(views[0], HEAD_CAMERA_HALF)
    observation = replace(observation, rgb=observation.rgb.copy())
    before = eyes.look(observation)
    observation.rgb[:] = 0
    after, expected = eyes.look(observation), Eyes().look(observation)
    assert [len(after), *(g.junk for g in after)] == [len(expected), *(g.junk for g in expected)]
    assert [g.junk for g in before] != [g.junk for g in after]
