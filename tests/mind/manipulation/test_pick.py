"""Picking in a world of boxes: what the baseline misses, and what looking around and feeling the gripper mend."""

import math
from dataclasses import dataclass, replace

import numpy as np
import pytest
from worlds.arm_world import ArmWorld, play
from worlds.box_world import Box
from worlds.filled import filled

from uniteam.geometry import BasePose
from uniteam.interface import Action, DiscreteAction, Instruction, JointDisplacement
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.manipulation.pick.pick import PickConfig, PickResult, load_seen, pick

INSTRUCTION = Instruction("cup", "table", "bed")
TABLE = Box((0.45, -1.0, 0.0), (1.3, 1.0, 0.7), "table")
BASIC = BASELINE.pick
LOOKING = improved(BASELINE, {"look_around_pick"}).pick
TILTING = improved(BASELINE, {"tilt_head"}).pick
REACHING = improved(BASELINE, {"reach_out_pick"}).pick
VERIFYING = improved(BASELINE, {"verify_pick"}).pick


def cup_at(x: float, y: float) -> Box:
    return Box((x - 0.04, y - 0.04, 0.7), (x + 0.04, y + 0.04, 0.8), "cup")


def pick_in(world: ArmWorld, config: PickConfig) -> PickResult:
    result, _ = play(world, INSTRUCTION, lambda view: pick(view, config))
    assert isinstance(result, PickResult)
    return result


def test_the_baseline_snaps_once_and_does_not_turn_back() -> None:
    world = ArmWorld((TABLE, cup_at(0.6, 0.0)), BasePose(0.0, 0.0, 0.0))
    result, actions = play(world, INSTRUCTION, lambda view: pick(view, BASIC))
    assert actions == [
        DiscreteAction.MANIPULATION_MODE,
        DiscreteAction.SNAP_OBJECT,
        DiscreteAction.NAVIGATION_MODE,
    ]
    assert world.held is not None
    assert world.base.heading == pytest.approx(math.pi / 2)
    assert isinstance(result, PickResult) and result.grasped


def test_what_is_held_is_known_by_what_was_seen_of_it() -> None:
    world = ArmWorld((TABLE, Box((0.5, -0.15, 0.7), (0.6, 0.15, 0.9), "cup")), BasePose(0.0, 0.0, 0.0))
    world.do(DiscreteAction.MANIPULATION_MODE)
    load = load_seen(world.view(INSTRUCTION))
    assert load.along_base == pytest.approx(0.15, abs=0.02)
    assert load.along_arm == pytest.approx(0.05, abs=0.02)
    assert load.below == pytest.approx(0.2, abs=0.02)


