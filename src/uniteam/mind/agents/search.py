"""Searching for something on the map and driving to it, one step at a time."""

from dataclasses import dataclass
from enum import Enum, auto

import numpy as np

from uniteam.geometry import BasePose
from uniteam.interface import Action, DiscreteAction
from uniteam.mind.agents.blackboard import Memory
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.navigation.goals.exploration import ChooseGoal, plan_first
from uniteam.mind.navigation.goals.failed_attempts import Misses
from uniteam.mind.navigation.planning.planner import Plan
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.mind.skills.skill import Step
from uniteam.mind.skills.step_aside import step_aside
from uniteam.mind.skills.view import View
from uniteam.timing import section

FULL_TURN = 12
"""Turns of 30 degrees."""
BLOCKED_OFTEN = 3
"""Forward motions that were blocked one after the other."""
NEARLY_THERE = 0.6
"""m along the path."""


class Finding(Enum):
    """What a step of a search knows."""

    NOTHING = auto()
    IN_SIGHT = auto()
    GIVEN_UP = auto()


@dataclass(frozen=True)
class Search:
    """What is searched for.

    Attributes:
        target: the kind of goal that ends it.
        role: the class that is searched for.
    """

    target: GoalKind
    role: ClassRole


OBJECT_SEARCH = Search(GoalKind.OBJECT, ClassRole.OBJECT)
RECEPTACLE_SEARCH = Search(GoalKind.GOAL_RECEPTACLE, ClassRole.GOAL_RECEPTACLE)


def look_for(search: Search, memory: Memory, view: View) -> tuple[Step | None, Finding]:
    """Return the next step of a search, and what it knows; no step where the robot stands before what it searched."""
    aside = _go_on_aside(memory, view)
    if aside is not None:
        return aside, Finding.NOTHING
    base = view.observation.base_to_start
    choices, misses = _choices(search, memory)
    with section("planner"):
        choices = memory.commitment.choices([misses.avoided_by(choose) for choose in choices])
        found = plan_first(memory.planner, memory.bird_map, base, choices)
    if found is None:
        return _look_again(memory, misses)
    memory.idle_turns = 0
    goal, plan = memory.goal, memory.plan = found
    memory.commitment.follow(base, plan)
    finding = Finding.IN_SIGHT if goal.kind is search.target else Finding.NOTHING
    action = plan.action
    if finding is Finding.IN_SIGHT and _is_stuck_before(plan, memory):
        action = _turn_to_face(goal, memory, base)
    if action is not None:
        return Step(action, _reason(goal, plan, memory)), finding
    if finding is Finding.IN_SIGHT:
        memory.planner.interrupt()
        memory.commitment.set_out()
        return None, finding
    return Step(DiscreteAction.TURN_LEFT, f"I have come to the {_words(goal, memory)} and look around."), finding


def _go_on_aside(memory: Memory, view: View) -> Step | None:
    """Return the next step aside, where the robot is blocked too often or has not done with stepping aside."""
    if memory.detour is None and memory.config.gives_way(memory.planner.blocked_in_a_row):
        memory.planner.interrupt()
        memory.detour = step_aside(view, memory.generator)
        return next(memory.detour)
    try:
        return None if memory.detour is None else memory.detour.send(view)
    except StopIteration:
        memory.detour = None
        return None


def _is_stuck_before(plan: Plan, memory: Memory) -> bool:
    """Whether the robot is blocked so near to what it searched that it has as good as arrived."""
    return plan.reachable and memory.planner.blocked_in_a_row >= BLOCKED_OFTEN and plan.distance <= NEARLY_THERE


def _turn_to_face(goal: Goal, memory: Memory, base: BasePose) -> Action | None:
    """Return the turn that is missing to face the goal's nearest cell, or None."""
    cells = goal.cells if goal.face is None else goal.face
    points = memory.bird_map.to_points(np.argwhere(cells))
    nearest = points[np.argmin(np.hypot(points[:, 0] - base.x, points[:, 1] - base.y))]
    return memory.config.planner.face(base.bearing_to(*nearest))


def _choices(search: Search, memory: Memory) -> tuple[tuple[ChooseGoal, ...], Misses]:
    if search is OBJECT_SEARCH:
        return memory.config.search.for_object(), memory.object_misses
    return memory.config.search.for_receptacle(), memory.place_misses


def _look_again(memory: Memory, misses: Misses) -> tuple[Step | None, Finding]:
    """Turn once around where nothing is left to head for; then try again where an attempt has failed, or give up."""
    memory.idle_turns += 1
    if memory.idle_turns > FULL_TURN and not misses.made:
        return None, Finding.GIVEN_UP
    if memory.idle_turns > FULL_TURN:
        memory.idle_turns = 0
        misses.forget()
    return Step(DiscreteAction.TURN_LEFT, "Nothing is left that I can get to, so I look around again."), Finding.NOTHING


def _reason(goal: Goal, plan: Plan, memory: Memory) -> str:
    what = _words(goal, memory)
    if plan.short_term_goal is None:
        return f"I am at the {what} and turn to face it."
    if goal.kind is GoalKind.FRONTIER:
        return f"I have not found it yet and explore a frontier {plan.distance:.1f} m away."
    nearly = "" if plan.reachable else ", as near as I can get"
    return f"I know of the {what} and drive there{nearly} ({plan.distance:.1f} m to go)."


def _words(goal: Goal, memory: Memory) -> str:
    instruction = memory.instruction
    names = {
        GoalKind.OBJECT: instruction.object_category,
        GoalKind.START_RECEPTACLE: instruction.start_receptacle,
        GoalKind.GOAL_RECEPTACLE: instruction.goal_receptacle,
        GoalKind.FRONTIER: "frontier",
    }
    return names[goal.kind].replace("_", " ")


def faced_point(view: View, role: ClassRole) -> tuple[float, float]:
    """Return (x, y) (m, start frame) of the nearest thing of a role in view, or else of what is half a metre ahead."""
    base: BasePose = view.observation.base_to_start
    points = view.nearest(role, np.zeros(3))
    ahead = points[:, :2].mean(axis=0) if len(points) else np.array([0.5, 0.0])
    x, y = (base.matrix() @ [*ahead, 0.0, 1.0])[:2]
    return float(x), float(y)
