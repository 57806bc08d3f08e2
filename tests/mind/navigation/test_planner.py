"""Planning and exploring, driven in a world of boxes by what the robot sees."""

import copy
import math
from dataclasses import replace

import numpy as np
import pytest
from worlds.box_world import Box, clearance, room
from worlds.driving import EXACT_PLANNER, Drive, arrived

from uniteam.geometry import BasePose
from uniteam.grid import disc_mask
from uniteam.interface import DiscreteAction, MapLabel
from uniteam.mind.agents.map_overlay import draw_overlay
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.navigation.goals.exploration import (
    SearchConfig,
    any_frontier,
    any_goal_receptacle,
    object_beside_start_receptacle,
    start_receptacle_not_been_close,
)
from uniteam.mind.navigation.goals.frontier import FrontierConfig, find_frontiers
from uniteam.mind.navigation.goals.object_elsewhere import ObjectElsewhere
from uniteam.mind.navigation.planning.planner import Planner
from uniteam.mind.navigation.planning.planner_config import turn_in_steps
from uniteam.mind.navigation.planning.traversible import traversible
from uniteam.mind.navigation.planning.true_radius import true_radius
from uniteam.mind.navigation.window import window_around

START = BasePose(0.0, 0.0, 0.0)
SEARCH = SearchConfig(object=object_beside_start_receptacle, frontier=any_frontier)


def wall(x0: float, y0: float, x1: float, y1: float) -> Box:
    return Box((x0, y0, 0.0), (x1, y1, 2.5))


TWO_ROOMS = (*room(-2.0, -2.0, 7.0, 2.0), wall(2.5, -2.0, 2.6, -0.2), wall(2.5, 0.7, 2.6, 2.0))
"""Two rooms and a door 0.9 m wide."""
BED = Box((6.0, -1.5, 0.0), (6.9, 0.5, 0.5), "bed")
TABLE = Box((5.0, 1.2, 0.7), (6.0, 1.9, 0.75), "table")
CUP = Box((5.4, 1.3, 0.75), (5.5, 1.4, 0.85), "cup")
TABLE_TAKEN_FOR_A_DESK = replace(TABLE, name="desk")


def goal_at(bird_map: BirdsEyeMap, x: float, y: float, distance: float = 0.5) -> Goal:
    cells = disc_mask(bird_map.shape, bird_map.to_cell(x, y), 2)
    return Goal(GoalKind.GOAL_RECEPTACLE, cells, distance, face=cells)


def test_a_goal_ahead_is_driven_to_and_one_behind_turned_to() -> None:
    drive = Drive.begin(room(-3.0, -3.0, 3.0, 3.0), START)
    ahead = drive.planner.plan(drive.bird_map, START, goal_at(drive.bird_map, 2.0, 0.0))
    left = drive.planner.plan(drive.bird_map, START, goal_at(drive.bird_map, 0.0, 2.0))
    right = drive.planner.plan(drive.bird_map, START, goal_at(drive.bird_map, 0.0, -2.0))
    assert ahead.action is DiscreteAction.MOVE_FORWARD
    assert left.action is DiscreteAction.TURN_LEFT
    assert right.action is DiscreteAction.TURN_RIGHT
    assert ahead.distance == pytest.approx(1.4, abs=0.06)
    assert ahead.short_term_goal == pytest.approx((0.25, 0.0), abs=0.06)


def test_at_the_goal_the_robot_faces_it_and_has_then_arrived() -> None:
    drive = Drive.begin(room(-3.0, -3.0, 3.0, 3.0), START)
    goal = goal_at(drive.bird_map, 0.0, 0.5)
    turning = drive.planner.plan(drive.bird_map, START, goal)
    facing = drive.planner.plan(drive.bird_map, BasePose(0.0, 0.0, math.pi / 2), goal)
    assert (turning.action, turning.reached) == (DiscreteAction.TURN_LEFT, False)
    assert (facing.action, facing.reached) == (None, True)


def test_the_robot_finds_the_object_through_a_door_and_stands_before_it() -> None:
    drive = Drive.begin((*TWO_ROOMS, BED, TABLE, CUP), START)
    found = drive.run(SEARCH.for_object(), 250, arrived)
    assert found is not None
    assert found[0].kind is GoalKind.OBJECT
    assert math.hypot(5.45 - drive.base.x, 1.35 - drive.base.y) < 0.9
    assert abs(drive.base.bearing_to(5.45, 1.35)) < math.radians(25.0)
    assert clearance(drive.boxes, drive.base) >= 0.3


