"""A skill: a conversation that gives moves and is answered with what the robot sees after each.

A skill is written as a generator, so that it reads as the sequence of motions it is:
`view = yield Move(action, reason)`.
"""

import math
from collections.abc import Generator
from dataclasses import dataclass, fields
from typing import TypeVar

from uniteam.interface import ACTION_LIMITS, Action, BaseDisplacement, DiscreteAction, JointDisplacement, Joints
from uniteam.mind.skills.view import View
from uniteam.stretch import clamp_joints

Result = TypeVar("Result")


@dataclass(frozen=True)
class Move:
    """One action of a skill, and one sentence of why."""

    action: Action
    reason: str


Skill = Generator[Move, View, Result]

SMALLEST_TURN = math.ceil(ACTION_LIMITS.least_turn * 1e4) / 1e4
"""rad; rounded up, so that no rounding on the way to the base makes a turn too small to be done."""
SMALLEST_DRIVE = ACTION_LIMITS.least_move
"""m."""
LONGEST_DRIVE = ACTION_LIMITS.most_move
"""m."""
_JOINT_TOLERANCE = 1e-3
_HEADING_TOLERANCE = 5e-3
"""rad."""


def turn(heading: float, reason: str) -> Move:
    """Return the move that turns the base by `heading` (rad, left-positive)."""
    return Move(BaseDisplacement(heading=heading), reason)


def turn_exactly(view: View, heading: float, reason: str) -> Skill[View]:
    """Turn the base by `heading` (rad, left-positive): where it makes no turn so small, by more and then back."""
    if abs(heading) >= SMALLEST_TURN:
        return (yield turn(heading, reason))
    if abs(heading) > _HEADING_TOLERANCE:
        beyond = math.copysign(2.0 * SMALLEST_TURN, heading)
        yield turn(heading + beyond, f"{reason[:-1]}, and beyond it.")
        view = yield turn(-beyond, "I turn back to it.")
    return view


def drive(distance: float, reason: str) -> Move:
    """Return the move that drives the base forward by `distance` (m)."""
    return Move(BaseDisplacement(x=distance), reason)


def discrete(action: DiscreteAction, reason: str) -> Move:
    """Return the move of a discrete action."""
    return Move(action, reason)


def move_joints(view: View, target: Joints, reason: str) -> Skill[View]:
    """Move the joints to `target` (clamped to their limits) in one step, or in none where they are there."""
    delta = clamp_joints(target) - view.observation.joints
    if all(abs(getattr(delta, f.name)) < _JOINT_TOLERANCE for f in fields(Joints)):
        return view
    return (yield Move(JointDisplacement(delta), reason))
