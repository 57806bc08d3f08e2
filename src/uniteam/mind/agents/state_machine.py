"""The state machine that joins the skills: a state is a function from what is known to what to do and what is next."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Any

from uniteam.interface import Action, DiscreteAction
from uniteam.mind.agents.blackboard import Memory
from uniteam.mind.agents.search import OBJECT_SEARCH, RECEPTACLE_SEARCH, Finding, faced_point, look_for
from uniteam.mind.manipulation.pick.pick import PickResult, pick
from uniteam.mind.manipulation.place.place import place
from uniteam.mind.navigation.goals.failed_attempts import Miss
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.mind.skills.skill import Skill, Step
from uniteam.mind.skills.view import View


class State(Enum):
    """What the agent is about."""

    LOOK_AROUND = "LOOK_AROUND"
    FIND_OBJECT = "FIND_OBJECT"
    NAVIGATE_TO_OBJECT = "NAVIGATE_TO_OBJECT"
    PICK = "PICK"
    FIND_RECEPTACLE = "FIND_RECEPTACLE"
    NAVIGATE_TO_RECEPTACLE = "NAVIGATE_TO_RECEPTACLE"
    PLACE = "PLACE"
    DONE = "DONE"


@dataclass(frozen=True)
class Move:
    """What a state decides.

    Attributes:
        state: what the agent is about now; it decides the next step too.
        action: what to do; None lets `state` decide within the same step.
        reason: one sentence of why.
    """

    state: State
    action: Action | None = None
    reason: str = ""


StateFunction = Callable[[Memory, View], Move]


def look_around(memory: Memory, view: View) -> Move:
    """Turn once around."""
    if memory.turns == memory.config.first_turns:
        return Move(State.FIND_OBJECT)
    memory.turns += 1
    reason = f"I look around first ({memory.turns} of {memory.config.first_turns} turns)."
    return Move(State.LOOK_AROUND, DiscreteAction.TURN_LEFT, reason)


def find_object(memory: Memory, view: View) -> Move:
    """Explore until the object is seen on its receptacle, then go and stand before it."""
    step, finding = look_for(OBJECT_SEARCH, memory, view)
    return _after_search(finding, step, (State.FIND_OBJECT, State.NAVIGATE_TO_OBJECT, State.PICK))


def find_receptacle(memory: Memory, view: View) -> Move:
    """Explore until a goal receptacle is known, then go and stand before it."""
    step, finding = look_for(RECEPTACLE_SEARCH, memory, view)
    return _after_search(finding, step, (State.FIND_RECEPTACLE, State.NAVIGATE_TO_RECEPTACLE, State.PLACE))


def _after_search(finding: Finding, step: Step | None, states: tuple[State, State, State]) -> Move:
    searching, approaching, arrived = states
    if finding is Finding.GIVEN_UP:
        return Move(State.DONE, DiscreteAction.STOP, "I have looked everywhere I can get to, and give up.")
    if step is None:
        return Move(arrived)
    return Move(approaching if finding is Finding.IN_SIGHT else searching, step.action, step.reason)


def pick_object(memory: Memory, view: View) -> Move:
    """Carry the pick on; one that is known to have failed leads back to the search, and elsewhere."""

    def begin() -> Skill[PickResult]:
        memory.attempt = Miss(view.observation.base_to_start, faced_point(view, ClassRole.OBJECT))
        return pick(view, memory.config.pick)

    step, result = _carry_on(memory, view, begin)
    if step is not None:
        return Move(State.PICK, step.action, step.reason)
    if not result.grasped:
        memory.object_misses.add(memory.attempt)
        return Move(State.FIND_OBJECT)
    memory.load = result.load
    return Move(State.FIND_RECEPTACLE)


def place_object(memory: Memory, view: View) -> Move:
    """Carry the place on; where nothing could be placed and there are attempts left, go elsewhere."""

    def begin() -> Skill[bool]:
        memory.attempt = Miss(view.observation.base_to_start, faced_point(view, ClassRole.GOAL_RECEPTACLE))
        is_last = memory.place_misses.count + 1 >= memory.config.place.attempts
        return place(view, memory.place_context(), memory.config.place, is_last)

    step, is_placed = _carry_on(memory, view, begin)
    if step is not None:
        return Move(State.PLACE, step.action, step.reason)
    if not is_placed:
        memory.place_misses.add(memory.attempt)
        return Move(State.FIND_RECEPTACLE)
    return Move(State.DONE)


def stop(memory: Memory, view: View) -> Move:
    """End the episode."""
    return Move(State.DONE, DiscreteAction.STOP, "The object is where it should be, I believe, so I stop.")


def _carry_on(memory: Memory, view: View, begin: Callable[[], Skill[Any]]) -> tuple[Step | None, Any]:
    """Give the running skill the view, or begin one; return its next step, or None and its result once it has ended."""
    try:
        if memory.skill is None:
            memory.skill = begin()
            return next(memory.skill), None
        return memory.skill.send(view), None
    except StopIteration as end:
        memory.skill = None
        return None, end.value


STATES: dict[State, StateFunction] = {
    State.LOOK_AROUND: look_around,
    State.FIND_OBJECT: find_object,
    State.NAVIGATE_TO_OBJECT: find_object,
    State.PICK: pick_object,
    State.FIND_RECEPTACLE: find_receptacle,
    State.NAVIGATE_TO_RECEPTACLE: find_receptacle,
    State.PLACE: place_object,
    State.DONE: stop,
}


def decide(state: State, memory: Memory, view: View) -> tuple[State, Step]:
    """Return what the agent is about now and its step; a state that hands over is followed until one acts."""
    for _ in range(2 * len(State)):
        move = STATES[state](memory, view)
        state = move.state
        if move.action is not None:
            return state, Step(move.action, move.reason)
    return state, Step(DiscreteAction.EMPTY_ACTION, "I do not know what to do, so I wait and look again.")
