"""What counts as looked at."""

import math

import numpy as np
import pytest
from worlds.box_world import Box, observe

from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Instruction
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.perception.vocabulary import ClassRole, role_scores

CAMERA = PinholeCamera.from_horizontal_fov(240, 320, math.radians(42.0))
INSTRUCTION = Instruction("cup", "table", "bed")
BOARD = Box((1.5, 0.3, 0.0), (1.6, 0.9, 1.4))


def table(x: float, y: float) -> Box:
    return Box((x, y - 0.25, 0.0), (x + 0.5, y + 0.25, 0.7), "table")


def looked_share(boxes: tuple[Box, ...], *improvements: str) -> float:
    """Return the share of the table's cells that count as looked at after one look ahead, and one at it from afar."""
    bird_map = BirdsEyeMap(improved(BASELINE, ("exact_labels", *improvements)).map)
    for heading in (math.radians(30.0), 0.0):
        observation = observe(boxes, BasePose(0.0, 0.0, heading), CAMERA)
        assert observation.truth is not None
        bird_map.update(observation, observation.truth, role_scores(INSTRUCTION))
    cells = bird_map.class_cells(ClassRole.START_RECEPTACLE)
    assert cells.any()
    return float(np.mean(bird_map.looked_from[cells] > 0))


@pytest.mark.parametrize(
    ("boxes", "why"),
    [
        ((table(1.65, 0.0),), "too far away for its pixels to show a pen"),
        ((table(1.65, 0.6), BOARD), "hidden"),
    ],
)
def test_resolved_look_has_not_seen_what_the_baseline_takes_for_seen(boxes: tuple[Box, ...], why: str) -> None:
    assert looked_share(boxes) > 0.3, why
    assert looked_share(boxes, "resolved_look") < looked_share(boxes) / 2, why


def test_resolved_look_has_seen_what_is_near_and_in_the_picture() -> None:
    assert looked_share((table(0.75, 0.0),), "resolved_look") > 0.5


def test_what_the_robot_faces_counts_as_looked_at_though_its_pixels_do_not_show_it() -> None:
    bird_map = BirdsEyeMap(improved(BASELINE, ("exact_labels", "resolved_look")).map)
    boxes = table(0.9, 0.0), Box((0.8, -0.15, 0.7), (0.85, 0.15, 1.2))
    observation = observe(boxes, BasePose(0.0, 0.0, 0.0), CAMERA)
    assert observation.truth is not None
    bird_map.update(observation, observation.truth, role_scores(INSTRUCTION))
    cells = bird_map.class_cells(ClassRole.START_RECEPTACLE)
    seen = bird_map.looked_from[cells].copy()
    bird_map.mark_faced(BasePose(0.0, 0.0, math.pi))
    assert (bird_map.looked_from[cells] == seen).all(), "it faces away"
    bird_map.mark_faced(BasePose(0.0, 0.0, 0.0))
    assert np.count_nonzero(bird_map.looked_from[cells]) > np.count_nonzero(seen)
    assert not (bird_map.looked_from[cells] & 0b0001).any(), "the far side was not looked at"


@pytest.mark.parametrize(("distance", "counts"), [(0.45, True), (0.9, False)])
def test_last_round_looks_again_from_close_only(distance: float, counts: bool) -> None:
    bird_map = BirdsEyeMap(improved(BASELINE, ("exact_labels", "resolved_look", "last_round")).map)
    observation = observe((table(distance, 0.0),), BasePose(0.0, 0.0, 0.0), CAMERA)
    assert observation.truth is not None
    for _ in range(2):
        bird_map.forget_looks()
        bird_map.update(observation, observation.truth, role_scores(INSTRUCTION))
        cells = bird_map.class_cells(ClassRole.START_RECEPTACLE)
        assert bool((bird_map.looked_from[cells] > 0).any()) is counts
