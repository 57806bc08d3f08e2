"""Grasping with the arm in a world of boxes: the open fingers come to either side of the object, and close there."""

import math
from dataclasses import dataclass, field

import numpy as np
import pytest
from worlds.arm_world import ArmWorld, play
from worlds.box_world import Box

from uniteam.geometry import BasePose, transform_points
from uniteam.interface import Action, DiscreteAction, Instruction
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.manipulation.pick.finger_room import FingerShape, grasp_poses
from uniteam.mind.manipulation.pick.pick import PickResult, pick
from uniteam.stretch import gripper_to_base

CONFIG = improved(BASELINE, {"arm_grasp", "verify_pick"}).pick
INSTRUCTION = Instruction("cup", "table", "bed")
TABLE = Box((0.45, -1.0, 0.0), (1.3, 1.0, 0.6), "table")
HANGING = -1.57


def cup(x: float, y: float, side: float = 0.07, height: float = 0.1, bottom: float = 0.6) -> Box:
    return Box((x - side / 2, y - side / 2, bottom), (x + side / 2, y + side / 2, bottom + height), "cup")


@dataclass
class FingerWorld(ArmWorld):
    """A gripper that takes only what is at its grasp centre; or, where it errs, feels something and takes nothing."""

    errs: bool = False
    closed_at: list[np.ndarray] = field(default_factory=list)

    def _snap(self) -> None:
        gripper = self.base.matrix() @ gripper_to_base(self.joints)
        self.closed_at.append(gripper)
        inside = [box for box in self.boxes if box.name == "cup" and _holds(box, gripper[:3, 3])]
        if self.errs:
            self.held = Box((0.0, 0.0, 0.0), (0.01, 0.01, 0.01))
        elif inside:
            self.held = inside[0]
            self.boxes = tuple(box for box in self.boxes if box is not inside[0])


def _holds(box: Box, point: np.ndarray) -> bool:
    return bool(((np.array(box.low) < point) & (point < np.array(box.high))).all())


def pick_in(world: FingerWorld) -> tuple[PickResult, list[Action]]:
    result, actions = play(world, INSTRUCTION, lambda view: pick(view, CONFIG))
    assert isinstance(result, PickResult)
    return result, actions


@pytest.mark.parametrize(("x", "y", "bottom"), [(0.6, 0.0, 0.6), (0.6, 0.15, 0.6), (0.62, -0.1, 0.9)])
def test_the_fingers_close_around_the_middle_of_the_object(x: float, y: float, bottom: float) -> None:
    """Low enough, the gripper hangs; a high object it reaches with the wrist raised."""
    table = Box((0.45, -1.0, 0.0), (1.3, 1.0, bottom), "table")
    world = FingerWorld((table, cup(x, y, bottom=bottom)), BasePose(0.0, 0.0, 0.0))
    result, actions = pick_in(world)
    assert result.grasped
    assert actions.index(DiscreteAction.DESNAP_OBJECT) < actions.index(DiscreteAction.SNAP_OBJECT)
    centre = world.closed_at[0][:3, 3]
    np.testing.assert_allclose(centre[:2], (x, y), atol=0.02)
    assert bottom + 0.02 < centre[2] < bottom + 0.1
    hangs = world.closed_at[0][2, 0] < -0.99
    assert hangs == (bottom == 0.6)


def test_the_fingers_close_across_the_narrow_side() -> None:
    long = Box((0.5, -0.04, 0.6), (0.75, 0.04, 0.65), "cup")
    world = FingerWorld((TABLE, long), BasePose(0.0, 0.0, 0.0))
    assert pick_in(world)[0].grasped
    closing = world.closed_at[0][:2, 1]
    assert abs(closing[1]) == pytest.approx(1.0, abs=0.05)


def test_a_grip_on_something_else_is_seen_through_and_let_go() -> None:
    world = FingerWorld((TABLE, cup(0.6, 0.0)), BasePose(0.0, 0.0, 0.0), errs=True)
    result, actions = pick_in(world)
    assert not result.grasped
    assert world.held is None
    assert actions.count(DiscreteAction.SNAP_OBJECT) == 3


def test_nothing_is_tried_where_the_fingers_have_no_room() -> None:
    walls = tuple(Box((x, -0.3, 0.6), (x + 0.02, 0.3, 1.0)) for x in (0.53, 0.65))
    ends = tuple(Box((0.53, y, 0.6), (0.67, y + 0.02, 1.0)) for y in (-0.09, 0.07))
    world = FingerWorld((TABLE, cup(0.6, 0.0), *walls, *ends), BasePose(0.0, 0.0, 0.0))
    result, actions = pick_in(world)
    assert not result.grasped
    assert DiscreteAction.SNAP_OBJECT not in actions


def block(x: float, y: float, size: tuple[float, float, float], turn: float = 0.0) -> np.ndarray:
    """Return points all over a block on the plane z = 0.5 (m)."""
    points = np.stack(np.meshgrid(*(np.linspace(-s / 2, s / 2, 15) for s in size)), -1).reshape(-1, 3)
    pose = BasePose(x, y, turn).matrix()
    return np.asarray(transform_points(pose, points) + np.array((0.0, 0.0, 0.5 + size[2] / 2)), np.float32)


@pytest.mark.parametrize("turn", [0.0, 0.6, -1.2])
def test_the_best_pose_is_the_middle_of_the_narrow_side(turn: float) -> None:
    points = block(0.1, -0.5, (0.06, 0.15, 0.08), turn)
    best = next(grasp_poses(points, np.zeros((0, 3), np.float32), HANGING, FingerShape()))
    np.testing.assert_allclose(best.centre[:2], (0.1, -0.5), atol=0.01)
    assert abs(math.remainder(best.turn - turn, math.pi)) < 0.15
    assert best.span == pytest.approx(0.06, abs=0.01)
    assert best.centre[2] == pytest.approx(0.53, abs=0.01)


def test_a_neighbour_on_one_side_turns_the_fingers() -> None:
    points, neighbour = block(0.0, -0.5, (0.06, 0.07, 0.08)), block(0.11, -0.5, (0.08, 0.04, 0.08))
    best = next(grasp_poses(points, neighbour, HANGING, FingerShape()))
    assert abs(math.remainder(best.turn, math.pi)) > 0.3


def test_what_is_wider_than_the_opening_gives_no_pose() -> None:
    wide = block(0.0, -0.5, (0.3, 0.3, 0.1))
    assert list(grasp_poses(wide, np.zeros((0, 3), np.float32), HANGING, FingerShape())) == []
