"""What the arm sweeps: points at the rims of its boxes, just inside and just outside of them."""

from itertools import product

import numpy as np
import pytest

from uniteam.interface import Joints
from uniteam.mind.manipulation.arm_clearance import EMPTY_GRIPPER, Load, SweepConfig, is_sweep_free
from uniteam.stretch import ARM_AXIS, WRIST_PITCH_AXIS, gripper_to_base

JOINTS = Joints(lift=0.9, arm=0.4)
SWEEP = SweepConfig()
LOAD = Load(along_base=0.3, along_arm=0.2, below=0.4)


def touches(x: float, y: float, z: float, load: Load) -> bool:
    """Return whether the arm touches a point among many that are far from it."""
    far = np.random.default_rng(1).uniform((-2.0, 0.5, 0.0), (2.0, 3.0, 2.0), (500, 3))
    points = np.concatenate([far, [[x, y, z]], far]).astype(np.float32)
    return not is_sweep_free(points, JOINTS, load, SWEEP)


@pytest.mark.parametrize(("inside", "is_touched"), [(1e-3, True), (-1e-3, False)])
def test_the_arm_touches_what_is_within_the_margin_of_what_hangs_in_the_gripper(
    inside: float, is_touched: bool
) -> None:
    x, y, z = gripper_to_base(JOINTS)[:3, 3]
    half, end = LOAD.along_base + SWEEP.margin - inside, y - LOAD.along_arm - SWEEP.margin + inside
    low, high = z - LOAD.below - SWEEP.margin + inside, z + SWEEP.margin - inside
    middle = z - LOAD.below / 2
    for side, at in product((-half, half), (y, y / 2)):
        assert touches(x + side, at, middle, LOAD) is is_touched
    assert touches(x + LOAD.along_base, end, middle, LOAD) is is_touched
    for height in (low, high):
        assert touches(x + LOAD.along_base, y, height, LOAD) is is_touched


@pytest.mark.parametrize(("inside", "is_touched"), [(1e-3, True), (-1e-3, False)])
def test_the_empty_arm_touches_what_is_within_the_margin_of_its_tube_and_hand(inside: float, is_touched: bool) -> None:
    behind = SWEEP.tube_side - SWEEP.tube_width - SWEEP.margin + inside
    assert touches(behind, -0.5, ARM_AXIS[1] + JOINTS.lift, EMPTY_GRIPPER) is is_touched
    x, y, z = gripper_to_base(JOINTS)[:3, 3]
    above = max(z, WRIST_PITCH_AXIS[2] + JOINTS.lift) + SWEEP.hand + SWEEP.margin - inside
    assert touches(x, y, above, EMPTY_GRIPPER) is is_touched


def test_nothing_touches_the_arm_where_nothing_is_seen() -> None:
    assert is_sweep_free(np.zeros((0, 3), dtype=np.float32), JOINTS, LOAD, SWEEP)
