"""The state machine that joins the skills: it runs exactly one, whose end says which comes next."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from functools import partial

from uniteam.geometry import Point2
from uniteam.interface import DiscreteAction
from uniteam.mind.agents.blackboard import Blackboard
from uniteam.mind.agents.search import (
    OBJECT_SEARCH,
    RECEPTACLE_SEARCH,
    Approach,
    Search,
    approach,
    explore,
    faced_point,
    get_away,
    look_around,
)
from uniteam.mind.agents.second_look import go_aside, is_doubted, is_recognised
from uniteam.mind.manipulation.arm_clearance import EMPTY_GRIPPER, Load
from uniteam.mind.manipulation.pick.pick import pick
from uniteam.mind.manipulation.place.place import place
from uniteam.mind.navigation.goals.failed_attempts import Miss
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.mind.skills.skill import Move, Skill
from uniteam.mind.skills.view import View

MOST_FALLS = 3
"""So often an object that fell is picked up again."""


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
class Phase:
    """A state that is to come.

    Attributes:
        state: its name.
        begin: returns its skill, whose result is the phase after it.
    """

    state: State
    begin: Callable[[Blackboard, View], Skill["Phase"]]


@dataclass(frozen=True)
class Running:
    """A state that has begun, and its skill."""

    state: State
    skill: Skill[Phase]


class StateMachine:
    """Carries out one phase after the other, from looking around to the end."""

    def __init__(self) -> None:
        """Stand before the first phase."""
        self._current: Phase | Running = Phase(State.LOOK_AROUND, _look_around)

    def decide(self, board: Blackboard, view: View) -> tuple[State, Move]:
        """Return what the agent is about now and its move; where a skill ends without one, the next one begins."""
        for _ in range(2 * len(State)):
            try:
                return self._advance(board, view)
            except StopIteration as end:
                self._current = end.value
        return self._current.state, Move(DiscreteAction.EMPTY_ACTION, "I do not know what to do, so I wait.")

    def _advance(self, board: Blackboard, view: View) -> tuple[State, Move]:
        if isinstance(self._current, Running):
            return self._current.state, self._current.skill.send(view)
        self._current = Running(self._current.state, self._current.begin(board, view))
        return self._current.state, next(self._current.skill)


def _look_around(board: Blackboard, view: View) -> Skill[Phase]:
    yield from look_around(board, view)
    return _FETCH.find


@dataclass(frozen=True)
class _Errand:
    """Exploring for something, going to it, and what is done there.

    Attributes:
        search: what is searched for.
        role: of it.
        states: while it is searched for, and while the robot goes to it.
        arrived: what comes then.
    """

    search: Search
    role: ClassRole
    states: tuple[State, State]
    arrived: Phase

    @property
    def find(self) -> Phase:
        """The phase with which it begins."""
        return Phase(self.states[0], self._find)

    def _find(self, board: Blackboard, view: View) -> Skill[Phase]:
        is_known = yield from explore(board, view, self.search)
        return Phase(self.states[1], self._go_there) if is_known else _GIVE_UP

    def _go_there(self, board: Blackboard, view: View) -> Skill[Phase]:
        end = yield from approach(board, view, self.search)
        if end is Approach.ARRIVED:
            return Phase(self.states[1], self._before_it)
        return Phase(self.states[0], self._get_away) if end is Approach.BLOCKED else self.find

    def _before_it(self, board: Blackboard, view: View) -> Skill[Phase]:
        if not is_doubted(board, view, self.role):
            return self.arrived
        target = faced_point(view, self.role)
        end = yield from go_aside(board, view, self.search, self.role, target)
        if end is Approach.BLOCKED:
            return Phase(self.states[0], self._get_away)
        return (
            Phase(self.states[1], partial(self._aside_of_it, target=target)) if end is Approach.ARRIVED else self.find
        )

    def _aside_of_it(self, board: Blackboard, view: View, target: Point2) -> Skill[Phase]:
        yield from ()
        if not is_recognised(view, self.role, target):
            board.bird_map.forget_thing(self.role, *target)
        return self.find

    def _get_away(self, board: Blackboard, view: View) -> Skill[Phase]:
        yield from get_away(board, view)
        return self.find


def _pick(board: Blackboard, view: View) -> Skill[Phase]:
    """Pick; what is known to have failed leads back to the search, and elsewhere."""
    attempt = Miss(view.observation.base_to_start, faced_point(view, ClassRole.OBJECT))
    result = yield from pick(view, board.config.pick)
    if result.grasped:
        board.lying = None
        board.planner.carry(board.config.footprint(result.load))
        board.config.search.recall(board.bird_map)
        return _bring(result.load).find
    board.object_misses.add(attempt)
    return _FETCH.find


def _place(board: Blackboard, view: View, load: Load) -> Skill[Phase]:
    """Place; where nothing could be placed and there are attempts left, go elsewhere."""
    attempt = Miss(view.observation.base_to_start, faced_point(view, ClassRole.GOAL_RECEPTACLE))
    config = board.config.place
    are_used_up = board.place_misses.count + 1 >= config.attempts + board.falls
    is_last = are_used_up or view.observation.step >= config.last_call
    result = yield from place(view, config.context(load, board.generator), config, is_last)
    if result.released and (result.lying is None or board.falls == MOST_FALLS):
        return Phase(State.DONE, partial(_stop, reason="The object is where it should be, I believe, so I stop."))
    board.place_misses.add(attempt)
    if result.lying is None:
        return _bring(load).find
    board.planner.carry(board.config.footprint(EMPTY_GRIPPER))
    board.lying, board.falls = result.lying, board.falls + 1
    return _FETCH.find


def _stop(board: Blackboard, view: View, reason: str) -> Skill[Phase]:
    """End the episode."""
    while True:
        yield Move(DiscreteAction.STOP, reason)


_GIVE_UP = Phase(State.DONE, partial(_stop, reason="I have looked everywhere I can get to, and give up."))
_FETCH = _Errand(
    OBJECT_SEARCH, ClassRole.OBJECT, (State.FIND_OBJECT, State.NAVIGATE_TO_OBJECT), Phase(State.PICK, _pick)
)


def _bring(load: Load) -> _Errand:
    """Return the errand of bringing what is in the gripper to a goal receptacle."""
    states = State.FIND_RECEPTACLE, State.NAVIGATE_TO_RECEPTACLE
    return _Errand(RECEPTACLE_SEARCH, ClassRole.GOAL_RECEPTACLE, states, Phase(State.PLACE, partial(_place, load=load)))
