"""Agents by name for the runner: those of the mind, and the oracle, which lives with the task."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

from uniteam.errors import InvalidInputError
from uniteam.evaluation.truth_parts.part_agent import TRUE_PICK, TRUE_PLACE
from uniteam.evaluation.truth_parts.true_exploration import TRUE_EXPLORATION
from uniteam.evaluation.truth_parts.true_map import TRUE_MAP
from uniteam.evaluation.truth_parts.true_navigation import TRUE_NAVIGATION
from uniteam.interface import Agent
from uniteam.mind.agents.registry import (
    AGENTS,
    AgentContext,
    agent_config,
    describe_agent,
    is_told_the_truth,
    make_agent,
)
from uniteam.mind.perception.registry import check_ready, needs_truth
from uniteam.world.oracle.oracle import Oracle
from uniteam.world.task.environment import Environment

ORACLE = "oracle"


class _OracleFactory:
    """The truth's own agent: it plays an episode as it was certified."""

    needs_truth = True

    def __call__(self, context: AgentContext) -> Agent:
        if not isinstance(context.environment, Environment):
            raise InvalidInputError("the oracle acts in the simulator's environment only; choose another agent")
        return Oracle(context.environment)


AGENTS.register(ORACLE, _OracleFactory(), module=__name__)
AGENTS.register("true-map", TRUE_MAP, module=__name__)
AGENTS.register("true-exploration", TRUE_EXPLORATION, module=__name__)
AGENTS.register("true-navigation", TRUE_NAVIGATION, module=__name__)
AGENTS.register("true-pick", TRUE_PICK, module=__name__)
AGENTS.register("true-place", TRUE_PLACE, module=__name__)


@dataclass(frozen=True)
class AgentSpec:
    """Which agent to make.

    Attributes:
        name: of an agent, or a reference "module:attribute".
        perception: name or reference of the kind of perception it sees with.
        added: names of improvements it has besides its own.
        removed: names of improvements it does without.
    """

    name: str
    perception: str
    added: tuple[str, ...] = ()
    removed: tuple[str, ...] = ()

    def make(self, environment: Environment | None) -> Agent:
        """Build the agent; only one that is told the truth is shown the environment itself, if there is one.

        Raises:
            UnknownNameError: an unknown agent, perception or improvement.
            InvalidInputError: what its factory makes is no agent.
        """
        return make_agent(self.name, self.perception, self.added, self.removed, environment)

    def describe(self) -> dict[str, Any]:
        """Return the resolved configuration as plain JSON data; raises UnknownNameError as `make` does."""
        return describe_agent(self.name, self.perception, self.added, self.removed)

    @property
    def needs_truth(self) -> bool:
        """Whether its observations must carry the simulator's own segmentation."""
        return needs_truth(self.perception)


def label_agents(
    names: Iterable[str], perception: str, added: tuple[str, ...] = (), removed: tuple[str, ...] = ()
) -> dict[str, AgentSpec]:
    """Return the agents under the labels of the table: the name, and what was changed where that changes anything.

    Raises:
        UnknownNameError: an unknown agent, perception or improvement.
        InvalidInputError: improvements, for agents none of which is made of a configuration that they could change.
        UniteamError: the perception needs something that is not installed.
    """
    check_ready(perception)
    labelled = {}
    agents = tuple(names)
    takes_improvements = [name for name in agents if agent_config(name) is not None]
    for name in agents:
        plain = AgentSpec(name, perception)
        if name not in takes_improvements and takes_improvements:
            labelled[_label(plain)] = plain
            continue
        effective = AgentSpec(
            name,
            perception,
            tuple(a for a in added if _config(replace(plain, added=(a,))) != _config(plain)),
            tuple(r for r in removed if _config(replace(plain, removed=(r,))) != _config(plain)),
        )
        labelled[_label(effective)] = effective
    return labelled


def _config(spec: AgentSpec) -> object:
    """Return what an improvement can change."""
    return spec.describe()["config"]


def _label(spec: AgentSpec) -> str:
    """Return "uniteam", or "baseline with edge_margin" or "uniteam without edge_margin"."""
    parts = [spec.name]
    parts += ["(told the truth)"] if spec.name != ORACLE and is_told_the_truth(spec.name) else []
    parts += ["with " + ", ".join(sorted(spec.added))] if spec.added else []
    parts += ["without " + ", ".join(sorted(spec.removed))] if spec.removed else []
    return " ".join(parts)
