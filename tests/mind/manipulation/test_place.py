"""Placing in a world of boxes: where the baseline lets go, and what each improvement mends."""

import math
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from worlds.arm_world import ArmWorld, play
from worlds.box_world import Box
from worlds.filled import filled

from uniteam.geometry import BasePose
from uniteam.interface import BaseDisplacement, DiscreteAction, Instruction, JointDisplacement, Joints
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.manipulation.arm_clearance import Load
from uniteam.mind.manipulation.arm_reach import HANGING_WRIST, ArmReach
from uniteam.mind.manipulation.place.after_release import WaitSteps
from uniteam.mind.manipulation.place.baseline_place import BLIND_LIFT
from uniteam.mind.manipulation.place.checked_arm_path import RAISED_WRIST
from uniteam.mind.manipulation.place.place import Aim, PlaceConfig, Stand, place
from uniteam.mind.manipulation.place.placing_points import NOWHERE, PointRule, slab_density
from uniteam.mind.skills.view import Points
from uniteam.stretch import NAVIGATION_POSTURE

INSTRUCTION = Instruction("cup", "sofa", "table")
CUP = Box((0.0, 0.0, 0.0), (0.08, 0.08, 0.1), "cup")
CUP_LOAD = Load(0.04, 0.04, 0.1)


def table(x: float, depth: float = 0.7, height: float = 0.75, name: str = "table") -> Box:
    return Box((x, -0.7, 0.0), (x + depth, 0.7, height), name)


NOTHING_ELSE = np.zeros((0, 3), np.float32)


def config(*improvements: str) -> PlaceConfig:
    """Return the baseline's placing with some improvements, and little patience for the fall."""
    return replace(improved(BASELINE, set(improvements)).place, wait=WaitSteps(2))


def place_in(world: ArmWorld, settings: PlaceConfig, load: Load = CUP_LOAD, held: Box = CUP) -> list[object]:
    """Place at the last attempt, with a seeded generator; return the actions."""
    world.held = held
    context = settings.context(load, np.random.default_rng(5))
    _, actions = play(world, INSTRUCTION, lambda view: place(view, context, settings, is_last=True))
    return list(actions)


def is_over(world: ArmWorld, box: Box, margin: float = 0.0) -> bool:
    """Whether the gripper let go over a box, no nearer to its edge than the margin (m)."""
    assert world.released is not None
    x, y, z = world.released
    inside = all(box.low[i] + margin <= value <= box.high[i] - margin for i, value in enumerate((x, y)))
    return inside and z > box.high[2]


def test_the_baseline_drives_to_a_table_lets_go_over_it_and_waits_for_the_fall() -> None:
    goal = table(0.9, height=0.5)
    world = ArmWorld((goal,), BasePose(0.0, 0.0, 0.1))
    actions = place_in(world, config())
    assert is_over(world, goal)
    assert world.hits == []
    assert actions[:3] == [*[DiscreteAction.MOVE_FORWARD] * 2, DiscreteAction.MANIPULATION_MODE]
    assert actions[-2:] == [DiscreteAction.EMPTY_ACTION] * 2
    assert BASELINE.place.wait == WaitSteps(200)


def test_the_baseline_sets_the_lift_joint_40_cm_above_the_surface_and_lifts_and_retracts_in_the_end() -> None:
    world = ArmWorld((table(0.5, height=0.5),), BasePose(0.0, 0.0, 0.0))
    actions = place_in(world, config())
    after = actions[actions.index(DiscreteAction.DESNAP_OBJECT) + 1 :]
    before = world.released
    lifts = [action.delta.lift for action in after if isinstance(action, JointDisplacement)]
    arms = [action.delta.arm for action in after if isinstance(action, JointDisplacement)]
    assert before is not None and before[2] == pytest.approx(0.9 + ArmReach.of_wrist(HANGING_WRIST).low, abs=0.005)
    assert lifts == [pytest.approx(0.2, abs=0.005), 0.0]
    assert arms[0] == 0.0 and arms[1] < 0.0
    assert (world.joints.lift, world.joints.arm) == (pytest.approx(1.1), pytest.approx(0.0))


def test_still_arm_leaves_the_arm_where_it_let_go() -> None:
    world = ArmWorld((table(0.5, height=0.5),), BasePose(0.0, 0.0, 0.0))
    actions = place_in(world, config("still_arm"))
    assert actions[-3:] == [DiscreteAction.DESNAP_OBJECT, *[DiscreteAction.EMPTY_ACTION] * 2]
    assert world.joints.arm > 0.2


