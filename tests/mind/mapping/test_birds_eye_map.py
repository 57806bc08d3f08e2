"""The bird's-eye-view map of exact pixels, on depth images cast in a world of boxes."""

import math
from dataclasses import replace

import numpy as np
import pytest
from worlds.box_world import CAMERA, Box, observe, room

from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Detection, Instruction, Observation, Segmentation
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.mapping.map_config import MapConfig
from uniteam.mind.mapping.projection import exact_pixels
from uniteam.mind.mapping.visited import mark_line
from uniteam.mind.perception.vocabulary import ClassRole, role_scores

EXACT = MapConfig(project=exact_pixels, mark_visited=mark_line)
START = BasePose(0.0, 0.0, 0.0)
ROLES = role_scores(Instruction("cup", "table", "bed"))
TABLE = Box((1.5, -0.5, 0.7), (2.3, 0.5, 0.75), "table")
CUP = Box((1.7, -0.05, 0.75), (1.8, 0.05, 0.85), "cup")


def look(bird_map: BirdsEyeMap, boxes: tuple[Box, ...], base: BasePose = START) -> None:
    observation = observe(boxes, base)
    assert observation.truth is not None
    bird_map.update(observation, observation.truth, ROLES)


def look_around(bird_map: BirdsEyeMap, boxes: tuple[Box, ...], x: float = 0.0, y: float = 0.0) -> None:
    for k in range(12):
        look(bird_map, boxes, BasePose(x, y, k * math.radians(30.0)))


def solid_within(bird_map: BirdsEyeMap, x0: float, y0: float, x1: float, y1: float) -> int:
    (r0, c0), (r1, c1) = bird_map.to_cell(x0, y0), bird_map.to_cell(x1, y1)
    return int(bird_map.obstacle[r0:r1, c0:c1].sum())


def test_a_floor_alone_is_explored_and_no_obstacle() -> None:
    bird_map = BirdsEyeMap(EXACT)
    look_around(bird_map, ())
    assert not bird_map.obstacle.any()
    assert bird_map.explored[bird_map.to_cell(2.0, 0.3)]
    assert not bird_map.explored[bird_map.to_cell(5.0, 0.3)]


def test_walls_are_thin_straight_lines_where_they_stand() -> None:
    bird_map = BirdsEyeMap(EXACT)
    look_around(bird_map, room(-2.0, -2.0, 2.0, 2.0))
    rows, columns = np.nonzero(bird_map.obstacle)
    away = np.maximum(*np.abs(bird_map.to_points(np.stack([rows, columns], 1))).T)
    assert (np.abs(away - 2.0) < 0.06).all()
    top = columns[rows == bird_map.to_cell(0.0, 2.01)[0]]
    assert len(np.unique(top)) >= 0.95 * 4.0 / bird_map.cell_size


def test_what_is_lower_than_ten_centimetres_or_above_the_robot_is_no_obstacle() -> None:
    bird_map = BirdsEyeMap(EXACT)
    look_around(bird_map, (Box((1.0, -0.5, 0.0), (2.0, 0.5, 0.08)), Box((1.0, -0.5, 1.45), (2.0, 0.5, 1.5))))
    assert not bird_map.obstacle.any()


def test_a_table_leaves_its_legroom_unblocked_but_its_top_is_an_obstacle() -> None:
    bird_map = BirdsEyeMap(EXACT)
    look_around(bird_map, (TABLE,))
    assert solid_within(bird_map, 1.5, -0.5, 2.3, 0.5) > 250
    assert solid_within(bird_map, 0.0, -2.0, 1.4, 2.0) == 0


def test_what_is_nearer_than_the_robots_own_radius_is_the_robot_itself() -> None:
    config = replace(EXACT, min_depth=0.1)
    arm = Box((0.05, -0.2, 0.8), (0.25, 0.2, 0.95))
    bird_map = BirdsEyeMap(config)
    look(bird_map, (arm,))
    assert not bird_map.obstacle.any()


def test_depth_beyond_the_range_is_not_mapped() -> None:
    bird_map = BirdsEyeMap(EXACT)
    look(bird_map, (Box((4.5, -1.0, 0.0), (4.6, 1.0, 1.0), "table"),))
    assert not bird_map.obstacle.any()
    assert not bird_map.class_cells(ClassRole.START_RECEPTACLE).any()


def test_classes_land_where_they_stand_with_their_height() -> None:
    bird_map = BirdsEyeMap(EXACT)
    look(bird_map, (TABLE, CUP))
    assert bird_map.class_cells(ClassRole.OBJECT)[bird_map.to_cell(1.72, 0.0)]
    assert bird_map.class_height(ClassRole.START_RECEPTACLE)[bird_map.to_cell(1.9, 0.3)] == pytest.approx(
        0.75, abs=0.01
    )
    assert not bird_map.class_cells(ClassRole.GOAL_RECEPTACLE).any()


