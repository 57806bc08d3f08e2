"""Whether the arm gets there without touching anything that is seen.

The arm leaves the robot to its right, along -y of the base, at one height. What it sweeps is a few boxes, one behind
the other: the tube, the gripper and what hangs in it.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.interface import Joints
from uniteam.mind.manipulation.view import Points
from uniteam.stretch import ARM_AXIS, WRIST_YAW_AXIS, gripper_to_base

FOOTPRINT = 0.3
"""m; nothing but the robot itself is nearer to the base's centre."""


@dataclass(frozen=True)
class Load:
    """The room that what the gripper holds takes around the grasp centre, whichever way the wrist turns (m).

    Attributes:
        along_base: how far it reaches ahead and behind, along the base's x axis.
        along_arm: how far it reaches out and back, along the arm.
        below: how far it hangs down.
    """

    along_base: float
    along_arm: float
    below: float


EMPTY_GRIPPER = Load(0.0, 0.0, 0.0)


@dataclass(frozen=True)
class SweepConfig:
    """The room the arm takes (m).

    Attributes:
        tube: half the arm's width and height.
        gripper: half the gripper's width and height.
        fingers: how far the fingers reach beyond the grasp centre.
        margin: the distance to be kept to everything.
    """

    tube: float = 0.06
    gripper: float = 0.09
    fingers: float = 0.04
    margin: float = 0.03


def is_sweep_free(surroundings: Points, joints: Joints, load: Load, config: SweepConfig) -> bool:
    """Return whether nothing stands in the way of the arm on its way out to `joints`, or where it ends.

    Args:
        surroundings: (N, 3) points (m, base frame) of all that may be touched.
        joints: where the arm ends.
        load: what the gripper holds.
        config: the room it takes.
    """
    points = surroundings[np.hypot(surroundings[:, 0], surroundings[:, 1]) > FOOTPRINT]
    swept = _tube(joints, config), _gripper(joints, load, config)
    return not any(bool(np.any(box.holds(points))) for box in swept)


@dataclass(frozen=True)
class _SweptBox:
    """A box of the base frame (m) that reaches from the base out to y = -`end`."""

    middle: float
    half_width: float
    end: float
    low: float
    high: float

    def holds(self, points: Points) -> NDArray[np.bool_]:
        x, y, z = points.T
        beside = np.abs(x - self.middle) < self.half_width
        return beside & (y < 0) & (y > -self.end) & (z > self.low) & (z < self.high)


def _tube(joints: Joints, config: SweepConfig) -> _SweptBox:
    height, half = ARM_AXIS[1] + joints.lift, config.tube + config.margin
    return _SweptBox(ARM_AXIS[0], half, joints.arm - WRIST_YAW_AXIS[1], height - half, height + half)


def _gripper(joints: Joints, load: Load, config: SweepConfig) -> _SweptBox:
    x, y, z = gripper_to_base(joints)[:3, 3]
    wrist = ARM_AXIS[1] + joints.lift
    low = min(float(z) - max(config.gripper, load.below), wrist - config.tube)
    high = max(float(z) + config.gripper, wrist + config.tube)
    end = max(-float(y) + max(config.fingers, load.along_arm), joints.arm - WRIST_YAW_AXIS[1] + config.gripper)
    half_width = max(config.gripper, load.along_base) + config.margin
    return _SweptBox(float(x), half_width, end + config.margin, low - config.margin, high + config.margin)
