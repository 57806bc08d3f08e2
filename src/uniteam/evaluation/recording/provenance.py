"""What an episode was played by, so that it can be known years later, and played again."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.world.task.ovmm.ovmm_name import parse_ovmm_name


@dataclass(frozen=True)
class Provenance:
    """What a recording is of.

    Attributes:
        agent: the agent's label in the run.
        spec: how to make the agent.
        split: the split as it was named where it was played, a folder of the challenge's own by its
            whole path.
        configuration: all that the episode depended on, as `config.json` of a run has it; plain JSON data, of which
            `agents` has this agent's only.
    """

    agent: str
    spec: AgentSpec
    split: str
    configuration: Mapping[str, Any]


def provenance_of(agent: str, spec: AgentSpec, split: str, configuration: Mapping[str, Any]) -> Provenance:
    """Return the provenance of one agent of a run's configuration, played on the split of this name."""
    official = parse_ovmm_name(split)
    found = split if official is None else f"{official.kind}:{official.folder.resolve()}"
    return Provenance(agent, spec, found, {**configuration, "agents": {agent: configuration["agents"][agent]}})
