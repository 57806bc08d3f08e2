"""Why the episodes of an agent's run failed: one cause each, from their recordings where there are any."""

import logging
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from uniteam.errors import UniteamError
from uniteam.evaluation.analysis.contestants import Contestant
from uniteam.evaluation.analysis.kept_causes import cause_of
from uniteam.evaluation.causes.diagnosis import Diagnosis, diagnose_result
from uniteam.evaluation.recording.order import RECORDINGS, recording_path
from uniteam.evaluation.results.result import EpisodeResult

_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Explained:
    """One attempt at an episode.

    Attributes:
        result: what it came to.
        diagnosis: why it failed; None for an overall success.
        recording: the file that this was decided from, or None.
    """

    result: EpisodeResult
    diagnosis: Diagnosis | None
    recording: Path | None


@dataclass(frozen=True)
class Explanations:
    """One agent's attempts, in the order of the episodes' names.

    Attributes:
        label: of the agent, unlike all others'.
        episodes: the attempts.
    """

    label: str
    episodes: tuple[Explained, ...]


def explain_run(contestant: Contestant, count: Callable[[], None]) -> Explanations:
    """Return why an agent's episodes failed; `count` is called after each failure.

    A recording that cannot be read, or is not of the result that stands beside it, is passed over with a warning.
    """
    folder = contestant.run.directory / RECORDINGS
    explained = []
    for name, result in sorted(contestant.results.items()):
        explained.append(_explained(result, recording_path(folder, contestant.agent, name)))
        if explained[-1].diagnosis is not None:
            count()
    return Explanations(contestant.label, tuple(explained))


def failure_count(contestant: Contestant) -> int:
    """Return how many of an agent's episodes are no overall success."""
    return sum(not result.measures.overall_success for result in contestant.results.values())


def explained_to_data(explained: Explained) -> dict[str, Any]:
    """Return a failed attempt as plain JSON data."""
    found = explained.diagnosis
    assert found is not None
    return {
        "episode": explained.result.episode,
        "instruction": explained.result.instruction,
        "phase": found.phase,
        "cause": found.cause.value,
        "report": found.report,
        "step": found.step,
        "place": found.place,
        "words": found.words,
        "recording": None if explained.recording is None else str(explained.recording),
    }


def _explained(result: EpisodeResult, path: Path) -> Explained:
    if result.measures.overall_success or not path.is_file():
        return Explained(result, diagnose_result(result), None)
    try:
        kept = cause_of(path)
        if kept.measures == result.measures:
            return Explained(result, kept.diagnosis, path)
        _log.warning("%s is of another playing than the result of %s, and is not used", path, result.episode)
    except UniteamError as error:
        _log.warning("%s", error)
    return Explained(result, diagnose_result(result), None)
