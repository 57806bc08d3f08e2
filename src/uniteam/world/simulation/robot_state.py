"""What an action asks of the base and the joints, and the samples of a motion between two states."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, fields, replace

from uniteam.geometry import BasePose, wrap_angle
from uniteam.interface import ACTION_LIMITS, BaseDisplacement, Joints
from uniteam.stretch import clamp_joints
from uniteam.world.physics.arm_shapes import FINGER_GAP

SAMPLE_TRAVEL = 0.02
"""No point of the arm travels further than this (m) from one sample of a motion to the next."""

_GRIPPER_REACH = 0.30
_ARM_REACH = 0.45
_TOLERANCE = 1e-9


@dataclass(frozen=True)
class RobotState:
    """Where the robot is: its base (world), its joints, and how far its fingers are apart (m)."""

    base: BasePose
    joints: Joints
    opening: float = FINGER_GAP


def admissible(displacement: BaseDisplacement) -> BaseDisplacement:
    """Return the displacement that a continuous action comes to: cut to the maxima, nothing below the minima."""
    return BaseDisplacement(
        _bounded(displacement.x, ACTION_LIMITS.least_move, ACTION_LIMITS.most_move),
        _bounded(displacement.y, ACTION_LIMITS.least_move, ACTION_LIMITS.most_move),
        _bounded(displacement.heading, ACTION_LIMITS.least_turn, ACTION_LIMITS.most_turn),
    )


def _bounded(value: float, least: float, most: float) -> float:
    return 0.0 if abs(value) < least - _TOLERANCE else min(max(value, -most), most)


def translated(state: RobotState, x: float, y: float) -> RobotState:
    """Return the state after the base has moved by x and y (m, base frame)."""
    return replace(state, base=state.base.compose(BasePose(x, y, 0.0)))


def turned(state: RobotState, heading: float) -> RobotState:
    """Return the state after the base has turned on the spot (rad)."""
    return replace(state, base=state.base.compose(BasePose(0.0, 0.0, heading)))


def with_joints(state: RobotState, joints: Joints) -> RobotState:
    """Return the state with the joints at the given positions, or as near as their ranges allow."""
    return replace(state, joints=clamp_joints(joints))


def samples(start: RobotState, end: RobotState, turn: float, held_radius: float) -> Iterator[RobotState]:
    """Yield the states of a motion after its start, the end among them, at most `SAMPLE_TRAVEL` apart.

    Args:
        start, end: the states at either end.
        turn: by how much the base turns on the way (rad); half a turn to the left is not one to the right.
        held_radius: how far what the gripper holds reaches from the grasp centre (m).
    """
    delta = end.joints - start.joints
    wrist = abs(delta.wrist_yaw) + abs(delta.wrist_pitch) + abs(delta.wrist_roll)
    reach = _ARM_REACH + held_radius + max(start.joints.arm, end.joints.arm)
    travel = start.base.distance_to(end.base.x, end.base.y) + reach * abs(turn)
    travel += abs(delta.lift) + abs(delta.arm) + (_GRIPPER_REACH + held_radius) * wrist
    count = max(1, math.ceil(travel / SAMPLE_TRAVEL))
    for k in range(1, count):
        yield _between(start, end, turn, k / count)
    yield end


def _between(start: RobotState, end: RobotState, turn: float, share: float) -> RobotState:
    base = BasePose(
        start.base.x + share * (end.base.x - start.base.x),
        start.base.y + share * (end.base.y - start.base.y),
        wrap_angle(start.base.heading + share * turn),
    )
    joints = start.joints if start.joints == end.joints else _blend(start.joints, end.joints, share)
    return RobotState(base, joints, end.opening)


def _blend(start: Joints, end: Joints, share: float) -> Joints:
    values = ((getattr(start, f.name), getattr(end, f.name)) for f in fields(Joints))
    return Joints(*(a + share * (b - a) for a, b in values))
