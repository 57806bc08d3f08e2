"""From an action to the motions that a Stretch makes of it, one after the other."""

import math
from dataclasses import dataclass, replace

from uniteam.geometry import wrap_angle
from uniteam.interface import ACTION_LIMITS, Action, BaseDisplacement, DiscreteAction, Joints
from uniteam.stretch import JOINT_LIMITS, MANIPULATION_POSTURE, NAVIGATION_POSTURE, clamp_joints
from uniteam.world.simulation.robot_state import admissible

QUARTER_TURN = math.pi / 2
EXTENDED_LIFT = 0.8
"""To which `EXTEND_ARM` brings the lift (m)."""
ARM_IS_IN = 0.05
"""Extension (m) up to which the arm is within the base's footprint."""


@dataclass(frozen=True)
class Turn:
    """Turn the base on the spot by an angle (rad, left-positive)."""

    angle: float

    def __str__(self) -> str:
        side = "left" if self.angle >= 0.0 else "right"
        return f"turn the base {side} by {abs(math.degrees(self.angle)):.0f} degrees"


@dataclass(frozen=True)
class Translate:
    """Drive the base straight ahead by a distance (m); back where it is negative."""

    distance: float

    def __str__(self) -> str:
        return f"drive the base {abs(self.distance):.2f} m {'ahead' if self.distance >= 0.0 else 'back'}"


@dataclass(frozen=True)
class MoveJoints:
    """Move every joint to a position."""

    joints: Joints

    def __str__(self) -> str:
        j = self.joints
        wrist = ", ".join(f"{math.degrees(angle):.0f}" for angle in (j.wrist_yaw, j.wrist_pitch, j.wrist_roll))
        head = f"{math.degrees(j.head_pan):.0f}, {math.degrees(j.head_tilt):.0f}"
        return (
            f"move the lift to {j.lift:.2f} m, the arm to {j.arm:.2f} m, the wrist to yaw, pitch and roll of {wrist} "
            f"degrees and the head to pan and tilt of {head}"
        )


@dataclass(frozen=True)
class Grip:
    """Close the gripper, or open it."""

    closed: bool

    def __str__(self) -> str:
        return "close the gripper" if self.closed else "open the gripper"


Motion = Turn | Translate | MoveJoints | Grip


def first_motions(joints: Joints) -> tuple[Motion, ...]:
    """Return the motions to where every run begins: arm in, gripper open, the navigation posture."""
    pull_in = (MoveJoints(replace(joints, arm=0.0)),) if joints.arm > ARM_IS_IN else ()
    return (*pull_in, Grip(closed=False), MoveJoints(NAVIGATION_POSTURE))


def motions_of(action: Action, joints: Joints) -> tuple[Motion, ...]:
    """Return what an action comes to.

    A base cannot go sideways: where it is asked to, it turns to where it is going, drives, and turns to where it is to
    look. Grasping is closing the gripper where it is.

    Args:
        action: checked before (`uniteam.world.task.check_action`).
        joints: where the joints are to be until now.
    """
    if isinstance(action, BaseDisplacement):
        return _base_motions(admissible(action))
    if isinstance(action, DiscreteAction):
        return _discrete_motions(action, joints)
    return (*_base_motions(admissible(action.base)), MoveJoints(clamp_joints(joints + action.delta)))


def _base_motions(base: BaseDisplacement) -> tuple[Motion, ...]:
    if base.y != 0.0:
        bearing, distance = math.atan2(base.y, base.x), math.hypot(base.x, base.y)
        motions: tuple[Motion, ...] = (Turn(bearing), Translate(distance), Turn(wrap_angle(base.heading - bearing)))
    else:
        motions = (Translate(base.x), Turn(base.heading))
    return tuple(motion for motion in motions if motion not in (Turn(0.0), Translate(0.0)))


def _discrete_motions(action: DiscreteAction, joints: Joints) -> tuple[Motion, ...]:
    lifted = replace(joints, lift=EXTENDED_LIFT)
    motions: dict[DiscreteAction, tuple[Motion, ...]] = {
        DiscreteAction.STOP: (),
        DiscreteAction.EMPTY_ACTION: (),
        DiscreteAction.MOVE_FORWARD: (Translate(ACTION_LIMITS.forward_step),),
        DiscreteAction.TURN_LEFT: (Turn(ACTION_LIMITS.turn_step),),
        DiscreteAction.TURN_RIGHT: (Turn(-ACTION_LIMITS.turn_step),),
        DiscreteAction.NAVIGATION_MODE: (MoveJoints(NAVIGATION_POSTURE),),
        DiscreteAction.MANIPULATION_MODE: (Turn(QUARTER_TURN), MoveJoints(MANIPULATION_POSTURE)),
        DiscreteAction.EXTEND_ARM: (MoveJoints(lifted), MoveJoints(replace(lifted, arm=JOINT_LIMITS[1].arm))),
        DiscreteAction.SNAP_OBJECT: (Grip(closed=True),),
        DiscreteAction.DESNAP_OBJECT: (Grip(closed=False),),
    }
    return motions[action]
