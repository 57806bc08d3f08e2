"""An agent that decides by itself, but for one part, which the simulator's truth plays for it."""

from collections.abc import Iterator
from typing import Protocol

from uniteam.evaluation.truth_parts.true_pick import TruePick
from uniteam.evaluation.truth_parts.true_place import TruePlace
from uniteam.evaluation.truth_parts.truth_family import MakeAgent, truth_family
from uniteam.interface import (
    Action,
    Agent,
    Decision,
    Explaining,
    Explanation,
    Instruction,
    JointDisplacement,
    Observation,
    Perception,
)
from uniteam.mind.agents.config import AgentConfig
from uniteam.mind.agents.heuristic_agent import HeuristicAgent
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


def with_part(part: TruePart) -> MakeAgent:
    """Return what makes agents of which a part is played by what takes its place."""

    def make(config: AgentConfig, perception: Perception, environment: Environment) -> Agent:
        return PartAgent(HeuristicAgent(config, perception), environment, part)

    return make


TRUE_PICK = truth_family(with_part(TruePick()), "an agent that picks by the truth, once it is at the object")
TRUE_PLACE = truth_family(with_part(TruePlace()), "an agent that places by the truth, once it is at the receptacle")
