"""An agent that is somewhere else: each observation goes over a line, and a decision comes back."""

from dataclasses import dataclass
from time import monotonic
from typing import TypeVar

from uniteam.adapters.remote.line import Line, SilentError
from uniteam.adapters.remote.messages import Decide, Message, Ready, decision_of, observe_of, reset_of
from uniteam.interface import Decision, Instruction, Observation

Wanted = TypeVar("Wanted", bound=Message)


@dataclass(frozen=True)
class Patience:
    """How long an agent may take.

    Attributes:
        answer: s for one answer.
        episode: s for all answers of an episode together.
    """

    answer: float
    episode: float


class RemoteAgent:
    """Asks an agent over a line; what goes wrong there is raised as the agent's own error."""

    def __init__(self, line: Line, patience: Patience) -> None:
        """Take a line to an agent that has been welcomed."""
        self._line, self._patience = line, patience
        self._instruction, self._seed, self._used = Instruction("", "", ""), 0, 0.0

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Have the agent begin an episode; raises LineError or AgentRaisedError."""
        self._instruction, self._seed, self._used = instruction, seed, 0.0
        self._ask(reset_of(instruction, seed), Ready)

    def act(self, observation: Observation) -> Decision:
        """Return what the agent decides; raises LineError, AgentRaisedError, or InvalidActionError."""
        return decision_of(self._ask(observe_of(self._instruction, self._seed, observation), Decide))

    def _ask(self, question: Message, wanted: type[Wanted]) -> Wanted:
        """Return the answer, and count the time until it came."""
        began, left = monotonic(), max(self._patience.episode - self._used, 0.0)
        try:
            return self._line.ask(question, wanted, min(self._patience.answer, left))
        except SilentError as error:
            if left > self._patience.answer:
                raise
            used_up = SilentError(f"the agent took more than {self._patience.episode:g} s for the episode")
            self._line.fault = used_up
            raise used_up from error
        finally:
            self._used += monotonic() - began
