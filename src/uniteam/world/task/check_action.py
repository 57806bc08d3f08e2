"""What an environment does with an action before anything moves: refuse what is none, and take its plain numbers."""

import math
from dataclasses import fields

import numpy as np

from uniteam.errors import InvalidActionError
from uniteam.interface import Action, BaseDisplacement, Decision, DiscreteAction, JointDisplacement, Joints

_KINDS = "a DiscreteAction, a BaseDisplacement or a JointDisplacement"


def checked_action(action: object) -> Action:
    """Return an action with Python's own floats, whatever numbers it was given in.

    Raises:
        InvalidActionError: it is no action, or a number of it is none or not finite.
    """
    if isinstance(action, DiscreteAction):
        return action
    if type(action) is BaseDisplacement:
        return _base(action, "BaseDisplacement")
    if type(action) is JointDisplacement:
        return _joints(action)
    raise InvalidActionError(f"a step takes {_KINDS}, got {_called(action)}; {_remedy(action)}")


def _base(base: BaseDisplacement, name: str) -> BaseDisplacement:
    return BaseDisplacement(*(_number(base, field.name, name) for field in fields(BaseDisplacement)))


def _joints(action: JointDisplacement) -> JointDisplacement:
    delta, base = (getattr(action, field.name, None) for field in fields(JointDisplacement))
    if type(delta) is not Joints:
        raise InvalidActionError(f"the delta of a JointDisplacement is {_called(delta)}; give it Joints")
    if type(base) is not BaseDisplacement:
        raise InvalidActionError(f"the base of a JointDisplacement is {_called(base)}; give it a BaseDisplacement")
    numbers = (_number(delta, field.name, "JointDisplacement.delta") for field in fields(Joints))
    return JointDisplacement(Joints(*numbers), _base(base, "JointDisplacement.base"))


def _number(owner: object, field: str, name: str) -> float:
    value = getattr(owner, field, None)
    if isinstance(value, bool) or not isinstance(value, float | int | np.floating | np.integer):
        raise InvalidActionError(f"{name}.{field} is {_called(value)}; give it a number (m or rad)")
    try:
        number = float(value)
    except (OverflowError, TypeError, ValueError):
        number = math.inf
    if not math.isfinite(number):
        raise InvalidActionError(f"{name}.{field} is not a finite number; give it one (m or rad)")
    return number


def _called(value: object) -> str:
    """Return what to call a value in a sentence: nothing of what it holds, which may be anything."""
    return "None" if value is None else "a class" if isinstance(value, type) else f"a {type(value).__name__[:50]}"


def _remedy(action: object) -> str:
    if isinstance(action, Decision):
        return "give the decision's own action: step(decision.action)"
    if isinstance(action, str):
        return f"the discrete actions are {', '.join(a.name for a in DiscreteAction)}: DiscreteAction.TURN_LEFT"
    if action is None:
        return "DiscreteAction.EMPTY_ACTION lets a step pass"
    if isinstance(action, BaseDisplacement | JointDisplacement):
        return "a class derived from one is not taken"
    return "a number says nothing by itself" if isinstance(action, int | float | np.number) else "give one of them"
