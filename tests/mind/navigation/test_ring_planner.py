"""HomeRobot's planner: what makes the baseline get stuck, and what it does about it."""

import math

import numpy as np
from worlds.box_world import room
from worlds.driving import Drive

from uniteam.geometry import BasePose
from uniteam.grid import disc_mask
from uniteam.interface import DiscreteAction
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.navigation.goals.exploration import first_goal_or_frontier
from uniteam.mind.navigation.planning.planner import Planner
from uniteam.mind.navigation.planning.ring_planner import RingPlanner, best_on_ring

START = BasePose(0.0, 0.0, 0.0)
ROOM = room(-3.0, -3.0, 3.0, 3.0)


def begin(*names: str) -> tuple[Drive, RingPlanner]:
    drive = Drive.begin(ROOM, START)
    planner = RingPlanner(improved(BASELINE, names).planner)
    drive.planner = planner
    return drive, planner


def goal_at(drive: Drive, x: float, y: float) -> Goal:
    cells = disc_mask(drive.bird_map.shape, drive.bird_map.to_cell(x, y), 2)
    return Goal(GoalKind.GOAL_RECEPTACLE, cells, face=cells)


def shut_off(drive: Drive, x: float, gap_cells: int = 0) -> None:
    """Stand a wall across the room, with a gap so many cells wide on the robot's way."""
    row, column = drive.bird_map.to_cell(x, 0.0)
    drive.bird_map.obstacle[:, column] = True
    drive.bird_map.obstacle[row - gap_cells // 2 : row + (gap_cells + 1) // 2, column] = False


def test_the_short_term_goal_is_the_cell_of_least_cost_on_a_ring_of_five_cells() -> None:
    rows, columns = np.mgrid[0:21, 0:21]
    costs = (5 * np.hypot(rows - 10, columns - 30)).astype(np.int32)
    step, descends = best_on_ring(costs, (10, 10), 5)
    assert descends and step == (-2, 4)
    flat = np.full((21, 21), 7, dtype=np.int32)
    assert best_on_ring(flat, (10, 10), 5)[1] is False


def test_a_cell_behind_a_wall_is_no_step_however_near_the_goal_it_is() -> None:
    costs = np.full((21, 21), 400, dtype=np.int32)
    costs[10, 14] = 0
    costs[10, 5] = 380
    assert best_on_ring(costs, (10, 10), 5) == ((0, -5), True)


def test_the_robot_stops_half_a_metre_from_the_goal_and_faces_it_to_twenty_degrees() -> None:
    drive, planner = begin()
    goal = goal_at(drive, 0.5, 0.0)
    turned = [planner.plan(drive.bird_map, BasePose(0.0, 0.0, math.radians(a)), goal).action for a in (0, 20, 27)]
    assert turned == [None, None, DiscreteAction.TURN_RIGHT]
    farther = planner.plan(drive.bird_map, START, goal_at(drive, 0.75, 0.0))
    assert not farther.reached
    assert improved(BASELINE, ["straight_face"]).planner.face(math.radians(19)) is DiscreteAction.TURN_LEFT


def test_near_enough_stops_where_the_baseline_would_go_on() -> None:
    actions = []
    for names in ((), ("near_enough",)):
        drive, planner = begin(*names)
        actions.append(planner.plan(drive.bird_map, START, goal_at(drive, 0.65, 0.0)).action)
    assert actions[0] is not None and actions[1] is None


def test_without_a_path_the_dilation_shrinks_for_good_and_collisions_are_forgotten() -> None:
    drive, planner = begin()
    shut_off(drive, 0.6)
    drive.bird_map.mark_collision(np.array([[-1.0, 0.0]]))
    found = first_goal_or_frontier(
        planner, drive.bird_map, START, (lambda m, b: goal_at(drive, 2.0, 0.0),), GoalKind.FRONTIER
    )
    assert found is not None and not found[1].reachable
    planner.begin(found[1], drive.bird_map, START)
    assert planner.dilation == 2
    assert not drive.bird_map.collision.any()
    drive.look()
    for _ in range(3):
        planner.give_way(drive.bird_map)
    assert planner.dilation == 1
    drive.look()
    planner.give_way(drive.bird_map)
    assert planner.dilation == 1


def test_string_pulled_path_goes_through_a_narrow_gap_in_the_step_in_which_the_baseline_sees_none() -> None:
    drive, planner = begin()
    shut_off(drive, 0.6, gap_cells=5)
    goal = goal_at(drive, 2.0, 0.0)
    assert not planner.plan(drive.bird_map, START, goal).reachable
    config = improved(BASELINE, ["string_pulled_path"])
    exact = config.make_planner(config.planner)
    assert type(exact) is Planner
    assert exact.plan(drive.bird_map, START, goal).reachable


def test_where_there_is_no_path_to_the_goal_nor_to_a_frontier_the_robot_stops_where_it_stands() -> None:
    drive, planner = begin()
    shut_off(drive, 0.6)
    shut_off(drive, -0.6)
    behind = goal_at(drive, 2.0, 0.0)
    found = first_goal_or_frontier(
        planner, drive.bird_map, START, (lambda m, b: behind, lambda m, b: None), GoalKind.GOAL_RECEPTACLE
    )
    assert found is not None
    assert found[0].kind is GoalKind.GOAL_RECEPTACLE and found[1].action is None and found[1].reached


def test_collisions_that_shut_the_robot_in_are_forgotten_before_it_stops_where_it_stands() -> None:
    drive, planner = begin("collision_mapping")
    around = [(0.35 * math.cos(a), 0.35 * math.sin(a)) for a in np.arange(0.0, 2 * math.pi, 0.05)]
    drive.bird_map.mark_felt(np.array(around))
    drive.bird_map.mark_collision(np.array(around))
    goal = goal_at(drive, 2.0, 0.0)
    assert not planner.plan(drive.bird_map, START, goal).reachable
    found = first_goal_or_frontier(
        planner, drive.bird_map, START, (lambda m, b: goal, lambda m, b: None), GoalKind.GOAL_RECEPTACLE
    )
    assert found is not None and found[1].short_term_goal is not None and found[1].reachable
    assert not drive.bird_map.felt.any()


def test_a_planner_that_has_searched_before_plans_as_a_new_one_does() -> None:
    drive, planner = begin()
    shut_off(drive, 0.6, gap_cells=9)
    goals = goal_at(drive, 2.0, 0.0), goal_at(drive, 2.0, 1.0)
    bases = [BasePose(x, y, math.radians(30.0 * k)) for k, (x, y) in enumerate([(0, 0), (0, 0), (0.2, 0.1), (-0.4, 0)])]
    for goal in (*goals, goals[0]):
        for base in bases:
            plan, expected = (p.plan(drive.bird_map, base, goal) for p in (planner, RingPlanner(planner.config)))
            assert plan.action == expected.action and plan.distance == expected.distance > 1.0
            assert plan.short_term_goal == expected.short_term_goal
            assert np.array_equal(plan.path, expected.path)
    drive.bird_map.obstacle[:, drive.bird_map.to_cell(0.3, 0.0)[1]] = True
    assert not planner.plan(drive.bird_map, START, goals[0]).reachable
