"""An agent on the clock: its time and its exceptions are told from those of the world around it."""

from collections.abc import Callable
from typing import TypeVar

from uniteam.errors import InvalidInputError, UnavailableError
from uniteam.evaluation.backends.serving import Charging
from uniteam.interface import Agent, Decision, Explaining, Explanation, Instruction, Observation

Value = TypeVar("Value")


class AgentError(Exception):
    """What an agent raised, in `__cause__`; everything else that is raised in an episode is the world's.

    Attributes:
        steps: how many decisions it had made in the episode.
    """

    def __init__(self, steps: int) -> None:
        super().__init__(steps)
        self.steps = steps


class ChargedAgent:
    """Passes everything on to an agent."""

    def __init__(self, make: Callable[[], Agent], charging: Charging) -> None:
        """Make the agent; raises AgentError."""
        self._charging = charging
        self._steps = 0
        self._agent = self._do(make)

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Begin an episode; raises AgentError."""
        self._steps = 0
        self._do(lambda: self._agent.reset(instruction, seed))

    def act(self, observation: Observation) -> Decision:
        """Return the decision; raises AgentError, also where it is none."""
        decision = self._do(lambda: _checked(self._agent.act(observation)))
        self._steps += 1
        return decision

    def explain(self) -> Explanation:
        """Return what is behind the last decision, nothing where the agent does not say; raises AgentError."""
        agent = self._agent
        return self._do(agent.explain) if isinstance(agent, Explaining) else Explanation()

    def _do(self, call: Callable[[], Value]) -> Value:
        with self._charging():
            try:
                return call()
            except (MemoryError, UnavailableError):  # the machine's or the installation's fault, not the agent's
                raise
            except (Exception, SystemExit) as error:
                raise AgentError(self._steps) from error


def _checked(decision: object) -> Decision:
    if not isinstance(decision, Decision):
        raise InvalidInputError(f"an agent's act must return a Decision, got {type(decision).__name__}")
    return decision