def test_the_slab_reaches_20_cm_to_all_sides_and_15_mm_up_and_down() -> None:
    offsets = [(0.199, 0.0, 0.0), (0.0, 0.199, 0.0), (0.0, 0.0, 0.0149)]
    outside = [(0.201, 0.0, 0.0), (0.0, 0.201, 0.0), (0.0, 0.0, 0.0151)]
    middle = np.array([[0.0, 0.0, 0.7]])
    crowded = np.concatenate([middle, middle + np.array(offsets), middle + 5.0])
    lonely = np.concatenate([middle, middle + np.array(outside), middle + 5.0])
    for points, count in ((crowded, 4), (lonely, 1)):
        worth = slab_density(points, np.array([points[0], points[-1]]), CUP_LOAD)
        assert worth[1] / worth[0] == pytest.approx(1 / count)


def test_the_baseline_turns_only_by_whole_steps_and_exact_motion_by_what_is_missing() -> None:
    goal = Box((0.75, -0.25, 0.0), (1.25, 0.25, 0.5), "table")
    worlds = [ArmWorld((goal,), BasePose(0.0, 0.0, 0.45)) for _ in range(2)]
    actions = [place_in(world, config(*names)) for world, names in zip(worlds, ((), ("exact_motion",)), strict=True)]
    assert not any(isinstance(action, BaseDisplacement) for action in filled(actions[0]))
    assert DiscreteAction.TURN_RIGHT not in actions[0]
    assert not is_over(worlds[0], goal)
    assert is_over(worlds[1], goal)


