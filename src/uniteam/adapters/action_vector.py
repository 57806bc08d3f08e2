"""An action as a vector of named numbers in metres and radians, and back: what datasets and policies hold of it.

A displacement is in the columns that end in `.delta`. What is done as a whole has a column each, which is 1 where it is
done, and so has the gripper: 1 closes it, -1 opens it.
"""

import math
from dataclasses import fields

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidActionError
from uniteam.interface import ACTION_LIMITS, Action, BaseDisplacement, DiscreteAction, JointDisplacement, Joints
from uniteam.stretch import JOINT_LIMITS

Vector = NDArray[np.float32]

THRESHOLD = 0.5
"""Above which a column of something done as a whole has it done."""

_BASE = ("base_x", "base_y", "base_heading")
_JOINTS = tuple(field.name for field in fields(Joints))
_MOVES = (*_BASE, *_JOINTS)
_GRIPPER, _STOP = "gripper", "stop"
_POSTURES = {
    "navigation_mode": DiscreteAction.NAVIGATION_MODE,
    "manipulation_mode": DiscreteAction.MANIPULATION_MODE,
    "extend_arm": DiscreteAction.EXTEND_ARM,
}

ACTION_NAMES = (*(f"{name}.delta" for name in _MOVES), _GRIPPER, *_POSTURES, _STOP)
"""Of the numbers, in their order."""

_WHOLE = {
    DiscreteAction.SNAP_OBJECT: (_GRIPPER, 1.0),
    DiscreteAction.DESNAP_OBJECT: (_GRIPPER, -1.0),
    DiscreteAction.STOP: (_STOP, 1.0),
    **{action: (name, 1.0) for name, action in _POSTURES.items()},
}
_MOVING = {
    DiscreteAction.MOVE_FORWARD: BaseDisplacement(x=ACTION_LIMITS.forward_step),
    DiscreteAction.TURN_LEFT: BaseDisplacement(heading=ACTION_LIMITS.turn_step),
    DiscreteAction.TURN_RIGHT: BaseDisplacement(heading=-ACTION_LIMITS.turn_step),
    DiscreteAction.EMPTY_ACTION: BaseDisplacement(),
}


def action_bounds() -> tuple[Vector, Vector]:
    """Return the least and the most of each number, (15,) each."""
    low, high = JOINT_LIMITS
    reach = [getattr(high, name) - getattr(low, name) for name in _JOINTS]
    base = [ACTION_LIMITS.most_move, ACTION_LIMITS.most_move, ACTION_LIMITS.most_turn]
    most = np.array([*base, *reach, *(1.0 for _ in (_GRIPPER, *_POSTURES, _STOP))], np.float32)
    return -most, most


def vector_of(action: Action) -> Vector:
    """Return an action's (15,) numbers in the order of `ACTION_NAMES`."""
    numbers = dict.fromkeys(ACTION_NAMES, 0.0)
    if action in _WHOLE:
        name, value = _WHOLE[action]
        return np.array(list((numbers | {name: value}).values()), np.float32)
    moved = _MOVING[action] if isinstance(action, DiscreteAction) else action
    base = moved.base if isinstance(moved, JointDisplacement) else moved
    numbers |= {f"base_{name}.delta": value for name, value in vars(base).items()}
    if isinstance(moved, JointDisplacement):
        numbers |= {f"{name}.delta": value for name, value in vars(moved.delta).items()}
    return np.array(list(numbers.values()), np.float32)


def action_of(given: object) -> Action:
    """Return the action of 15 numbers; what is beyond the bounds is cut.

    One thing is done: to stop goes before the gripper, the gripper before a posture, a posture before a motion.

    Raises:
        InvalidActionError: these are not 15 finite numbers.
    """
    low, high = action_bounds()
    numbers = dict(zip(ACTION_NAMES, np.clip(_numbers(given), low, high).tolist(), strict=True))
    if numbers[_STOP] > THRESHOLD:
        return DiscreteAction.STOP
    if abs(numbers[_GRIPPER]) > THRESHOLD:
        return DiscreteAction.SNAP_OBJECT if numbers[_GRIPPER] > 0.0 else DiscreteAction.DESNAP_OBJECT
    for name, action in _POSTURES.items():
        if numbers[name] > THRESHOLD:
            return action
    base = BaseDisplacement(*(numbers[f"{name}.delta"] for name in _BASE))
    delta = Joints(*(numbers[f"{name}.delta"] for name in _JOINTS))
    return JointDisplacement(delta, base) if any(vars(delta).values()) else base


def _numbers(given: object) -> NDArray[np.float64]:
    wanted = f"an action must be {len(ACTION_NAMES)} finite numbers ({', '.join(ACTION_NAMES)})"
    try:
        numbers = np.asarray(given, np.float64)
    except (TypeError, ValueError) as error:
        raise InvalidActionError(f"{wanted}, got {given!r}") from error
    if numbers.shape != (len(ACTION_NAMES),) or not all(map(math.isfinite, numbers)):
        raise InvalidActionError(f"{wanted}, got {numbers}")
    return numbers
