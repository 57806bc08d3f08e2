"""Whether the arm gets there without touching anything that is seen.

The arm leaves the robot to its right, along -y of the base, at one height. What it sweeps is a few boxes, one behind
the other: the tube, the gripper and what hangs in it.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.interface import Joints
from uniteam.mind.skills.view import Points
from uniteam.stretch import ARM_AXIS, BASE_RADIUS, WRIST_PITCH_AXIS, WRIST_YAW_AXIS, gripper_to_base


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

    def enclosing(self, other: "Load") -> "Load":
        """Return the room that is enough for either; a thing in part out of view looks smaller than it is."""
        return Load(
            max(self.along_base, other.along_base), max(self.along_arm, other.along_arm), max(self.below, other.below)
        )


EMPTY_GRIPPER = Load(0.0, 0.0, 0.0)

_ROUNDING = 1e-4
"""m; more than what numbers of single precision are off by."""


@dataclass(frozen=True)
class SweepConfig:
    """The room the arm takes (m), measured on Stretch with the dexterous wrist.

    Attributes:
        tube_side, tube_width: where the middle of the arm's tube is along the base, with the wrist's carrier, and half
            the width of both.
        tube_height: half its height.
        wrist: how far the wrist's carrier reaches beyond the yaw axis.
        hand: half the width of the gripper, and how far it reaches below the grasp centre or above the pitch axis.
        fingers: how far the fingers reach beyond the grasp centre.
        margin: the distance to be kept to everything.
    """

    tube_side: float = -0.064
    tube_width: float = 0.07
    tube_height: float = 0.032
    wrist: float = 0.04
    hand: float = 0.05
    fingers: float = 0.025
    margin: float = 0.04


def is_sweep_free(surroundings: Points, joints: Joints, load: Load, config: SweepConfig) -> bool:
    """Return whether nothing stands in the way of the arm on its way out to `joints`, or where it ends.

    Args:
        surroundings: (N, 3) points (m, base frame) of all that may be touched.
        joints: where the arm ends.
        load: what the gripper holds.
        config: the room it takes.
    """
    swept = _tube(joints, config), _hand(joints, config), _load(joints, load, config)
    points = _near(surroundings, swept, config.margin)
    points = points[np.hypot(points[:, 0], points[:, 1]) > BASE_RADIUS]
    return not any(bool(np.any(box.holds(points, config.margin))) for box in swept)


@dataclass(frozen=True)
class _SweptBox:
    """A box of the base frame (m) that reaches from the base out to y = -`end`."""

    middle: float
    half_width: float
    end: float
    low: float
    high: float

    def holds(self, points: Points, margin: float) -> NDArray[np.bool_]:
        x, y, z = points.T
        beside = np.abs(x - self.middle) < self.half_width + margin
        before = (y < 0) & (y > -self.end - margin)
        return beside & before & (z > self.low - margin) & (z < self.high + margin)


def _near(points: Points, boxes: tuple[_SweptBox, ...], margin: float) -> Points:
    """Return the points that any of the boxes might hold, by x and z alone: to look at all in full takes long."""
    x, _, z = points.T
    more = margin + _ROUNDING
    is_beside = (x > min(b.middle - b.half_width for b in boxes) - more) & (
        x < max(b.middle + b.half_width for b in boxes) + more
    )
    return points[is_beside & (z > min(b.low for b in boxes) - more) & (z < max(b.high for b in boxes) + more)]


def _tube(joints: Joints, config: SweepConfig) -> _SweptBox:
    height = ARM_AXIS[1] + joints.lift
    end = joints.arm - WRIST_YAW_AXIS[1] + config.wrist
    low, high = height - config.tube_height, height + config.tube_height
    return _SweptBox(config.tube_side, config.tube_width, end, low, high)


def _hand(joints: Joints, config: SweepConfig) -> _SweptBox:
    x, y, z = (float(value) for value in gripper_to_base(joints)[:3, 3])
    pitch_axis = WRIST_PITCH_AXIS[2] + joints.lift
    end = max(-y + config.fingers, joints.arm - WRIST_PITCH_AXIS[1] + config.hand)
    low, high = min(z, pitch_axis) - config.hand, max(z, pitch_axis) + config.hand
    return _SweptBox(x, config.hand, end, low, high)


def _load(joints: Joints, load: Load, config: SweepConfig) -> _SweptBox:
    x, y, z = (float(value) for value in gripper_to_base(joints)[:3, 3])
    return _SweptBox(x, load.along_base, -y + load.along_arm, z - load.below, z)
