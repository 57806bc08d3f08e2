"""UniTeam's navigation strategies: each in a situation that the baseline's value does not master."""

import math
from dataclasses import replace

import numpy as np
import pytest
from worlds.box_world import Box, observe, room
from worlds.driving import EXACT_PLANNER, INSTRUCTION, Drive, arrived

from uniteam.geometry import BasePose
from uniteam.grid import disc_mask
from uniteam.interface import DiscreteAction
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.navigation.goals.exploration import (
    ChooseGoal,
    SearchConfig,
    any_frontier,
    any_goal_receptacle,
    plan_first,
)
from uniteam.mind.navigation.goals.goal_or_frontier import Commitment, never_stuck
from uniteam.mind.navigation.goals.receptacle_probability import find_receptacles
from uniteam.mind.navigation.planning.collision_mapping import (
    COLLISION_MAPPING,
    BlockedMotion,
    before_the_rim,
)
from uniteam.mind.navigation.planning.planner_config import PlannerConfig
from uniteam.mind.navigation.planning.ring_planner import RingPlanner
from uniteam.mind.navigation.planning.traversible import connected_to, traversible
from uniteam.mind.navigation.window import window_around
from uniteam.mind.perception.vocabulary import ClassRole, role_scores

START = BasePose(0.0, 0.0, 0.0)
SEARCH = SearchConfig(frontier=any_frontier)
SWITCHED = improved(BASELINE, ["centre_approach", "receptacle_probability", "surround_start_receptacle"]).search
PROBABLE, SURROUND = improved(BASELINE, ["receptacle_probability"]).search.goal_receptacle, SWITCHED.start_receptacle
STUCK = improved(BASELINE, ["goal_or_frontier"]).is_stuck
ROOM = room(-3.0, -3.0, 3.0, 3.0)


def bed(x0: float, y0: float, x1: float, y1: float, score: float = 1.0) -> Box:
    return Box((x0, y0, 0.0), (x1, y1, 0.5), "bed", score)


# --- receptacle_probability


def test_the_more_probable_receptacle_is_chosen_over_the_nearer_one() -> None:
    boxes = (*ROOM, bed(1.0, -0.3, 1.6, 0.3, 0.5), bed(-2.8, -1.0, -2.2, 1.0, 0.95))
    drive = Drive.begin(boxes, START)
    nearest, probable = (
        drive.planner.plan(drive.bird_map, drive.base, goal)
        for goal in (choose(drive.bird_map, START) for choose in (BASELINE.search.goal_receptacle, PROBABLE))
        if goal is not None
    )
    assert nearest.path[-1][0] > 0.3
    assert probable.path[-1][0] < -1.5


def test_among_equals_the_nearest_receptacle_is_chosen() -> None:
    drive = Drive.begin((*ROOM, bed(1.0, -0.3, 1.6, 0.3, 0.93), bed(-2.8, -1.0, -2.2, 1.0, 0.95)), START)
    goal = PROBABLE(drive.bird_map, drive.base)
    assert goal is not None
    assert (drive.bird_map.points_of(goal.cells)[:, 0] > 0.9).all()


def test_a_probable_receptacle_that_cannot_be_reached_is_passed_over() -> None:
    drive = Drive.begin((*ROOM, bed(1.0, -0.3, 1.6, 0.3, 0.6), bed(-2.8, -1.0, -2.2, 1.0, 0.95)), START)
    drive.bird_map.obstacle[:, drive.bird_map.to_cell(-1.2, 0.0)[1]] = True
    goal = PROBABLE(drive.bird_map, drive.base)
    assert goal is not None
    assert (drive.bird_map.points_of(goal.cells)[:, 0] > 0.9).all()
    window = window_around(drive.bird_map, START)
    robot = window.inside(drive.bird_map.to_cell(0.0, 0.0))
    known = connected_to(robot, traversible(drive.bird_map, window, robot, dilation=3))
    receptacles = find_receptacles(drive.bird_map, window, known, reach=0.75)
    assert sorted(bool(receptacle.stands.any()) for receptacle in receptacles) == [False, True]


# --- early_goal_memory


