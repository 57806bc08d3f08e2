"""HomeRobot's projection of averaged blocks, on depth images cast in a world of boxes, beside that of exact pixels."""

import math

import numpy as np
import pytest
from worlds.box_world import Box, observe, room
from worlds.filled import filled

from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Instruction
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.perception.vocabulary import ClassRole, role_scores

ROLES = role_scores(Instruction("cup", "table", "bed"))
BASELINE_MAP = BASELINE.map
EXACT_MAP = improved(BASELINE, ["exact_labels"]).map


def seen(boxes: tuple[Box, ...], *bases: BasePose, config: object = BASELINE_MAP) -> BirdsEyeMap:
    bird_map = BirdsEyeMap(config)  # type: ignore[arg-type]
    for base in filled(bases):
        observation = observe(boxes, base)
        assert observation.truth is not None
        bird_map.update(observation, observation.truth, ROLES)
    return bird_map


def points(bird_map: BirdsEyeMap, cells: np.ndarray) -> np.ndarray:
    return bird_map.points_of(cells)


def test_walls_stand_where_they_are_and_are_thicker_than_by_exact_pixels() -> None:
    turns = [BasePose(0.0, 0.0, k * math.radians(30.0)) for k in range(12)]
    walls = room(-2.0, -2.0, 2.0, 2.0)
    blurred, exact = (seen(walls, *turns, config=config) for config in (BASELINE_MAP, EXACT_MAP))
    away = np.abs(points(blurred, blurred.obstacle)).max(axis=1)
    assert (np.abs(away - 2.0) < 0.2).all()
    assert blurred.obstacle.sum() > 1.5 * exact.obstacle.sum()


def test_a_receptacle_behind_a_door_frame_paints_the_frame_unless_exact_labels_is_switched_on() -> None:
    """The frame's edge runs through blocks of pixels: each takes the depth of its left half, and half a label."""
    frame, bed = Box((1.5, 0.1, 0.0), (1.6, 1.5, 2.5)), Box((2.6, -1.0, 0.0), (3.2, 1.0, 0.5), "bed")
    bases = [BasePose(0.0, y, 0.0) for y in np.arange(-0.3, 0.3, 0.02)]
    ghosts = []
    for config in (BASELINE_MAP, EXACT_MAP):
        bird_map = seen((frame, bed), *bases, config=config)
        goal = points(bird_map, bird_map.class_cells(ClassRole.GOAL_RECEPTACLE))
        ghosts.append(int((goal[:, 0] < 1.9).sum()))
    assert ghosts[0] > 0
    assert ghosts[1] == 0


@pytest.mark.parametrize(("top", "is_obstacle"), [(0.03, False), (0.2, True)])
def test_obstacles_begin_ten_centimetres_above_the_floor(top: float, is_obstacle: bool) -> None:
    bird_map = seen((Box((1.2, -0.5, 0.0), (2.0, 0.5, top)),), BasePose(0.0, 0.0, 0.0))
    assert bool(bird_map.obstacle.any()) is is_obstacle


def test_the_picture_s_size_changes_little() -> None:
    boxes = (*room(-2.0, -2.0, 2.5, 2.0), Box((1.5, -0.5, 0.0), (2.0, 0.5, 0.7), "bed"))
    maps = []
    for size in ((240, 320), (480, 640)):
        bird_map = BirdsEyeMap(BASELINE_MAP)
        observation = observe(
            boxes, BasePose(0.0, 0.0, 0.3), PinholeCamera.from_horizontal_fov(*size, math.radians(42))
        )
        assert observation.truth is not None
        bird_map.update(observation, observation.truth, ROLES)
        maps.append(bird_map)
    half, full = maps
    assert (half.obstacle ^ full.obstacle).sum() <= 0.15 * full.obstacle.sum()


def test_the_probability_of_a_cell_is_the_score_of_what_was_seen_there() -> None:
    unsure = Box((1.5, 0.2, 0.0), (2.0, 0.6, 0.5), "bed", 0.5)
    certain = Box((1.5, -0.6, 0.0), (2.0, -0.2, 0.5), "bed", 0.9)
    bird_map = seen((unsure, certain), BasePose(0.0, 0.0, 0.0))
    probability = bird_map.class_probability(ClassRole.GOAL_RECEPTACLE)
    assert probability[bird_map.to_cell(1.7, 0.4)] == pytest.approx(0.5)
    assert probability[bird_map.to_cell(1.7, -0.4)] == pytest.approx(0.9)


def test_only_driven_line_marks_the_cells_between_two_steps() -> None:
    counts = []
    for names in ([], ["driven_line"]):
        bird_map = seen((), BasePose(0.0, 0.0, 0.0), BasePose(1.0, 0.0, 0.0), config=improved(BASELINE, names).map)
        counts.append(int(bird_map.visited.sum()))
    assert counts == [2, 21]
