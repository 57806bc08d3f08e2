"""Agents of which the simulator's truth plays a part, by the agent's name: `true-pick:uniteam-plus`."""

from collections.abc import Callable

from uniteam.errors import InvalidInputError
from uniteam.interface import Agent, Perception
from uniteam.mind.agents.config import AgentConfig
from uniteam.mind.agents.registry import AGENTS, AgentContext
from uniteam.registry import Family
from uniteam.world.task.environment import Environment

MakeAgent = Callable[[AgentConfig, Perception, Environment], Agent]
"""From what an agent is made of, what it sees with and what it acts in to the agent with its part replaced."""


class TruthFactory:
    """Makes an agent of which one part is replaced.

    Attributes:
        needs_truth: that it is shown the environment.
        outside_modules: where the agent is from.
    """

    needs_truth = True

    def __init__(self, inner: str, make: MakeAgent) -> None:
        """Take the agent's name and what makes it."""
        self._inner, self._make = inner, make
        self.outside_modules = (inner.partition(":")[0],) if ":" in inner else ()

    def __call__(self, context: AgentContext) -> Agent:
        """Return a new agent; raises InvalidInputError where there is no simulator."""
        if not isinstance(context.environment, Environment):
            raise InvalidInputError("parts are replaced in the simulator's environment only; choose another agent")
        return self._make(_config_of(self._inner), context.make_perception(), context.environment)


def truth_family(make: MakeAgent, words: str) -> Family[TruthFactory]:
    """Return the family of agents of which a part is replaced, by the agent's name.

    Args:
        make: makes an agent with its part replaced.
        words: what is replaced, in half a sentence.
    """

    def member(inner: str) -> TruthFactory:
        _config_of(inner)
        return TruthFactory(inner, make)

    return Family(words, "AGENT", "uniteam-plus", member, default="uniteam-plus")


def _config_of(inner: str) -> AgentConfig:
    config = AGENTS.get(inner)
    if not isinstance(config, AgentConfig):
        raise InvalidInputError(
            f"no part of agent '{inner}' can be replaced, since it is not made of a configuration; choose "
            "baseline, uniteam, uniteam-plus or a configuration of your own"
        )
    return config
