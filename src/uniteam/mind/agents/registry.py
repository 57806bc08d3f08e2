"""The agents by name."""

from collections.abc import Iterable
from typing import Any

from uniteam.errors import UnknownNameError
from uniteam.interface import Agent
from uniteam.mind.agents.config import BASELINE, AgentConfig
from uniteam.mind.agents.describe import describe
from uniteam.mind.agents.heuristic_agent import HeuristicAgent
from uniteam.mind.agents.improvement import Improvement, improvements_named
from uniteam.mind.agents.random_agent import RandomAgent
from uniteam.mind.perception.registry import perception_kind

AGENT_NAMES = ("baseline", "uniteam", "random")

_IMPROVEMENTS_OF: dict[str, frozenset[Improvement]] = {"baseline": frozenset(), "uniteam": frozenset(Improvement)}


def make_agent(name: str, perception: str = "truth", with_: Iterable[str] = (), without: Iterable[str] = ()) -> Agent:
    """Return a new agent.

    Args:
        name: one of `AGENT_NAMES`.
        perception: one of `PERCEPTIONS`; the random agent does not look.
        with_: names of improvements to add to what the agent has.
        without: names of improvements to take away from it.

    Raises:
        UnknownNameError: an agent, a perception or an improvement that there is none of, with the nearest valid name.
    """
    kind, config = perception_kind(perception), agent_config(name, with_, without)
    return RandomAgent() if config is None else HeuristicAgent(config, kind.make())


def agent_config(name: str, with_: Iterable[str] = (), without: Iterable[str] = ()) -> AgentConfig | None:
    """Return the configuration of an agent; None for one that has none. Takes and raises what `make_agent` does."""
    if name not in AGENT_NAMES:
        raise UnknownNameError("agent", name, AGENT_NAMES)
    added, removed = improvements_named(with_), improvements_named(without)
    if name not in _IMPROVEMENTS_OF:
        return None
    return BASELINE.with_improvements((_IMPROVEMENTS_OF[name] | added) - removed)


def describe_agent(
    name: str, perception: str = "truth", with_: Iterable[str] = (), without: Iterable[str] = ()
) -> dict[str, Any]:
    """Return an agent's resolved configuration as JSON data. Takes and raises what `make_agent` does."""
    perception_kind(perception)
    return {"agent": name, "perception": perception, "config": describe(agent_config(name, with_, without))}


def needs_truth(perception: str) -> bool:
    """Return whether a kind of perception needs observations with their true segmentation."""
    return perception_kind(perception).needs_truth
