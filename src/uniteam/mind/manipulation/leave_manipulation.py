"""Back to driving: fold the arm, and turn the base back or not (`turn_back`)."""

import math

from uniteam.interface import DiscreteAction
from uniteam.mind.skills.skill import Skill, discrete, turn
from uniteam.mind.skills.view import View
from uniteam.stretch import looks_along_arm

QUARTER = math.pi / 2


def fold(view: View, reason: str) -> Skill[View]:
    """Fold the arm and look ahead, wherever the base faces, as HomeRobot does."""
    return (yield discrete(DiscreteAction.NAVIGATION_MODE, reason))


def fold_and_turn_back(view: View, reason: str) -> Skill[View]:
    """Fold the arm and face again where the arm pointed; a body whose base turns back by itself is not turned twice."""
    before = view.observation.base_to_start.heading
    pointed_aside = looks_along_arm(view.observation.joints)
    view = yield from fold(view, reason)
    if pointed_aside and quarters_turned(before, view) == 0:
        view = yield turn(-QUARTER, "I turn back to where I faced.")
    return view


def quarters_turned(before: float, view: View) -> int:
    """Return by how many quarters of a circle (left-positive) the base has turned from a heading (rad)."""
    return round(math.remainder(view.observation.base_to_start.heading - before, 2 * math.pi) / QUARTER)
