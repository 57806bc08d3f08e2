"""Taking back what the map holds."""

import math

import numpy as np
import pytest
from worlds.box_world import Box, observe, room

from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Instruction
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.perception.vocabulary import ClassRole, role_scores

CAMERA = PinholeCamera.from_horizontal_fov(120, 160, math.radians(42.0))
ROOM = room(-3.0, -3.0, 3.0, 3.0)
STOOL = Box((1.4, -0.2, 0.0), (1.8, 0.2, 0.5), "table")
CORNER = (1.42, 0.0)
HERE = BasePose(0.0, 0.0, 0.0)


def look(bird_map: BirdsEyeMap, *boxes: Box, times: int = 1) -> None:
    for _ in range(times):
        observation = observe((*ROOM, *boxes), HERE, CAMERA)
        assert observation.truth is not None
        bird_map.update(observation, observation.truth, role_scores(Instruction("cup", "table", "bed")))


@pytest.mark.parametrize(("improvements", "is_taken_back"), [((), False), (("clearing",), True)])
def test_clearing_takes_back_what_has_gone_and_the_baseline_keeps_it(
    improvements: tuple[str, ...], is_taken_back: bool
) -> None:
    bird_map = BirdsEyeMap(improved(BASELINE, improvements).map)
    look(bird_map, STOOL)
    cell = bird_map.to_cell(*CORNER)
    assert bird_map.obstacle[cell] and bird_map.class_cells(ClassRole.START_RECEPTACLE)[cell]
    look(bird_map, times=7)
    assert bird_map.obstacle[cell]
    look(bird_map)
    assert bool(bird_map.obstacle[cell]) is not is_taken_back
    assert bool(bird_map.class_cells(ClassRole.START_RECEPTACLE)[cell]) is not is_taken_back


def test_clearing_leaves_what_is_still_there_and_what_was_felt() -> None:
    bird_map = BirdsEyeMap(improved(BASELINE, {"clearing"}).map)
    look(bird_map, STOOL)
    bird_map.mark_felt(np.array([[1.2, 0.3]]))
    look(bird_map, STOOL, times=12)
    assert bird_map.obstacle[bird_map.to_cell(*CORNER)]
    assert bird_map.obstacle[bird_map.to_cell(1.2, 0.3)]
