"""Searching for something on the map and driving to it: two skills that plan anew in every step."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum, auto
from functools import partial

import numpy as np

from uniteam.geometry import BasePose
from uniteam.grid import disc_mask
from uniteam.interface import DiscreteAction
from uniteam.mind.agents.blackboard import Blackboard
from uniteam.mind.agents.last_round import Relaxation
from uniteam.mind.manipulation.place.after_release import Lying
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.navigation.goals.exploration import ChooseGoal, SearchConfig
from uniteam.mind.navigation.goals.failed_attempts import Misses
from uniteam.mind.navigation.planning.collision_mapping import forget_all
from uniteam.mind.navigation.planning.plan import Plan
from uniteam.mind.navigation.planning.planner import BLOCKED_OFTEN
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.mind.skills.skill import Move, Skill
from uniteam.mind.skills.step_aside import step_aside
from uniteam.mind.skills.view import View
from uniteam.timing import section

FULL_TURN = 12
"""Turns of 30 degrees."""


@dataclass(frozen=True)
class Search:
    """What is searched for.

    Attributes:
        target: the kind of goal that ends it.
        choices: what to head for, in order of preference.
        misses: where it has been tried in vain.
    """

    target: GoalKind
    choices: Callable[[SearchConfig], tuple[ChooseGoal, ...]]
    misses: Callable[[Blackboard], Misses]


OBJECT_SEARCH = Search(GoalKind.OBJECT, SearchConfig.for_object, lambda board: board.object_misses)
RECEPTACLE_SEARCH = Search(GoalKind.GOAL_RECEPTACLE, SearchConfig.for_receptacle, lambda board: board.place_misses)


FALLEN_WITHIN = 0.3
"""m; an object so near to where one was seen to fall is that one."""
SAME_PLACE = 0.3
"""m; from a place so near nothing else is seen."""


class Approach(Enum):
    """How an approach ended."""

    ARRIVED = auto()
    LOST = auto()
    BLOCKED = auto()


def look_around(board: Blackboard, view: View) -> Skill[View]:
    """Turn around on the spot, until enough has been seen."""
    look, turns = board.config.first_look, board.config.first_turns
    for turn in range(1, turns + 1):
        if look.is_enough(board.bird_map):
            break
        view = yield Move(look.side, f"I look around first ({turn} of {turns} turns).")
    return view


def explore(board: Blackboard, view: View, search: Search) -> Skill[bool]:
    """Drive to what may show the target until it is known, stepping aside where the way is blocked again and again.

    Returns:
        True once there is a target to head for; False once nothing is left that the robot can get to.
    """
    misses, idle_turns, idle_at = search.misses(board), 0, view.observation.base_to_start
    while True:
        base = view.observation.base_to_start
        found = _plan(board, view, search)
        if found is not None and board.config.search.goes_on(board.planner, found[1]):
            if found[0].kind is search.target:
                return True
            if base.distance_to(idle_at.x, idle_at.y) > SAME_PLACE:  # to face one thing after another is idle too
                idle_turns = 0
            _remember_failure(board)
            move = _carry_out(board, view, *found)
        else:
            if found is not None:  # the robot stays blocked while it turns, and steps aside in the end
                board.planner.begin(found[1], board.bird_map, base)
            idle_turns, idle_at = idle_turns + 1, base
            if idle_turns > _turns_worth_making(board, view):
                board.turned_at = base
                if not (misses.made or _relax(board)):
                    return False
                idle_turns = 0
                misses.forget()
            reason = "Nothing is left that I can get to, so I look around again."
            move = Move(DiscreteAction.TURN_LEFT, reason)
        view = yield move
        if board.config.steps_aside(board.planner.blocked_in_a_row):
            view = yield from get_away(board, view)


def _turns_worth_making(board: Blackboard, view: View) -> int:
    """Return how many turns may show something new: none where the robot has just turned all the way round."""
    base, turned_at = view.observation.base_to_start, board.turned_at
    is_new_here = turned_at is None or turned_at.distance_to(base.x, base.y) > SAME_PLACE
    return FULL_TURN if is_new_here else 0


def approach(board: Blackboard, view: View, search: Search) -> Skill[Approach]:
    """Drive to the target and face it, as long as there is one to head for and the way is not blocked too often."""
    rules = board.config.search
    while True:
        found = _plan(board, view, search)
        if found is None or found[0].kind is not search.target or not rules.goes_on(board.planner, found[1]):
            return Approach.LOST
        goal, plan = found
        has_arrived = rules.has_arrived(board.planner, plan)
        if not has_arrived:
            _remember_failure(board)
        move = _carry_out(board, view, goal, plan)
        action = plan.action
        if has_arrived:
            action = board.planner.turn_to_face(board.bird_map, view.observation.base_to_start, goal)
        if action is None:
            board.planner.interrupt()
            board.commitment.set_out()
            return Approach.ARRIVED
        view = yield Move(action, move.reason)
        if board.config.steps_aside(board.planner.blocked_in_a_row):
            return Approach.BLOCKED


def get_away(board: Blackboard, view: View) -> Skill[View]:
    """Leave the place where the robot is blocked."""
    board.planner.interrupt()
    return (yield from step_aside(view, board.generator))


def _plan(board: Blackboard, view: View, search: Search) -> tuple[Goal, Plan] | None:
    """Return what to head for and how; None where there is nothing but to try again what failed here."""
    misses = search.misses(board)
    with section("planner"):
        wanted = [misses.avoided_by(choose) for choose in _choices(board, search)]
        choices = [_but_failed_goals(board, choose) for choose in board.commitment.choices(wanted)]
        base = view.observation.base_to_start
        found = board.config.search.pursue(board.planner, board.bird_map, base, choices, search.target)
    is_in_vain = found is not None and bool(misses.made) and not found[0].cells.any()
    return None if is_in_vain else found


def _choices(board: Blackboard, search: Search) -> tuple[ChooseGoal, ...]:
    """Return what to head for, in order of preference: first of all to where the object was seen to fall."""
    choices = search.choices(board.search)
    return choices if board.lying is None else (partial(_fallen_object, board.lying), *choices)


def _fallen_object(lying: Lying, bird_map: BirdsEyeMap, base: BasePose) -> Goal:
    """Return the goal of standing before the object where it fell, wherever that is."""
    cell = bird_map.to_cell(lying.x, lying.y)
    around = disc_mask(bird_map.shape, cell, round(FALLEN_WITHIN / bird_map.cell_size))
    seen = bird_map.class_cells(ClassRole.OBJECT) & around
    cells = seen if seen.any() else disc_mask(bird_map.shape, cell, 1)
    return Goal(GoalKind.OBJECT, cells, face=cells)


def _but_failed_goals(board: Blackboard, choose: ChooseGoal) -> ChooseGoal:
    def elsewhere(bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
        goal = choose(bird_map, base)
        return None if goal is None else board.failed_goals.avoid(goal, bird_map, bird_map.update_count)

    return elsewhere


def _relax(board: Blackboard) -> bool:
    """Forget something that keeps the robot from places; return False where it gives up instead."""
    relaxation = board.config.relax(board.rounds)
    board.rounds += 1
    if relaxation is Relaxation.FAILED_GOALS:
        board.failed_goals.forget()
    elif relaxation is Relaxation.COLLISIONS:
        forget_all(board.bird_map)
    elif relaxation is Relaxation.EXPLORED:
        board.bird_map.forget_explored()
    elif relaxation is Relaxation.LOOKS:
        board.bird_map.forget_looks()
        board.search = board.config.search.for_another_look()
    return relaxation is not None


def _carry_out(board: Blackboard, view: View, goal: Goal, plan: Plan) -> Move:
    """Begin a plan and return its move; a goal that has been reached is a place to look around at."""
    base = view.observation.base_to_start
    board.planner.begin(plan, board.bird_map, base)
    board.goal, board.plan = goal, plan
    x, y = plan.path[-1]
    board.heading_for = float(x), float(y)
    if board.commitment.follow(base, plan):
        board.failed_goals.add(board.heading_for, board.bird_map.update_count)
    if plan.action is None:
        board.bird_map.mark_faced(base)
        return Move(DiscreteAction.TURN_LEFT, f"I have come to the {words_of(board, goal.kind)} and look around.")
    return Move(plan.action, _reason(board, goal, plan))


def _remember_failure(board: Blackboard) -> None:
    """Remember where the last plan led if its motion was the last of several that were blocked."""
    blocked, before = board.planner.blocked_in_a_row, board.blocked
    board.blocked = blocked
    if blocked > before and blocked % BLOCKED_OFTEN == 0 and board.heading_for is not None:
        board.failed_goals.add(board.heading_for, board.bird_map.update_count)


def _reason(board: Blackboard, goal: Goal, plan: Plan) -> str:
    what = words_of(board, goal.kind)
    if plan.short_term_goal is None:
        return f"I am at the {what} and turn to face it."
    if goal.kind is GoalKind.FRONTIER:
        return f"I have not found it yet and explore a frontier {plan.distance:.1f} m away."
    nearly = "" if plan.reachable else ", as near as I can get"
    return f"I know of the {what} and drive there{nearly} ({plan.distance:.1f} m to go)."


def words_of(board: Blackboard, kind: GoalKind) -> str:
    """Return what a kind of goal is called in this episode."""
    instruction = board.instruction
    names = {
        GoalKind.OBJECT: instruction.object_category,
        GoalKind.START_RECEPTACLE: instruction.start_receptacle,
        GoalKind.GOAL_RECEPTACLE: instruction.goal_receptacle,
        GoalKind.FRONTIER: "frontier",
    }
    return names[kind].replace("_", " ")


def faced_point(view: View, role: ClassRole) -> tuple[float, float]:
    """Return (x, y) (m, start frame) of the nearest thing of a role in view, or else of what is half a metre ahead."""
    base: BasePose = view.observation.base_to_start
    points = view.nearest(role, np.zeros(3))
    ahead = points[:, :2].mean(axis=0) if len(points) else np.array([0.5, 0.0])
    x, y = (base.matrix() @ [*ahead, 0.0, 1.0])[:2]
    return float(x), float(y)
