"""From what a policy gives to an action of the robot: numbers in [-1, 1] by column, or one of some actions.

Columns, thresholds and steps are those of HomeRobot's skills (arXiv 2306.11565; habitat-lab's OVMM branch). One thing
is done a step: to stop goes before the gripper, the gripper before a mode, a mode before a motion.
"""

import math
from dataclasses import dataclass, fields
from typing import Any, Protocol

import gymnasium
import numpy as np
from numpy.typing import NDArray

from uniteam.adapters.action_vector import action_bounds, action_of
from uniteam.errors import InvalidActionError
from uniteam.interface import (
    ACTION_LIMITS,
    Action,
    BaseDisplacement,
    DiscreteAction,
    JointDisplacement,
    Joints,
)
from uniteam.stretch import looks_along_arm

FORWARD, TURN, SELECTOR = "forward", "turn", "selector"
STOP, GRIP = "stop", "grip"
MANIPULATION_MODE, NAVIGATION_MODE = "manipulation_mode", "navigation_mode"
BASE = (FORWARD, TURN, SELECTOR)
ARM = ("arm", "lift", "wrist_yaw", "wrist_pitch", "wrist_roll")

GRIP_THRESHOLD = 0.8
"""From here on the gripper takes, and from its negative on it lets go."""
MODE_THRESHOLD = 0.8
"""Above this the robot takes the posture of a mode."""
JOINT_STEP, LEAST_JOINT_STEP = 0.1, 0.02
"""The longest and the shortest motion of a joint in a step (m or rad); a shorter one is not done."""

_JOINTS = tuple(field.name for field in fields(Joints))


class Controls(Protocol):
    """A way to act."""

    @property
    def space(self) -> gymnasium.Space[Any]:
        """What a policy may give."""

    def read(self, given: Any, joints: Joints, is_holding: bool) -> Action:
        """Return the action, for a robot with its joints there; raises InvalidActionError where it is none."""


@dataclass(frozen=True)
class Columns:
    """An action as a vector, each number of which has a meaning by its name.

    `forward` is times 0.25 m and `turn` times 30 degrees (left-positive), of which `selector` lets one be done: where
    it is positive the drive, else the turn. A joint's column is times 0.1 m or rad. `stop` above 0 ends the episode,
    `grip` from 0.8 on takes and down from -0.8 lets go, a mode above 0.8 takes its posture. While the head looks along
    the arm the base is locked.

    Attributes:
        names: of the numbers, in their order.
    """

    names: tuple[str, ...]

    @property
    def space(self) -> gymnasium.spaces.Box:
        """(N,) float32 in [-1, 1]."""
        return gymnasium.spaces.Box(-1.0, 1.0, (len(self.names),), np.float32)

    def read(self, given: Any, joints: Joints, is_holding: bool) -> Action:
        """Return the action of N numbers; what is beyond -1 and 1 is cut."""
        asked = dict(zip(self.names, self._numbers(given).tolist(), strict=True))
        is_at_arm = looks_along_arm(joints)
        if asked.get(STOP, -1.0) > 0.0:
            return DiscreteAction.STOP
        if not is_holding and asked.get(GRIP, 0.0) >= GRIP_THRESHOLD:
            return DiscreteAction.SNAP_OBJECT
        if is_holding and asked.get(GRIP, 0.0) <= -GRIP_THRESHOLD:
            return DiscreteAction.DESNAP_OBJECT
        if not is_at_arm and asked.get(MANIPULATION_MODE, 0.0) > MODE_THRESHOLD:
            return DiscreteAction.MANIPULATION_MODE
        if asked.get(NAVIGATION_MODE, 0.0) > MODE_THRESHOLD:
            return DiscreteAction.NAVIGATION_MODE
        base = BaseDisplacement() if is_at_arm else _base(asked)
        delta = Joints(*(_joint_step(asked.get(name, 0.0)) for name in _JOINTS))
        return base if delta == _STILL else JointDisplacement(delta, base)

    def _numbers(self, given: Any) -> NDArray[np.float64]:
        try:
            numbers = np.asarray(given, np.float64)
        except (TypeError, ValueError) as error:
            raise InvalidActionError(f"an action must be {len(self.names)} numbers, got {given!r}") from error
        if numbers.shape != (len(self.names),) or not np.isfinite(numbers).all():
            raise InvalidActionError(
                f"an action must be {len(self.names)} finite numbers ({', '.join(self.names)}), got {numbers}"
            )
        return np.clip(numbers, -1.0, 1.0)


@dataclass(frozen=True)
class Metric:
    """An action as the 15 numbers that datasets hold, in metres and radians (`uniteam.adapters.action_vector`)."""

    @property
    def space(self) -> gymnasium.spaces.Box:
        """(15,) float32."""
        return gymnasium.spaces.Box(*action_bounds(), dtype=np.float32)

    def read(self, given: Any, joints: Joints, is_holding: bool) -> Action:
        """Return the action of 15 numbers; what is beyond the bounds is cut."""
        return action_of(given)


@dataclass(frozen=True)
class Choice:
    """An action as the number of one of some actions.

    Attributes:
        actions: what the numbers mean, from 0 on.
    """

    actions: tuple[Action, ...]

    @property
    def space(self) -> gymnasium.spaces.Discrete:
        """The numbers of the actions."""
        return gymnasium.spaces.Discrete(len(self.actions))

    def read(self, given: Any, joints: Joints, is_holding: bool) -> Action:
        """Return the action of a number."""
        if not self.space.contains(given):
            raise InvalidActionError(
                f"an action must be a whole number from 0 to {len(self.actions) - 1}, got {given!r}"
            )
        return self.actions[int(given)]


EVERY_ACTION = Choice(tuple(DiscreteAction))
"""The challenge's discrete actions in the order of `DiscreteAction`."""

FOUR_MOVES = Choice(
    (
        DiscreteAction.STOP,
        DiscreteAction.MOVE_FORWARD,
        BaseDisplacement(heading=math.radians(10.0)),
        BaseDisplacement(heading=-math.radians(10.0)),
    )
)
"""Stop, 0.25 m ahead, 10 degrees to the left and to the right: HomeRobot's learned navigation at test time."""

_STILL = Joints(*(0.0 for _ in _JOINTS))


def _base(asked: dict[str, float]) -> BaseDisplacement:
    if asked.get(SELECTOR, 0.0) > 0.0:
        return BaseDisplacement(x=asked[FORWARD] * ACTION_LIMITS.forward_step)
    return BaseDisplacement(heading=asked.get(TURN, 0.0) * ACTION_LIMITS.turn_step)


def _joint_step(share: float) -> float:
    step = share * JOINT_STEP
    return 0.0 if abs(step) < LEAST_JOINT_STEP else step