def test_an_object_counts_as_on_the_start_receptacle_only_where_both_are() -> None:
    on_table, on_floor = BirdsEyeMap(EXACT), BirdsEyeMap(EXACT)
    look(on_table, (TABLE, CUP))
    look(on_floor, (TABLE, Box((1.2, 0.9, 0.0), (1.3, 1.0, 0.1), "cup")), BasePose(0.0, 0.0, 0.5))
    assert on_table.object_on_start_receptacle(play=1).any()
    assert on_floor.class_cells(ClassRole.OBJECT).any()
    assert not on_floor.object_on_start_receptacle(play=1).any()


def test_one_class_may_be_start_and_goal_receptacle() -> None:
    bird_map = BirdsEyeMap(EXACT)
    observation = observe((TABLE,), BasePose(0.0, 0.0, 0.0))
    assert observation.truth is not None
    bird_map.update(observation, observation.truth, role_scores(Instruction("cup", "table", "table")))
    start, goal = (bird_map.class_cells(r) for r in (ClassRole.START_RECEPTACLE, ClassRole.GOAL_RECEPTACLE))
    assert start.any()
    assert (start == goal).all()


def test_probability_follows_the_scores_and_fades_when_the_class_is_gone() -> None:
    bird_map = BirdsEyeMap(EXACT)
    sure = Box(TABLE.low, TABLE.high, "table", 0.9)
    unsure = Box(TABLE.low, TABLE.high, "table", 0.5)
    nameless = Box(TABLE.low, TABLE.high)
    cell = bird_map.to_cell(1.9, 0.3)
    probability = bird_map.class_probability(ClassRole.START_RECEPTACLE)
    look(bird_map, (sure,))
    assert probability[cell] == pytest.approx(0.9)
    look(bird_map, (unsure,))
    assert probability[cell] == pytest.approx(0.9 + 0.3 * (0.5 - 0.9))
    before = float(probability[cell])
    for _ in range(10):
        look(bird_map, (nameless,))
    assert probability[cell] == pytest.approx(before * 0.95**10, rel=1e-4)
    assert bird_map.class_cells(ClassRole.START_RECEPTACLE)[cell]


def test_the_robot_leaves_a_trail_and_has_been_close_to_a_metre_around() -> None:
    bird_map = BirdsEyeMap(EXACT)
    look(bird_map, ())
    look(bird_map, (), BasePose(1.0, 0.0, 0.0))
    assert all(bird_map.visited[bird_map.to_cell(x, 0.0)] for x in np.linspace(0.0, 1.0, 21))
    assert bird_map.visited.sum() == 21
    assert bird_map.been_close[bird_map.to_cell(1.9, 0.0)]
    assert not bird_map.been_close[bird_map.to_cell(2.1, 0.0)]


def test_the_map_grows_and_keeps_what_it_knew() -> None:
    bird_map = BirdsEyeMap(replace(EXACT, initial_size=8.0))
    look(bird_map, (TABLE, CUP))
    x, y = bird_map.points_of(bird_map.class_cells(ClassRole.OBJECT))[0]
    look(bird_map, (TABLE, CUP), BasePose(-9.0, -7.0, math.pi))
    assert bird_map.shape[0] > 160
    assert bird_map.shape[1] > 160
    assert bird_map.class_cells(ClassRole.OBJECT)[bird_map.to_cell(x, y)]
    assert bird_map.visited[bird_map.to_cell(-9.0, -7.0)]
    assert bird_map.explored[bird_map.to_cell(-11.0, -7.0)]


def test_full_and_half_resolution_agree() -> None:
    boxes = (*room(-2.0, -2.0, 2.5, 2.0), TABLE, CUP)
    maps = []
    for camera in (CAMERA, PinholeCamera.from_horizontal_fov(480, 640, math.radians(42.0))):
        bird_map = BirdsEyeMap(EXACT)
        observation = observe(boxes, BasePose(0.0, 0.0, 0.3), camera)
        assert observation.truth is not None
        bird_map.update(observation, observation.truth, ROLES)
        maps.append(bird_map)
    half, full = maps
    assert (half.obstacle ^ full.obstacle).sum() <= 0.05 * full.obstacle.sum()


def test_nothing_detected_is_nothing_mapped() -> None:
    bird_map = BirdsEyeMap(EXACT)
    observation: Observation = observe((TABLE,), BasePose(0.0, 0.0, 0.0))
    nothing = Segmentation(np.full((320, 240), -1, dtype=np.int16), ())
    stranger = Segmentation(np.zeros((320, 240), dtype=np.int16), (Detection((("ghost", 0.9),)),))
    bird_map.update(observation, nothing, ROLES)
    bird_map.update(observation, stranger, ROLES)
    assert not any(bird_map.class_cells(role).any() for role in ClassRole)
