"""Oracles that are led astray: real episodes of which it is known why they fail."""

from collections.abc import Callable, Iterator

from uniteam.interface import Action, Decision, DiscreteAction, Instruction, Observation
from uniteam.world.oracle.oracle import Oracle
from uniteam.world.task.environment import Environment

Spoil = Callable[[Iterator[Decision]], Iterator[Action]]
"""Makes other actions of the oracle's decisions; then the agent stops."""


class Saboteur:
    """Does what is made of the oracle's decisions."""

    def __init__(self, environment: Environment, spoil: Spoil) -> None:
        self._oracle, self._spoil = Oracle(environment), spoil

    def reset(self, instruction: Instruction, seed: int) -> None:
        self._oracle.reset(instruction, seed)
        self._seen: Observation | None = None
        self._actions = self._spoil(self._decisions())

    def act(self, observation: Observation) -> Decision:
        self._seen = observation
        return Decision(next(self._actions, DiscreteAction.STOP), "SPOIL", "This is meant to fail.")

    def _decisions(self) -> Iterator[Decision]:
        while True:
            assert self._seen is not None
            yield self._oracle.act(self._seen)


def until(decisions: Iterator[Decision], last: DiscreteAction) -> Iterator[Action]:
    """Yield the oracle's actions up to one of a kind, that one too."""
    for decision in decisions:
        yield decision.action
        if decision.action is last:
            return


def until_state(decisions: Iterator[Decision], state: str) -> Iterator[Action]:
    """Yield the oracle's actions before those of a state; the first of these is lost."""
    for decision in decisions:
        if decision.state == state:
            return
        yield decision.action
