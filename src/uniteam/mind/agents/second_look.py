"""Looking at what is doubted from another side, before the robot acts on it (`second_look`)."""

from dataclasses import replace
from typing import TypeVar

import numpy as np

from uniteam.geometry import Point2
from uniteam.mind.agents.blackboard import Blackboard
from uniteam.mind.agents.search import Approach, Search, approach, faced_point, words_of
from uniteam.mind.navigation.goals.failed_attempts import Misses
from uniteam.mind.navigation.goals.other_side import OtherSide
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.mind.skills.skill import Skill
from uniteam.mind.skills.view import View

SAME_THING = 1.0
"""m; what lies so near to what was looked at again is not doubted once more."""
RECOGNISED_WITHIN = 0.8
"""m; what is recognised so near to the target is the target."""

Result = TypeVar("Result")


def is_doubted(board: Blackboard, view: View, role: ClassRole) -> bool:
    """Return whether what the robot stands before should be looked at again; everything is so once at most."""
    x, y = faced_point(view, role)
    is_new = all(np.hypot(x - seen[0], y - seen[1]) > SAME_THING for seen in board.looked_again)
    return is_new and board.config.doubts(view, role)


def go_aside(board: Blackboard, view: View, search: Search, role: ClassRole, target: Point2) -> Skill[Approach]:
    """Drive to where a target (m, start frame) is seen from another side; LOST where there is no such place near by."""
    base = view.observation.base_to_start
    board.looked_again.append(target)
    side = OtherSide(search.target, role, target, (base.x, base.y))
    aside = Search(search.target, lambda config: (side,), lambda board: Misses())
    reason = f"I am not sure of the {words_of(board, search.target)} and look from another side."
    return (yield from _saying(approach(board, view, aside), reason))


def is_recognised(view: View, role: ClassRole, target: Point2) -> bool:
    """Return whether a target (m, start frame) is believed to be what its role asks for, as it is seen now."""
    points = view.points(role)
    if len(points) == 0:
        return False
    to_start = view.observation.base_to_start.matrix()
    there = points[:, :2] @ to_start[:2, :2].T + to_start[:2, 3]
    return bool(np.hypot(*(there - np.array(target)).T).min() < RECOGNISED_WITHIN)


def _saying(skill: Skill[Result], reason: str) -> Skill[Result]:
    """Carry out a skill, and give one reason for all its moves."""
    try:
        move = next(skill)
        while True:
            move = skill.send((yield replace(move, reason=reason)))
    except StopIteration as end:
        result: Result = end.value
        return result
