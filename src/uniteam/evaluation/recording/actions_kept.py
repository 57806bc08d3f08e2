"""The actions of an episode of a run, from whichever recording of it there is."""

from pathlib import Path

from uniteam.evaluation.recording.action_file import read_actions
from uniteam.evaluation.recording.order import ACTION_SUFFIX, RECORDINGS, SUFFIX, recording_path
from uniteam.evaluation.recording.recording import read_recording
from uniteam.interface import Action


def has_actions(run: Path, agent: str, episode: str) -> bool:
    """Return whether a run's directory holds a recording of an agent's episode."""
    return any(path.is_file() for path in _paths(run, agent, episode))


def kept_actions(run: Path, agent: str, episode: str) -> tuple[Action, ...]:
    """Return the actions of an agent's episode in a run's directory.

    Raises:
        DamagedFileError: there is no recording of it, or it cannot be read.
    """
    alone, whole = _paths(run, agent, episode)
    if alone.is_file() or not whole.is_file():
        return read_actions(alone, agent, episode)
    return tuple(step.decision.action for step in read_recording(whole).steps)


def _paths(run: Path, agent: str, episode: str) -> tuple[Path, Path]:
    folder = run / RECORDINGS
    return recording_path(folder, agent, episode, ACTION_SUFFIX), recording_path(folder, agent, episode, SUFFIX)