@pytest.mark.parametrize(("names", "goes_to_the_probable_one"), [((), False), (("early_goal_memory",), True)])
def test_a_probable_receptacle_seen_before_the_pick_stays_a_candidate_with_early_goal_memory(
    names: tuple[str, ...], goes_to_the_probable_one: bool
) -> None:
    """Both beds are seen on the way to the object, and only the nearer and less probable one again after the pick."""
    search = improved(BASELINE, ("receptacle_probability", *names)).search
    drive = Drive.begin((*ROOM, bed(1.0, -0.3, 1.6, 0.3, 0.5), bed(-2.8, -1.0, -2.2, 1.0, 0.95)), START)
    search.recall(drive.bird_map)
    drive.look()
    goal = search.goal_receptacle(drive.bird_map, drive.base)
    assert goal is not None
    assert bool((drive.bird_map.points_of(goal.cells)[:, 0] < -2.0).all()) is goes_to_the_probable_one


def test_the_baseline_remembers_where_a_goal_receptacle_is_that_it_saw_before_the_pick() -> None:
    drive = Drive.begin((*ROOM, bed(-2.8, -1.0, -2.0, 1.0)), START)
    BASELINE.search.recall(drive.bird_map)
    drive.boxes = ROOM
    drive.run((any_frontier,), 10)
    assert any_goal_receptacle(drive.bird_map, drive.base) is not None


# --- far_sight


def test_far_sight_maps_a_goal_receptacle_that_the_baseline_does_not_see_so_far_away() -> None:
    boxes = (*room(-3.0, -3.0, 8.0, 3.0), bed(6.5, -1.0, 7.5, 1.0))
    baseline, far = (
        Drive.begin(boxes, START, map_config=improved(BASELINE, ("exact_labels", *names)).map)
        for names in ((), ("far_sight",))
    )
    first, found = baseline.step(SEARCH.for_receptacle()), far.step(SEARCH.for_receptacle())
    assert first is not None and found is not None
    assert first[0].kind is GoalKind.FRONTIER
    goal, plan = found
    assert goal.kind is GoalKind.GOAL_RECEPTACLE
    assert plan.path[-1][0] > 5.5
    assert not far.bird_map.obstacle[far.bird_map.to_cell(6.52, 0.0)]


# --- collision_mapping

GLASS = Box((1.2, -0.6, 0.0), (1.25, 0.6, 0.09))
"""Too low for the map, high enough to block the robot."""


def test_collision_mapping_writes_an_obstacle_at_the_last_short_term_goal_where_the_baseline_writes_none() -> None:
    for names in ((), ("collision_mapping",)):
        drive = Drive.begin(ROOM, START)
        drive.planner = RingPlanner(improved(BASELINE, names).planner)
        cells = disc_mask(drive.bird_map.shape, drive.bird_map.to_cell(2.0, 0.45), 2)
        goal = Goal(GoalKind.GOAL_RECEPTACLE, cells, face=cells)
        plan = drive.planner.plan(drive.bird_map, START, goal)
        assert plan.action is DiscreteAction.MOVE_FORWARD and plan.short_term_goal is not None
        before = drive.bird_map.obstacle.copy()
        drive.planner.begin(plan, drive.bird_map, START)
        drive.look()
        drive.planner.notice(drive.bird_map, START)
        written = drive.bird_map.obstacle & ~before
        where = np.zeros_like(written)
        where[drive.bird_map.to_cell(*plan.short_term_goal)] = bool(names)
        assert abs(plan.short_term_goal[1]) > 0.04
        assert (written == where).all()


@pytest.mark.parametrize(("names", "tries_again"), [((), True), (("collision_mapping",), False)])
def test_a_passage_that_proved_too_narrow_is_not_tried_again(names: tuple[str, ...], tries_again: bool) -> None:
    config = improved(BASELINE, names)
    collisions = config.planner.collisions
    drive = Drive.begin(ROOM, START)
    drive.planner = config.make_planner(config.planner)
    shut = drive.bird_map.to_cell(0.6, 0.0)
    drive.bird_map.obstacle[:, shut[1]] = True
    drive.bird_map.obstacle[shut[0] - 3 : shut[0] + 4, shut[1]] = False
    cells = disc_mask(drive.bird_map.shape, drive.bird_map.to_cell(2.4, 0.0), 2)
    goal = Goal(GoalKind.GOAL_RECEPTACLE, cells, face=cells)
    assert drive.planner.plan(drive.bird_map, drive.base, goal).reachable
    for k in range(4):
        motion = BlockedMotion(BasePose(0.35, 0.0, 0.0), (0.6, 0.1 * (k % 3 - 1)), k + 1)
        collisions.write(drive.bird_map, motion, config.planner.felt_at)
    for _ in range(4):
        plan = drive.planner.plan(drive.bird_map, drive.base, goal)
        drive.planner.begin(plan, drive.bird_map, drive.base)
        drive.look()
    assert plan.reachable is tries_again
    assert bool(drive.bird_map.collision.any()) is not tries_again