def test_look_around_pick_finds_an_object_beside_the_arm_that_the_baseline_misses() -> None:
    for bearing in (40.0, -40.0, -65.0):
        x, y = 0.7 * math.cos(math.radians(bearing)), 0.7 * math.sin(math.radians(bearing))
        boxes = (Box((x - 0.2, y - 0.2, 0.0), (x + 0.2, y + 0.2, 0.7), "table"), cup_at(x, y))
        worlds = [ArmWorld(boxes, BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
        pick_in(worlds[0], BASIC)
        pick_in(worlds[1], LOOKING)
        assert worlds[0].held is None, bearing
        assert worlds[1].held is not None, bearing


def test_reach_out_pick_drives_closer_to_an_object_in_view_beyond_reach() -> None:
    boxes = (Box((0.9, -0.5, 0.0), (1.4, 0.5, 0.7), "table"), cup_at(1.2, 0.1))
    worlds = [ArmWorld(boxes, BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    pick_in(worlds[0], BASIC)
    pick_in(worlds[1], REACHING)
    assert worlds[0].held is None
    assert worlds[1].held is not None
    assert worlds[1].base.x > 0.2


def test_tilt_head_finds_an_object_above_the_picture_that_the_baseline_misses() -> None:
    boxes = (Box((0.5, -0.3, 0.0), (1.0, 0.3, 1.2), "table"), Box((0.56, -0.04, 1.2), (0.64, 0.04, 1.3), "cup"))
    worlds = [ArmWorld(boxes, BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    pick_in(worlds[0], BASIC)
    pick_in(worlds[1], TILTING)
    assert worlds[0].held is None
    assert worlds[1].held is not None


def test_tilt_head_looks_straight_along_the_arm_again_where_there_is_nothing() -> None:
    world = ArmWorld((TABLE,), BasePose(0.0, 0.0, 0.0))
    _, actions = play(world, INSTRUCTION, lambda view: pick(view, TILTING))
    tilts = [action.delta.head_tilt for action in actions if isinstance(action, JointDisplacement)]
    assert len(tilts) == 3
    assert sum(tilts) == pytest.approx(0.0)


def test_look_around_pick_gives_up_where_there_is_nothing() -> None:
    world = ArmWorld((TABLE,), BasePose(0.0, 0.0, 0.3))
    pick_in(world, LOOKING)
    assert world.held is None
    assert np.isclose(abs(math.remainder(world.base.heading - 0.3 - math.pi / 2, 2 * math.pi)), math.radians(60.0))


def test_verify_pick_knows_of_a_miss_that_the_baseline_takes_for_a_success() -> None:
    worlds = [ArmWorld((TABLE,), BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    assert pick_in(worlds[0], BASIC).grasped
    assert not pick_in(worlds[1], VERIFYING).grasped


def test_a_wrong_name_leads_to_a_snap_that_verify_pick_sees_through() -> None:
    """Perception takes a bowl for the cup; the gripper, which takes cups only, stays empty."""
    bowl = replace(cup_at(0.6, 0.0), name="bowl")
    world = ArmWorld((TABLE, bowl), BasePose(0.0, 0.0, 0.0))
    wrong = Instruction("bowl", "table", "bed")
    result, _ = play(world, wrong, lambda view: pick(view, VERIFYING))
    assert isinstance(result, PickResult) and not result.grasped


def test_reach_out_pick_extends_the_arm_over_what_keeps_the_base_away() -> None:
    bench = Box((0.35, -0.5, 0.0), (0.8, 0.5, 0.5), "bench")
    boxes = (bench, Box((0.8, -0.5, 0.0), (1.6, 0.5, 0.6), "table"), Box((1.16, -0.04, 0.6), (1.24, 0.04, 0.7), "cup"))
    worlds = [ArmWorld(boxes, BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    pick_in(worlds[0], BASIC)
    pick_in(worlds[1], REACHING)
    assert worlds[0].held is None
    assert worlds[1].held is not None
    assert worlds[1].hits == []
    assert worlds[1].joints.arm == pytest.approx(0.0)


def test_reach_out_pick_drives_a_shorter_way_where_the_whole_of_it_is_blocked() -> None:
    bench = Box((0.45, -0.5, 0.0), (0.8, 0.5, 0.5), "bench")
    boxes = (bench, Box((0.8, -0.5, 0.0), (1.6, 0.5, 0.6), "table"), Box((1.26, -0.04, 0.6), (1.34, 0.04, 0.7), "cup"))
    world = ArmWorld(boxes, BasePose(0.0, 0.0, 0.0))
    pick_in(world, REACHING)
    assert world.held is not None
    assert 0.1 <= world.base.x <= 0.15


def test_reach_out_pick_does_not_extend_the_arm_through_what_is_in_the_way() -> None:
    bench = Box((0.35, -0.5, 0.0), (0.8, 0.5, 0.5), "bench")
    cup = Box((1.16, -0.04, 0.6), (1.24, 0.04, 0.7), "cup")
    fence = tuple(Box((0.4, y, 0.5), (0.42, y + 0.02, 1.6)) for y in np.arange(-0.3, 0.3, 0.06))
    world = ArmWorld((bench, Box((0.8, -0.5, 0.0), (1.6, 0.5, 0.6), "table"), cup, *fence), BasePose(0.0, 0.0, 0.0))
    _, actions = play(world, INSTRUCTION, lambda view: pick(view, REACHING))
    assert world.hits == []
    assert not any(isinstance(action, JointDisplacement) and action.delta.arm > 0.05 for action in filled(actions))


@dataclass
class TurningWorld(ArmWorld):
    """A body whose base turns back when the arm is folded, which the challenge's does not."""

    def do(self, action: Action) -> None:
        super().do(action)
        if action is DiscreteAction.NAVIGATION_MODE:
            self.base = replace(self.base, heading=self.base.heading - math.pi / 2)


@pytest.mark.parametrize(("names", "heading"), [((), math.pi / 2), (("turn_back",), 0.0)])
def test_turn_back_faces_the_object_again_where_folding_the_arm_does_not_turn_the_base(
    names: tuple[str, ...], heading: float
) -> None:
    world = ArmWorld((TABLE, cup_at(0.6, 0.0)), BasePose(0.0, 0.0, 0.0))
    pick_in(world, improved(BASELINE, names).pick)
    assert world.base.heading == pytest.approx(heading)
    turning = TurningWorld((TABLE, cup_at(0.6, 0.0)), BasePose(0.0, 0.0, 0.0))
    _, actions = play(turning, INSTRUCTION, lambda view: pick(view, improved(BASELINE, names).pick))
    assert turning.base.heading == pytest.approx(0.0)
    assert actions[-1] is DiscreteAction.NAVIGATION_MODE


def test_reach_out_pick_drives_to_the_object_whether_or_not_folding_the_arm_turns_the_base() -> None:
    boxes = (Box((0.9, -0.5, 0.0), (1.4, 0.5, 0.7), "table"), cup_at(1.2, 0.1))
    worlds = ArmWorld(boxes, BasePose(0.0, 0.0, 0.0)), TurningWorld(boxes, BasePose(0.0, 0.0, 0.0))
    for world in worlds:
        pick_in(world, REACHING)
        assert world.held is not None


def test_step_back_pick_finds_an_object_that_the_board_above_hides_from_near() -> None:
    rack = Box((0.45, -0.5, 0.0), (0.8, 0.5, 0.3), "table"), Box((0.40, -0.5, 0.62), (0.8, 0.5, 0.65), "table")
    boxes = (*rack, Box((0.60, -0.04, 0.3), (0.68, 0.04, 0.36), "cup"))
    worlds = [ArmWorld(boxes, BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    pick_in(worlds[0], TILTING)
    pick_in(worlds[1], improved(BASELINE, {"tilt_head", "step_back_pick"}).pick)
    assert worlds[0].held is None
    assert worlds[1].held is not None
    assert -0.35 < worlds[1].base.x < -0.1


def test_step_back_pick_stays_where_the_object_is_in_view() -> None:
    world = ArmWorld((TABLE, cup_at(0.6, 0.0)), BasePose(0.0, 0.0, 0.0))
    _, actions = play(world, INSTRUCTION, lambda view: pick(view, improved(BASELINE, {"step_back_pick"}).pick))
    assert len(actions) == 3
