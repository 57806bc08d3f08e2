"""An action as plain data."""

from dataclasses import asdict, astuple
from typing import Any

import msgspec

from uniteam.errors import InvalidInputError
from uniteam.interface import Action, BaseDisplacement, DiscreteAction, JointDisplacement, Joints


class ActionData(msgspec.Struct, forbid_unknown_fields=True, omit_defaults=True):
    """An action: the name of a discrete one, or displacements of the base (x, y, heading) and of the joints."""

    discrete: str | None = None
    base: tuple[float, float, float] | None = None
    joints: dict[str, float] | None = None


def action_to_data(action: Action) -> ActionData:
    """Return what is written of an action."""
    if isinstance(action, DiscreteAction):
        return ActionData(discrete=action.value)
    if isinstance(action, BaseDisplacement):
        return ActionData(base=astuple(action))
    return ActionData(base=astuple(action.base), joints=asdict(action.delta))


def action_from_data(data: ActionData) -> Action:
    """Return the action; raises InvalidInputError where the data is of none."""
    known: dict[str, Any] = {action.value: action for action in DiscreteAction}
    if data.discrete in known and data.base is None and data.joints is None:
        return DiscreteAction(data.discrete)
    if data.discrete is not None or data.base is None:
        raise InvalidInputError("an action must be a discrete one's name, or a displacement")
    base = BaseDisplacement(*data.base)
    if data.joints is None:
        return base
    try:
        return JointDisplacement(Joints(**data.joints), base)
    except TypeError as error:
        raise InvalidInputError(f"an action's joints are none: {error}") from error
