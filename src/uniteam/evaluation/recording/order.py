"""Which of a run's episodes are recorded, and where."""

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from uniteam.errors import InvalidInputError
from uniteam.evaluation.episode_loop import Step
from uniteam.evaluation.recording.action_recorder import ActionRecorder
from uniteam.evaluation.recording.provenance import Provenance
from uniteam.evaluation.recording.recorder import Recorder
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.files import UnwritableError, file_name
from uniteam.world.task.environment import Environment

RECORDINGS = "recordings"
"""The folder of a run that holds its recordings, by agent."""

SUFFIX = ".zip"
"""Of a recording."""

ACTION_SUFFIX = ".actions.gz"
"""Of a file of the actions alone."""


class EpisodeRecorder(Protocol):
    """An observer of an episode that is written at its end."""

    def __call__(self, step: Step) -> None:
        """Take a step in."""

    def write(self, path: Path, result: EpisodeResult) -> None:
        """Write what was taken in, with what the episode came to."""


@dataclass(frozen=True)
class RecordingKind:
    """How much is recorded.

    Attributes:
        suffix: of the files.
        begin: makes the recorder of an episode; defined at the top of a module.
    """

    suffix: str
    begin: Callable[[Environment, Provenance], EpisodeRecorder]


EVERYTHING = RecordingKind(SUFFIX, Recorder)
ACTIONS_ALONE = RecordingKind(ACTION_SUFFIX, ActionRecorder)


@dataclass(frozen=True)
class RecordingOrder:
    """What is to be recorded; it can be sent to another process.

    Attributes:
        folder: of the recordings.
        episodes: ids of those that are recorded while they are played.
        is_kept: whether the recording of an episode with this result is written; defined at the top of a module.
        kind: how much is recorded.
    """

    folder: Path
    episodes: frozenset[str]
    is_kept: Callable[[EpisodeResult], bool]
    kind: RecordingKind = EVERYTHING

    def path(self, agent: str, episode: str) -> Path:
        """Return where the recording of an agent's episode is or will be."""
        return recording_path(self.folder, agent, episode, self.kind.suffix)


def whatever_it_is(result: EpisodeResult) -> bool:
    """Keep every recording."""
    return True


def is_failure(result: EpisodeResult) -> bool:
    """Keep the recording of an episode that is no overall success."""
    return not result.measures.overall_success


def recording_order(wish: str | None, folder: Path, episodes: Sequence[str]) -> RecordingOrder:
    """Return what "all", "failures", "actions", a number of episodes, or None for nothing comes to.

    Args:
        wish: as people type it.
        folder: of the recordings.
        episodes: ids of the run's episodes in the order in which they are counted.

    Raises:
        InvalidInputError: the wish is none of these.
    """
    if wish is None:
        return RecordingOrder(folder, frozenset(), whatever_it_is)
    if wish == "actions":
        return RecordingOrder(folder, frozenset(episodes), whatever_it_is, ACTIONS_ALONE)
    if wish in ("all", "failures"):
        return RecordingOrder(folder, frozenset(episodes), whatever_it_is if wish == "all" else is_failure)
    if not re.fullmatch("[1-9][0-9]{0,8}", wish):
        raise InvalidInputError(
            "--record takes 'all', 'failures', 'actions', or how many of the first episodes to record, at least 1; "
            f"got '{wish}'"
        )
    return RecordingOrder(folder, frozenset(episodes[: int(wish)]), whatever_it_is)


def recording_path(folder: Path, agent: str, episode: str, suffix: str = SUFFIX) -> Path:
    """Return where the recording of an agent's episode is or will be, in a folder of recordings."""
    return folder / file_name(agent) / f"{file_name(episode)}{suffix}"


def forget_recordings(folder: Path, agent: str, episode: str) -> None:
    """Remove an episode's recordings, and what a process that was killed had begun of them; raises UnwritableError.

    What is to be played has no result: a recording of it is of a run that was killed before the result was kept.
    """
    for suffix in (SUFFIX, ACTION_SUFFIX):
        path = recording_path(folder, agent, episode, suffix)
        try:
            for old in (path, *path.parent.glob(f"{path.name}.*.partial")):
                old.unlink(missing_ok=True)
        except OSError as error:
            raise UnwritableError(path, error) from error
