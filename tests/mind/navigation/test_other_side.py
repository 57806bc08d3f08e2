"""The stands from which a thing is seen from another side."""

import math

import numpy as np
from worlds.box_world import Box, observe, room

from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Instruction
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import GoalKind
from uniteam.mind.navigation.goals.other_side import OtherSide
from uniteam.mind.perception.vocabulary import ClassRole, role_scores

CAMERA = PinholeCamera.from_horizontal_fov(120, 160, math.radians(60.0))
TARGET = (1.0, 0.0)
BED = Box((0.8, -0.2, 0.0), (1.2, 0.2, 0.5), "bed")


def map_of(boxes: tuple[Box, ...]) -> tuple[BirdsEyeMap, BasePose]:
    """Return what is seen by turning all around at the origin and a metre to both sides of it."""
    bird_map, roles = BirdsEyeMap(), role_scores(Instruction("cup", "table", "bed"))
    base = BasePose(0.0, 0.0, 0.0)
    for y in (-1.0, 1.0, 0.0):
        for turn in range(12):
            base = BasePose(0.0, y, turn * math.pi / 6)
            seen = observe(boxes, base, CAMERA)
            assert seen.truth is not None
            bird_map.update(seen, seen.truth, roles)
    return bird_map, base


def side_of(target: tuple[float, float], seen_from: tuple[float, float]) -> OtherSide:
    return OtherSide(GoalKind.GOAL_RECEPTACLE, ClassRole.GOAL_RECEPTACLE, target, seen_from)


def test_every_stand_is_free_near_by_and_well_to_the_side() -> None:
    bird_map, base = map_of((*room(-2.0, -2.5, 3.0, 2.5), BED))
    goal = side_of(TARGET, (0.0, 0.0))(bird_map, base)
    assert goal is not None and goal.kind is GoalKind.GOAL_RECEPTACLE
    stands = bird_map.points_of(goal.cells) - np.array(TARGET)
    assert len(stands) > 20
    distances, angles = np.hypot(*stands.T), np.abs(np.arctan2(stands[:, 1], -stands[:, 0]))
    assert distances.min() > 0.55 and distances.max() < 1.65
    assert np.degrees(angles.min()) > 47.0, "seen from the origin the bed lies ahead"
    assert not (goal.cells & bird_map.obstacle).any()
    assert goal.face is not None
    faced = bird_map.points_of(goal.face)
    assert (np.abs(faced - np.array(TARGET)) < 0.3).all()


def test_there_is_none_where_walls_leave_no_other_side() -> None:
    bird_map, base = map_of((*room(-2.0, -0.5, 1.3, 0.5), BED))
    assert side_of(TARGET, (0.0, 0.0))(bird_map, base) is None