def test_an_object_on_what_is_taken_for_something_else_is_headed_for_late_and_only_where_it_is_probable() -> None:
    search, doubted = replace(SEARCH, object_elsewhere=ObjectElsewhere(after=40)), replace(CUP, score=0.3)
    headed: dict[float, list[int]] = {}
    for cup in (CUP, doubted):
        boxes = (*room(-2.0, -2.0, 7.0, 2.0), TABLE_TAKEN_FOR_A_DESK, cup)
        drive = Drive.begin(boxes, BasePose(3.5, 0.0, 0.0))
        steps = [(drive.bird_map.update_count, drive.step(search.for_object())) for _ in range(50)]
        headed[cup.score] = [count for count, step in steps if step and step[0].kind is GoalKind.OBJECT]
    assert headed[1.0][0] == 40
    assert headed[0.3] == []


def test_a_door_of_ninety_centimetres_is_passable_at_three_cells() -> None:
    drive = Drive.begin((*TWO_ROOMS, BED), START)
    window = window_around(drive.bird_map, drive.base)
    robot = window.inside(drive.bird_map.to_cell(0.0, 0.0))
    free = window.paste(traversible(drive.bird_map, window, robot, 3), drive.bird_map.shape)
    row, column = drive.bird_map.to_cell(2.55, 0.25)
    assert free[row - 3 : row + 4, column].all()
    assert not free[row - 8, column]


def test_exploration_sees_every_corner_and_then_has_nothing_left() -> None:
    drive = Drive.begin((*TWO_ROOMS, BED), START)
    assert drive.run((any_frontier,), 300) is None
    seen = [drive.bird_map.explored[drive.bird_map.to_cell(x, y)] for x in (-1.8, 0.5, 3.0, 5.5) for y in (-1.7, 1.7)]
    assert all(seen)


def test_frontiers_are_where_the_view_ends_and_not_behind_walls() -> None:
    closed = Drive.begin(room(-2.0, -2.0, 2.0, 2.0), START)
    assert not find_frontiers(closed.bird_map, START, FrontierConfig()).any()
    door = Drive.begin(TWO_ROOMS, START)
    points = door.bird_map.points_of(find_frontiers(door.bird_map, START, FrontierConfig()))
    assert len(points)
    assert (points[:, 0] > 2.4).all()


def test_the_goal_receptacle_comes_before_frontiers_once_it_is_known() -> None:
    drive = Drive.begin((*TWO_ROOMS, BED), START)
    first = drive.step(SEARCH.for_receptacle())
    assert first is not None
    assert first[0].kind is GoalKind.FRONTIER
    found = drive.run(SEARCH.for_receptacle(), 200, arrived)
    assert found is not None
    assert found[0].kind is GoalKind.GOAL_RECEPTACLE
    assert drive.base.x > 4.8


def test_a_receptacle_the_robot_has_been_close_to_is_no_longer_explored() -> None:
    drive = Drive.begin((*room(-3.0, -3.0, 3.0, 3.0), Box((1.2, -0.3, 0.7), (1.8, 0.3, 0.75), "table")), START)
    goal = start_receptacle_not_been_close(drive.bird_map, drive.base)
    assert goal is not None
    drive.run((start_receptacle_not_been_close,), 60)
    assert start_receptacle_not_been_close(drive.bird_map, drive.base) is None


def test_what_cannot_be_reached_is_approached_and_said_to_be_out_of_reach() -> None:
    boxes = (*room(-2.0, -2.0, 5.0, 2.0), wall(2.0, -2.0, 2.1, 2.0))
    drive = Drive.begin(boxes, START)
    cells = disc_mask(drive.bird_map.shape, drive.bird_map.to_cell(3.5, 0.0), 2)
    goal = Goal(GoalKind.GOAL_RECEPTACLE, cells, face=cells)
    drive.bird_map.obstacle[:, drive.bird_map.to_cell(2.05, 0.0)[1]] = True
    plan = drive.planner.plan(drive.bird_map, drive.base, goal)
    assert not plan.reachable
    assert plan.path[-1] == pytest.approx((1.8, 0.0), abs=0.15)


def test_dilation_shrinks_where_there_is_no_other_way() -> None:
    slit = (*room(-2.0, -2.0, 5.0, 2.0), wall(2.0, -2.0, 2.1, -0.1), wall(2.0, 0.1, 2.1, 2.0))
    drive = Drive.begin(slit, START)
    drive.bird_map.obstacle[:, drive.bird_map.to_cell(2.05, 0.0)[1]] = True
    row, column = drive.bird_map.to_cell(2.05, 0.0)
    drive.bird_map.obstacle[row - 2 : row + 2, column - 1 : column + 2] = False
    plan = drive.planner.plan(drive.bird_map, drive.base, goal_at(drive.bird_map, 3.5, 0.0))
    assert plan.reachable
    assert plan.distance < 4.0


