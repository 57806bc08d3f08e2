"""Actions and measures in words."""

import math
from dataclasses import fields

from uniteam.interface import Action, BaseDisplacement, DiscreteAction, Joints
from uniteam.world.task.measures import Measures

MILESTONES = {
    "find_object_phase_success": "found object",
    "pick_object_phase_success": "picked object",
    "find_recep_phase_success": "found receptacle",
    "place_success": "placed",
    "overall_success": "overall success",
}
"""The measures that are true or false, in the order in which they are reached."""


def describe_action(action: Action) -> str:
    """Return an action in a few words, lengths in metres and angles in degrees."""
    if isinstance(action, DiscreteAction):
        return action.value.replace("_", " ")
    if isinstance(action, BaseDisplacement):
        return _describe_base(action) or "stay"
    parts = [_describe_base(action.base), *_describe_joints(action.delta)]
    return ", ".join(part for part in parts if part) or "stay"


def new_milestones(before: Measures, after: Measures) -> list[str]:
    """Return the measures that became true in between, in words."""
    return [words for name, words in MILESTONES.items() if getattr(after, name) and not getattr(before, name)]


def _describe_base(base: BaseDisplacement) -> str:
    parts = []
    if base.x:
        parts.append(f"base {abs(base.x):.2f} m {'forward' if base.x > 0 else 'back'}")
    if base.y:
        parts.append(f"base {abs(base.y):.2f} m {'left' if base.y > 0 else 'right'}")
    if base.heading:
        parts.append(f"turn {abs(math.degrees(base.heading)):.0f}° {'left' if base.heading > 0 else 'right'}")
    return ", ".join(parts)


def _describe_joints(delta: Joints) -> list[str]:
    lengths = {"lift", "arm"}
    moved = ((f.name, getattr(delta, f.name)) for f in fields(Joints))
    return [
        f"{name.replace('_', ' ')} {value:+.2f} m" if name in lengths
        else f"{name.replace('_', ' ')} {math.degrees(value):+.0f}°"
        for name, value in moved
        if abs(value) > 1e-6
    ]  # fmt: skip
