"""Causes of failures as they lie beside a run's results, where somebody has had them written."""

from collections.abc import Mapping
from typing import Any

import msgspec

from uniteam.errors import DamagedFileError
from uniteam.evaluation.results.run_folder import RunFolder

CAUSES = "causes.json"
"""In the folder of a run: a list of agents, each with its `failures`, each with its `episode` and its `cause`."""


class FailureData(msgspec.Struct):
    """Why an episode failed, in a few words; with the step that shows it, and a sentence."""

    episode: str
    cause: str
    step: int | None = None
    words: str = ""


class AgentData(msgspec.Struct):
    """An agent's failures; what else is told of it is passed over."""

    agent: str
    failures: list[FailureData]


def causes_of(run: RunFolder) -> Mapping[tuple[str, str], dict[str, Any]]:
    """Return the causes by agent and episode, as plain data; none where the run's folder has no such file.

    Raises:
        DamagedFileError: the file cannot be read as one.
    """
    path = run.directory / CAUSES
    if not path.exists():
        return {}
    try:
        agents = msgspec.json.decode(path.read_bytes(), type=list[AgentData])
    except (OSError, msgspec.MsgspecError, RecursionError) as error:
        raise DamagedFileError(
            f"the causes '{path}' cannot be read ({error}); remove the file or write it anew"
        ) from error
    return {
        (each.agent, failure.episode): {"cause": failure.cause, "step": failure.step, "words": failure.words}
        for each in agents
        for failure in each.failures
    }
