"""An agent that decides by itself, but for one part, which the simulator's truth plays for it."""

from collections.abc import Iterator
from typing import Protocol

from uniteam.errors import InvalidInputError
from uniteam.evaluation.truth_parts.true_pick import TruePick
from uniteam.evaluation.truth_parts.true_place import TruePlace
from uniteam.interface import (
    Action,
    Agent,
    Decision,
    Explaining,
    Explanation,
    Instruction,
    JointDisplacement,
    Observation,
)
from uniteam.mind.agents.config import AgentConfig
from uniteam.mind.agents.registry import AGENTS, AgentContext, build_agent
from uniteam.registry import Family
from uniteam.world.oracle.pilot import Pilot
from uniteam.world.task.environment import Environment


class TruePart(Protocol):
    """What takes the place of a part.

    Attributes:
        state: of the agent in which it does.
    """

    state: str

    def is_possible(self, environment: Environment) -> bool:
        """Return whether the truth can play the part from where the robot is; if not, the agent does."""

    def play(self, environment: Environment) -> Iterator[Action]:
        """Yield the part's actions, each to be done before the next is asked for."""


class PartAgent:
    """Hands over to the truth whenever the agent enters a state, and back when that is done.

    The robot is brought back to where it was, and the agent's own first action of the state is done then: it goes on as
    if nothing had happened, and finds out what has. It sees nothing in between, but the steps are counted.
    """

    def __init__(self, agent: Agent, environment: Environment, part: TruePart) -> None:
        """Take the agent, the environment that it acts in, and the part."""
        self._agent, self._environment, self._part = agent, environment, part
        self._script: Iterator[Action] = iter(())
        self._waiting: Decision | None = None
        self._state = ""

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Begin anew, as the agent does."""
        self._agent.reset(instruction, seed)
        self._script, self._waiting, self._state = iter(()), None, ""

    def act(self, observation: Observation) -> Decision:
        """Return the truth's next action where it is at work, and the agent's decision otherwise."""
        if self._waiting is None:
            decision = self._agent.act(observation)
            enters = decision.state == self._part.state != self._state
            self._state = decision.state
            if not enters or not self._part.is_possible(self._environment):
                return decision
            self._waiting, self._script = decision, self._there_and_back()
        action = next(self._script, None)
        if action is not None:
            return Decision(action, self._part.state, "The truth does this part.")
        waiting, self._waiting = self._waiting, None
        return waiting

    def explain(self) -> Explanation:
        """Return what is behind the agent's last decision."""
        return self._agent.explain() if isinstance(self._agent, Explaining) else Explanation()

    def _there_and_back(self) -> Iterator[Action]:
        simulator = self._environment.simulator
        base, joints = simulator.base, simulator.joints
        yield from self._part.play(self._environment)
        yield from Pilot(simulator).stand(base)
        if simulator.joints != joints:
            yield JointDisplacement(joints - simulator.joints)


class _PartAgentFactory:
    """Makes an agent of which one part is replaced."""

    needs_truth = True

    def __init__(self, inner: str, part: TruePart) -> None:
        self._inner, self._part = inner, part
        self.outside_modules = (inner.partition(":")[0],) if ":" in inner else ()

    def __call__(self, context: AgentContext) -> Agent:
        if not isinstance(context.environment, Environment):
            raise InvalidInputError("parts are replaced in the simulator's environment only; choose another agent")
        agent = build_agent(self._inner, AGENTS.get(self._inner), AgentContext(context.perception, None))
        return PartAgent(agent, context.environment, self._part)


def part_family(part: TruePart, words: str) -> Family[_PartAgentFactory]:
    """Return the family of agents of which a part is replaced, by the agent's name.

    Args:
        part: what takes its place.
        words: what is replaced, in half a sentence.
    """

    def member(inner: str) -> _PartAgentFactory:
        if not isinstance(AGENTS.get(inner), AgentConfig):
            raise InvalidInputError(
                f"no part of agent '{inner}' can be replaced, since it is not made of a configuration; choose "
                "baseline, uniteam, uniteam-plus or a configuration of your own"
            )
        return _PartAgentFactory(inner, part)

    return Family(words, "AGENT", "uniteam-plus", member, default="uniteam-plus")


TRUE_PICK = part_family(TruePick(), "an agent that picks by the truth, once it is at the object")
TRUE_PLACE = part_family(TruePlace(), "an agent that places by the truth, once it is at the receptacle")
