"""Agents by name for the runner: those of the mind, and the oracle, which lives with the task."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from uniteam.errors import UnknownNameError
from uniteam.interface import Agent
from uniteam.mind.agents.registry import AGENT_NAMES, describe_agent, make_agent, needs_truth
from uniteam.world.task.environment import Environment
from uniteam.world.task.oracle import Oracle

ORACLE = "oracle"


@dataclass(frozen=True)
class AgentSpec:
    """Which agent to make.

    Attributes:
        name: "oracle" or one of `AGENT_NAMES`.
        perception: the kind of perception it sees with.
        added: names of improvements it has besides its own.
        removed: names of improvements it does without.
    """

    name: str
    perception: str
    added: tuple[str, ...] = ()
    removed: tuple[str, ...] = ()

    def make(self, environment: Environment) -> Agent:
        """Build the agent; only the oracle is shown the environment itself.

        Raises:
            UnknownNameError: an unknown agent, perception or improvement.
        """
        if self.name == ORACLE:
            return Oracle(environment)
        return make_agent(self.name, self.perception, self.added, self.removed)

    def describe(self) -> dict[str, Any]:
        """Return the resolved configuration as plain JSON data; raises UnknownNameError as `make` does."""
        if self.name == ORACLE:
            return {"agent": ORACLE}
        if self.name not in AGENT_NAMES:
            raise UnknownNameError("agent", self.name, (*AGENT_NAMES, ORACLE))
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
    """
    labelled = {}
    for name in names:
        plain, changed = AgentSpec(name, perception), AgentSpec(name, perception, added, removed)
        same = changed.describe() == plain.describe()
        labelled[name if same else _changed_label(name, added, removed)] = plain if same else changed
    return labelled


def _changed_label(name: str, added: tuple[str, ...], removed: tuple[str, ...]) -> str:
    """Return "uniteam with a, b without c"."""
    parts = [name]
    parts += ["with " + ", ".join(sorted(added))] if added else []
    parts += ["without " + ", ".join(sorted(removed))] if removed else []
    return " ".join(parts)