def test_where_the_robot_has_been_is_no_way_through_an_obstacle_that_it_felt_since() -> None:
    drive = Drive.begin(ROOM, START)
    drive.base = BasePose(1.5, 0.0, 0.0)
    drive.look()
    window = window_around(drive.bird_map, drive.base)
    row, column = window.inside(drive.bird_map.to_cell(0.7, 0.0))
    robot = window.inside(drive.bird_map.to_cell(1.5, 0.0))
    drive.bird_map.mark_felt(np.array([[0.7, 0.0]]))
    assert not traversible(drive.bird_map, window, robot, 3)[row, column]
    drive.bird_map.clear_felt()
    assert traversible(drive.bird_map, window, robot, 3)[row, column]


def test_collisions_that_shut_the_robot_in_are_forgotten() -> None:
    drive = Drive.begin((*ROOM, bed(2.0, -0.5, 2.9, 0.5)), START, replace(EXACT_PLANNER, collisions=COLLISION_MAPPING))
    for k in range(36):
        pose = BasePose(0.0, 0.0, k * math.radians(10.0))
        ahead = pose.compose(BasePose(0.5, 0.0, 0.0))
        COLLISION_MAPPING.write(drive.bird_map, BlockedMotion(pose, (ahead.x, ahead.y), 1), before_the_rim)
    goal = any_goal_receptacle(drive.bird_map, drive.base)
    assert goal is not None
    assert not drive.planner.plan(drive.bird_map, drive.base, goal).reachable
    found = plan_first(drive.planner, drive.bird_map, drive.base, SEARCH.for_receptacle())
    assert found is not None
    assert found[1].reachable
    assert not drive.bird_map.felt.any()


@pytest.mark.parametrize("config", [EXACT_PLANNER, replace(EXACT_PLANNER, collisions=COLLISION_MAPPING)])
def test_an_unseen_obstacle_is_got_around(config: PlannerConfig) -> None:
    drive = Drive.begin((*ROOM, GLASS), START, config)
    point = (2.4, 0.0)

    def goal(bird_map: BirdsEyeMap, base: BasePose) -> Goal:
        cells = disc_mask(bird_map.shape, bird_map.to_cell(*point), 2)
        return Goal(GoalKind.GOAL_RECEPTACLE, cells, face=cells)

    drive.run((goal,), 90, arrived)
    assert drive.blocked > 0
    assert drive.base.distance_to(*point) < 0.8


# --- goal_or_frontier


def test_a_stall_and_an_oscillation_are_noticed_and_a_drive_is_not() -> None:
    stuck = STUCK
    driving = [BasePose(0.25 * k, 0.0, 0.0) for k in range(40)]
    swinging = [BasePose(0.0, 0.0, (k % 2) * math.radians(30.0)) for k in range(20)]
    pacing = [BasePose(0.25 * abs(4 - k % 8), 0.0, math.pi * (k % 8 >= 4)) for k in range(48)]
    assert not stuck(driving)
    assert stuck([START] * 24)
    assert not stuck([START] * 20)
    assert stuck(swinging)
    assert stuck(pacing)
    assert not never_stuck(swinging)


@pytest.mark.parametrize(("commitment", "gets_on"), [(Commitment(BASELINE.is_stuck), False), (Commitment(STUCK), True)])
def test_a_robot_that_is_stuck_on_its_way_to_the_goal_turns_to_a_frontier(
    commitment: Commitment, gets_on: bool
) -> None:
    sill = Box((1.0, -3.0, 0.0), (1.05, 3.0, 0.09))  # too low to be mapped, and across the whole room
    drive = Drive.begin((*room(-6.0, -3.0, 3.0, 3.0), sill, bed(2.2, -0.5, 2.9, 0.5)), START)
    drive.commitment = commitment
    drive.run(SEARCH.for_receptacle(), 90)
    assert bool(min(base.x for base in drive.trail) < -1.0) is gets_on
    assert bool(commitment.left) is gets_on


# --- low_obstacles


