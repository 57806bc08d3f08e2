"""What an episode was played by, so that it can be known years later, and played again."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from uniteam.evaluation.agent_spec import AgentSpec


@dataclass(frozen=True)
class Provenance:
    """What a recording is of.

    Attributes:
        agent: the agent's label in the run.
        spec: how to make the agent.
        configuration: all that the episode depended on, as `config.json` of a run has it; plain JSON data, of which
            `agents` has this agent's only.
    """

    agent: str
    spec: AgentSpec
    configuration: Mapping[str, Any]


def provenance_of(agent: str, spec: AgentSpec, configuration: Mapping[str, Any]) -> Provenance:
    """Return the provenance of one agent of a run's configuration."""
    return Provenance(agent, spec, {**configuration, "agents": {agent: configuration["agents"][agent]}})