def test_a_blocked_forward_motion_leaves_a_patch_of_collision_ahead() -> None:
    drive = Drive.begin(room(-3.0, -3.0, 3.0, 3.0), START)
    plan = drive.planner.plan(drive.bird_map, drive.base, goal_at(drive.bird_map, 2.0, 0.0))
    assert plan.action is DiscreteAction.MOVE_FORWARD
    drive.planner.begin(plan, drive.bird_map, drive.base)
    assert not drive.bird_map.collision.any()
    drive.look()
    for _ in range(2):
        drive.planner.notice(drive.bird_map, drive.base)
    points = drive.bird_map.points_of(drive.bird_map.collision)
    assert drive.planner.blocked_in_a_row == 1
    assert np.hypot(points[:, 0], points[:, 1]) == pytest.approx(0.22, abs=0.08)


def test_planning_changes_neither_the_map_nor_the_planner() -> None:
    drive = Drive.begin(room(-3.0, -3.0, 3.0, 3.0), START)
    goal = goal_at(drive.bird_map, 2.0, 0.0)
    drive.bird_map.mark_collision(np.array([[0.8, y] for y in np.arange(-12.0, 12.0, 0.05)]))
    before, marked = copy.deepcopy(vars(drive.planner)), drive.bird_map.collision.copy()
    first, second = (drive.planner.plan(drive.bird_map, drive.base, goal) for _ in range(2))
    assert first.is_daring and second.is_daring
    assert (first.path == second.path).all()
    assert vars(drive.planner) == before
    assert (drive.bird_map.collision == marked).all()
    drive.planner.begin(first, drive.bird_map, drive.base)
    assert not drive.bird_map.collision.any()


def test_a_motion_of_somebody_else_is_no_collision() -> None:
    drive = Drive.begin(room(-3.0, -3.0, 3.0, 3.0), START)
    plan = drive.planner.plan(drive.bird_map, drive.base, goal_at(drive.bird_map, 2.0, 0.0))
    drive.planner.begin(plan, drive.bird_map, drive.base)
    drive.planner.interrupt()
    drive.look()
    drive.planner.notice(drive.bird_map, drive.base)
    assert not drive.bird_map.collision.any()


def test_turns_come_in_thirty_degrees() -> None:
    assert turn_in_steps(math.radians(14.0)) is None
    assert turn_in_steps(math.radians(-16.0)) is DiscreteAction.TURN_RIGHT
    assert turn_in_steps(math.radians(16.0)) is DiscreteAction.TURN_LEFT


def test_nothing_to_head_for_is_none() -> None:
    assert any_goal_receptacle(BirdsEyeMap(), START) is None
    assert any_frontier(BirdsEyeMap(), START) is None


def test_the_overlay_shows_walls_path_and_goal_where_they_are() -> None:
    drive = Drive.begin((*TWO_ROOMS, BED), START)
    goal = goal_at(drive.bird_map, 2.0, 1.0)
    plan = Planner(EXACT_PLANNER).plan(drive.bird_map, drive.base, goal)
    overlay = draw_overlay(drive.bird_map, drive.base, goal, plan)

    def label(x: float, y: float) -> int:
        return int(overlay.labels[int((y - overlay.origin[1]) / 0.05), int((x - overlay.origin[0]) / 0.05)])

    assert label(1.0, 0.02) == MapLabel.FREE
    assert label(0.02, 0.02) == MapLabel.VISITED
    assert MapLabel.OBSTACLE in (label(2.02, -2.02), label(2.02, -1.98))
    assert label(-2.8, 0.0) == MapLabel.UNKNOWN
    assert overlay.path[0] == pytest.approx((0.0, 0.0), abs=0.05)
    assert len(overlay.goal) == goal.cells.sum()


def test_true_radius_keeps_a_wider_berth_than_the_baseline_where_there_is_room_and_none_where_there_is_not() -> None:
    careful = replace(EXACT_PLANNER, dilations=true_radius(0.05))
    post = wall(1.2, -0.1, 1.4, 0.1)
    berths = []
    for config in (EXACT_PLANNER, careful):
        drive = Drive.begin((*room(-3.0, -3.0, 4.0, 3.0), post), START, config)
        plan = drive.planner.plan(drive.bird_map, drive.base, goal_at(drive.bird_map, 3.0, 0.0))
        berths.append(min(clearance((post,), BasePose(x, y, 0.0)) for x, y in plan.path))
    assert berths[0] < 0.25
    assert berths[1] > 0.28
    assert true_radius(0.05) == (6, 5)
    assert true_radius(0.1) == (3, 2)