@pytest.mark.parametrize(("names", "gets_past"), [((), False), (("low_obstacles",), True)])
def test_low_obstacles_lead_around_what_the_baseline_runs_into(names: tuple[str, ...], gets_past: bool) -> None:
    towel = Box((0.7, -0.3, 0.0), (0.9, 0.3, 0.05))
    map_config = improved(BASELINE, ("exact_labels", "driven_line", *names)).map
    drive = Drive.begin((*ROOM, towel, bed(2.2, -0.5, 2.9, 0.5)), START, map_config=map_config)
    drive.run(SEARCH.for_receptacle(), 25)
    assert bool(max(base.x for base in drive.trail) > 1.2) is gets_past


# --- surround_start_receptacle


@pytest.mark.parametrize(("choose", "finds_it"), [(BASELINE.search.start_receptacle, False), (SURROUND, True)])
def test_an_object_hidden_on_the_far_side_of_its_receptacle_is_found(choose: ChooseGoal, finds_it: bool) -> None:
    table = Box((-0.25, -0.25, 0.0), (0.25, 0.25, 0.75), "table")
    screen = Box((-0.05, -0.25, 0.75), (0.0, 0.25, 1.4))
    cup = Box((0.05, -0.05, 0.75), (0.15, 0.05, 0.85), "cup")
    drive = Drive.begin((*ROOM, table, screen, cup), BasePose(-2.4, 0.0, 0.0))
    drive.run((choose,), 150)
    assert bool(drive.bird_map.object_on_start_receptacle(play=1).any()) is finds_it


def test_the_robot_looks_at_the_receptacle_from_where_it_was_sent() -> None:
    table = Box((-0.5, -0.5, 0.0), (0.5, 0.5, 0.75), "table")
    drive = Drive.begin((*ROOM, table), BasePose(-2.4, 0.2, 0.0))
    drive.run((SURROUND,), 150)
    cells = drive.bird_map.class_cells(ClassRole.START_RECEPTACLE)
    assert (np.bitwise_or.reduce(drive.bird_map.looked_from[cells])) == 0b1111


def test_against_a_wall_only_the_free_sides_are_looked_at() -> None:
    table = Box((1.9, -0.6, 0.0), (2.98, 0.6, 0.75), "table")
    drive = Drive.begin((*ROOM, table), START)
    assert drive.run((SURROUND,), 150) is None


# --- centre_approach

before_centre = replace(SEARCH, approach=SWITCHED.approach).for_receptacle()[0]


def test_the_robot_ends_before_the_centre_of_the_side_and_not_at_its_nearest_corner() -> None:
    counter = bed(-1.0, 2.3, 1.8, 2.98)
    ends = []
    for choose in (any_goal_receptacle, before_centre):
        drive = Drive.begin((*ROOM, counter), BasePose(-2.0, 0.0, 0.0))
        found = drive.run((choose, any_frontier), 80, arrived)
        assert found is not None
        assert found[1].reached
        ends.append(drive.base)
    nearest, centre = ends
    assert nearest.x < -0.3
    assert centre.x == pytest.approx(0.4, abs=0.35)
    assert centre.y == pytest.approx(2.3 - 0.45, abs=0.2)
    assert abs(centre.bearing_to(centre.x, 3.0)) <= math.radians(20.0)


def test_a_side_that_is_partly_blocked_is_approached_at_the_middle_of_what_is_free() -> None:
    counter = bed(-1.0, 2.3, 1.8, 2.98)
    chair = Box((-1.0, 1.4, 0.0), (0.2, 2.2, 0.9))
    drive = Drive.begin((*ROOM, counter, chair), START)
    drive.run((before_centre, any_frontier), 80, arrived)
    assert drive.base.x == pytest.approx(1.2, abs=0.4)


def test_where_no_side_is_free_the_goal_stays_as_it_is() -> None:
    drive = Drive.begin((*ROOM, bed(1.0, -0.3, 1.6, 0.3)), START)
    drive.bird_map.obstacle[:] |= disc_mask(drive.bird_map.shape, drive.bird_map.to_cell(1.3, 0.0), 16)
    goal = before_centre(drive.bird_map, drive.base)
    plain = any_goal_receptacle(drive.bird_map, drive.base)
    assert goal is not None
    assert plain is not None
    assert (goal.cells == plain.cells).all()


def test_without_a_receptacle_there_is_nothing_to_approach() -> None:
    bird_map = BirdsEyeMap()
    observation = observe(ROOM, START)
    assert observation.truth is not None
    bird_map.update(observation, observation.truth, role_scores(INSTRUCTION))
    choices = (PROBABLE, before_centre, SURROUND)
    assert all(choose(bird_map, START) is None for choose in choices)