def test_whole_mask_places_on_what_is_too_narrow_for_the_baselines_mask() -> None:
    narrow = Box((0.6, -0.01, 0.0), (0.65, 0.01, 0.6), "table")
    worlds = [ArmWorld((narrow,), BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    place_in(worlds[0], config())
    place_in(worlds[1], config("whole_mask", "exact_motion"))
    assert worlds[0].released is not None and worlds[0].released[2] == pytest.approx(BLIND_LIFT - 0.126, abs=0.005)
    assert is_over(worlds[1], narrow, margin=-0.03)


def test_the_baseline_chooses_the_point_whose_slab_holds_most_points() -> None:
    generator = np.random.default_rng(0)
    crowd = np.column_stack([generator.uniform(0.0, 0.1, (400, 2)), np.full(400, 0.7)])
    scattered = np.column_stack([generator.uniform(1.0, 2.0, (400, 2)), generator.uniform(0.0, 0.7, 400)])
    chosen = PointRule()(np.concatenate([crowd, scattered]).astype(np.float32), NOTHING_ELSE, CUP_LOAD, generator)
    assert len(chosen.points) == 50
    best = chosen.points[chosen.best_first()[0]]
    assert best[0] < 0.2 and best[2] == pytest.approx(0.7)


def test_stepwise_place_gets_to_a_table_that_one_long_drive_does_not_reach() -> None:
    """The baseline's arm is extended by what was missing before the drive, and reaches over the shallow table."""
    goal = table(0.8, depth=0.25, height=0.5)
    worlds = [ArmWorld((goal,), BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    place_in(worlds[0], config())
    place_in(worlds[1], config("stepwise_place"))
    assert not is_over(worlds[0], goal)
    assert is_over(worlds[1], goal)


def test_stepwise_place_drives_25_cm_at_most_and_ends_before_a_box_where_one_long_drive_does_not_happen() -> None:
    goal = table(0.95, depth=0.5, height=0.5)
    obstacle = Box((0.75, -0.3, 0.0), (0.95, 0.3, 0.3))
    worlds = [ArmWorld((goal, obstacle), BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    place_in(worlds[0], config("exact_motion"))
    actions = place_in(worlds[1], config("exact_motion", "stepwise_place"))
    assert worlds[0].base.distance_to(0.0, 0.0) < 0.01
    assert not is_over(worlds[0], goal)
    assert is_over(worlds[1], goal)
    drives = [a.x for a in actions if isinstance(a, BaseDisplacement) and a.x > 0]
    assert drives and max(drives) <= 0.25


def test_checked_arm_path_goes_over_or_around_a_lamp_that_the_baseline_hits() -> None:
    goal = table(0.5, height=0.7)
    lamp = Box((0.55, -0.1, 0.7), (0.65, 0.1, 1.3))
    worlds = [ArmWorld((goal, lamp), BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    place_in(worlds[0], config())
    place_in(worlds[1], config("stepwise_place", "checked_arm_path"))
    assert worlds[0].hits
    assert is_over(worlds[1], goal)
    assert worlds[1].hits == []


def test_edge_margin_keeps_away_from_the_edge_and_from_what_lies_there() -> None:
    grid = np.stack(np.meshgrid(np.arange(0.0, 0.5, 0.01), np.arange(0.0, 0.5, 0.01)), axis=-1).reshape(-1, 2)
    top = np.column_stack([grid, np.full(len(grid), 0.7)]).astype(np.float32)
    near_edge = np.repeat(top[top[:, 0] < 0.02], 200, axis=0)
    cloud = np.concatenate([top, near_edge])
    greedy = PointRule()(cloud, NOTHING_ELSE, CUP_LOAD, np.random.default_rng(1))
    careful = config("edge_margin").choose_points(cloud, NOTHING_ELSE, CUP_LOAD, np.random.default_rng(1))
    assert greedy.points[greedy.best_first()[0]][0] < 0.03
    best = careful.points[careful.best_first()[0]]
    assert 0.11 < best[0] < 0.39 and 0.11 < best[1] < 0.39
    assert (careful.worth > 0).all()


def basin() -> Points:
    """Return the points of a basin, 0.75 m high, with a rim of 0.9 m; its wall is seen from one side."""
    ticks = np.arange(0.0, 0.4, 0.01)
    x, y = (axis.ravel() for axis in np.meshgrid(ticks, ticks))
    is_rim = (x < 0.05) | (x > 0.35) | (y < 0.05) | (y > 0.35)
    wall = [(0.05, v, h) for v in ticks for h in np.arange(0.75, 0.9, 0.01)]
    bowl = np.column_stack([x, y, np.where(is_rim, 0.9, 0.75)])
    return np.concatenate([bowl, wall]).astype(np.float32)


def test_edge_margin_takes_the_bottom_of_a_basin_for_safe() -> None:
    chosen = config("edge_margin").choose_points(basin(), NOTHING_ELSE, CUP_LOAD, np.random.default_rng(2))
    best = chosen.points[chosen.best_first()[0]]
    assert best[2] < 0.9
    assert 0.04 < best[0] < 0.3 and 0.1 < best[1] < 0.3


def test_headroom_offers_no_walls_that_the_baseline_offers() -> None:
    rules = config().choose_points, config("headroom").choose_points
    offered = [rule(basin(), NOTHING_ELSE, CUP_LOAD, np.random.default_rng(2)).points for rule in rules]
    on_wall = [np.count_nonzero((points[:, 2] > 0.77) & (points[:, 2] < 0.87)) for points in offered]
    assert on_wall[0] > 0
    assert on_wall[1] == 0
    assert len(offered[1]) == 50


def test_flat_ground_prefers_a_seat_to_a_wider_hollow() -> None:
    ticks = np.arange(0.0, 0.5, 0.01)
    x, y = (axis.ravel() for axis in np.meshgrid(ticks, ticks))
    seat = np.column_stack([x, y, np.full(len(x), 0.5)])[x < 0.26]
    hollow = np.column_stack([x + 1.0, y, 0.5 + 1.2 * np.abs(x - 0.25)])
    cloud = np.concatenate([seat, np.tile(hollow, (5, 1))]).astype(np.float32)

    def share_on_seat(settings: PlaceConfig) -> float:
        bests = [
            settings.choose_points(cloud, NOTHING_ELSE, CUP_LOAD, np.random.default_rng(seed)) for seed in range(12)
        ]
        return float(np.mean([best.points[best.best_first()[0]][0] < 0.75 for best in bests]))

    assert share_on_seat(config("edge_margin")) < 0.5
    assert share_on_seat(config("edge_margin", "flat_ground")) > 0.7


def test_surface_fallback_uses_a_flat_surface_where_the_baseline_lets_go_blindly() -> None:
    """No table is detected: the baseline stretches past the narrow desk, the improvement puts down on it."""
    desk = Box((0.42, -0.4, 0.0), (0.62, 0.4, 0.8), "desk")
    worlds = [ArmWorld((desk,), BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    actions = place_in(worlds[0], config())
    place_in(worlds[1], config("surface_fallback"))
    assert actions[0] is DiscreteAction.MANIPULATION_MODE
    assert not is_over(worlds[0], desk)
    assert is_over(worlds[1], desk)


def test_surface_fallback_extends_blindly_only_where_there_is_no_surface_either() -> None:
    world = ArmWorld((), BasePose(0.0, 0.0, 0.0))
    place_in(world, config("surface_fallback"))
    assert world.released is not None
    assert math.hypot(world.released[0], world.released[1]) > 0.6


VASE = Box((0.0, 0.0, 0.0), (0.1, 0.1, 0.5), "cup")
VASE_LOAD = Load(0.05, 0.05, 0.5)


def test_drop_height_lifts_a_tall_object_over_a_table_that_it_would_hit() -> None:
    low = table(0.5, height=0.4)
    worlds = [ArmWorld((low,), BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    place_in(worlds[0], config(), VASE_LOAD, VASE)
    place_in(worlds[1], config("drop_height"), VASE_LOAD, VASE)
    assert worlds[0].hits
    assert worlds[1].hits == []
    assert is_over(worlds[1], low)


def test_drop_height_leaves_the_height_of_a_small_object_alone() -> None:
    assert config("drop_height").release.height_above_surface(CUP_LOAD) == config().release.height_above_surface(
        CUP_LOAD
    )


def test_low_drop_lets_a_small_object_fall_less_deep() -> None:
    worlds = [ArmWorld((table(0.5, height=0.5),), BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    place_in(worlds[0], config())
    place_in(worlds[1], config("low_drop"))
    heights = [world.released[2] for world in worlds if world.released is not None]
    assert heights == [pytest.approx(0.774, abs=0.005), pytest.approx(0.65, abs=0.005)]
    assert worlds[1].hits == []


def test_level_wrist_gets_over_a_counter_that_a_hanging_gripper_hits() -> None:
    counter = table(0.5, height=1.1)
    worlds = [ArmWorld((counter,), BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    place_in(worlds[0], config())
    place_in(worlds[1], config("level_wrist"))
    assert worlds[0].hits
    assert worlds[1].hits == []
    assert is_over(worlds[1], counter)


def test_checked_arm_path_does_without_stepwise_place() -> None:
    """One drive, one point: the arm goes over the box that stands at the table's edge."""
    goal, box = table(0.55, depth=0.3, height=0.4), Box((0.55, -0.7, 0.4), (0.58, 0.7, 0.5))
    worlds = [ArmWorld((goal, box), BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    tall, load = Box((0.0, 0.0, 0.0), (0.08, 0.08, 0.35), "cup"), Load(0.04, 0.04, 0.35)
    place_in(worlds[0], config("exact_motion"), load, tall)
    place_in(worlds[1], config("exact_motion", "checked_arm_path"), load, tall)
    assert worlds[0].hits
    assert worlds[1].hits == []
    assert is_over(worlds[1], goal)


def test_more_attempts_keeps_hold_where_no_receptacle_is_seen_and_the_baseline_lets_go() -> None:
    worlds = [ArmWorld((), BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    for world, settings in zip(worlds, (config(), config("more_attempts")), strict=True):
        world.held = CUP
        context = settings.context(CUP_LOAD, np.random.default_rng(5))
        begin = partial(place, context=context, config=settings, is_last=settings.attempts == 1)
        play(world, INSTRUCTION, begin)
    assert worlds[0].released is not None
    assert worlds[1].held is CUP
    assert worlds[1].joints == NAVIGATION_POSTURE


def test_more_attempts_lets_nothing_go_over_a_ledge_while_there_are_attempts_left() -> None:
    ledge = Box((0.5, -0.5, 0.7), (0.53, 0.5, 0.75), "table")
    settings = config(
        "edge_margin", "checked_arm_path", "stepwise_place", "exact_motion", "more_attempts", "whole_mask"
    )
    for is_last in (False, True):
        world = ArmWorld((ledge,), BasePose(0.0, 0.0, 0.0))
        world.held = CUP
        context = settings.context(CUP_LOAD, np.random.default_rng(5))
        play(world, INSTRUCTION, partial(place, context=context, config=settings, is_last=is_last))
        assert (world.released is not None) is is_last


def test_checked_arm_path_raises_the_wrist_over_what_the_lift_alone_does_not_get_over() -> None:
    world = ArmWorld((table(0.5, height=1.08),), BasePose(0.0, 0.0, 0.0))
    place_in(world, config("stepwise_place", "exact_motion", "checked_arm_path", "level_wrist"), Load(0.04, 0.04, 0.14))
    assert world.hits == []
    assert world.released is not None and is_over(world, table(0.5, height=1.08))
    assert world.joints.wrist_pitch == pytest.approx(RAISED_WRIST)


def test_checked_arm_path_lets_go_lower_under_a_board() -> None:
    boxes = table(0.5, height=0.7), Box((0.5, -0.5, 1.05), (1.2, 0.5, 1.08))
    world = ArmWorld(boxes, BasePose(0.0, 0.0, 0.0))
    place_in(
        world, config("stepwise_place", "exact_motion", "checked_arm_path", "level_wrist", "still_arm", "drop_height")
    )
    assert world.hits == []
    assert world.released is not None and is_over(world, table(0.5, height=0.7))


def test_surface_fallback_keeps_in_mind_what_was_seen_before() -> None:
    """The lamp is above the picture once the arm points at the table."""
    seen = np.array([[x, -0.6, z] for x in np.arange(-0.4, 0.4, 0.02) for z in np.arange(0.8, 1.3, 0.02)], np.float32)
    settings = config("surface_fallback", "checked_arm_path")
    world = ArmWorld((Box((0.4, -1.0, 0.0), (1.2, 1.0, 0.75), "desk"),), BasePose(0.0, 0.0, 0.0))
    world.do(DiscreteAction.MANIPULATION_MODE)
    view = world.view(INSTRUCTION)

    def end_knowing(surroundings: Points) -> Joints:
        stand = Stand(view, NOWHERE, surroundings, settings.motion.line_up)
        context = settings.context(CUP_LOAD, np.random.default_rng(5))
        aim, _ = play(world, INSTRUCTION, lambda view: settings.fall_back(view, stand, context))
        assert isinstance(aim, Aim)
        return aim.path.end

    assert end_knowing(seen) != end_knowing(NOTHING_ELSE)


def test_edge_margin_is_worth_the_distance_from_the_edge_and_more_of_it_for_what_is_larger() -> None:
    ticks = np.arange(-0.5, 0.5, 0.01)
    x, y = (axis.ravel() for axis in np.meshgrid(ticks, ticks))
    top = np.column_stack([x, y, np.full(len(x), 0.7)]).astype(np.float32)
    samples = np.array([[-0.5 + off, 0.0, 0.7] for off in (0.08, 0.15, 0.25)], dtype=np.float32)
    weigh = config("edge_margin").choose_points.weigh  # type: ignore[attr-defined]
    of_cup, of_plank = (weigh(top, samples, load) for load in (CUP_LOAD, Load(0.3, 0.05, 0.05)))
    assert of_cup[1] - of_cup[0] > 0.03 and of_cup[2] - of_cup[1] < 0.02
    assert of_plank[2] - of_plank[1] > 0.08


def test_surface_fallback_takes_no_floor_for_a_surface() -> None:
    world = ArmWorld((Box((0.3, -1.0, 0.0), (2.0, 1.0, 0.02)),), BasePose(0.0, 0.0, 0.0))
    place_in(world, config("surface_fallback"))
    assert world.released is not None
    assert world.released[2] == pytest.approx(BLIND_LIFT + ArmReach.of_wrist(HANGING_WRIST).low, abs=0.005)


def test_surface_fallback_puts_down_on_the_level_and_not_on_the_slope_beside_it() -> None:
    """A narrow board before a bank of steps, each too narrow to stand on: only the board is level with room above."""
    board = Box((0.45, -0.5, 0.0), (0.6, 0.5, 0.5), "desk")
    bank = tuple(Box((0.6 + 0.01 * k, -0.5, 0.0), (0.61 + 0.01 * k, 0.5, 0.55 + 0.04 * k)) for k in range(20))
    on_board = 0
    for seed in range(6):
        world = ArmWorld((board, *bank), BasePose(0.0, 0.0, 0.0))
        world.held = CUP
        settings = config("surface_fallback")
        context = settings.context(CUP_LOAD, np.random.default_rng(seed))
        play(world, INSTRUCTION, partial(place, context=context, config=settings, is_last=True))
        on_board += is_over(world, board)
    assert on_board == 6


def test_drop_height_keeps_15_cm_between_what_hangs_down_and_the_surface() -> None:
    low = table(0.5, height=0.3)
    world = ArmWorld((low,), BasePose(0.0, 0.0, 0.0))
    place_in(world, config("drop_height"), VASE_LOAD, VASE)
    assert world.released is not None
    assert world.released[2] == pytest.approx(0.3 + 0.5 + 0.15, abs=0.005)


def test_drop_height_never_lowers_what_the_baseline_drops() -> None:
    for below in np.linspace(0.0, 0.6, 13):
        load = Load(0.05, 0.05, float(below))
        raised, plain = (config(*names).release.height_above_surface(load) for names in (("drop_height",), ()))
        assert raised >= plain
    assert raised > plain + 0.3
