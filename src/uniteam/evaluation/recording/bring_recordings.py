"""Bring the recordings of a run's results into another folder, as merging does."""

import os
import shutil
from pathlib import Path

from uniteam.errors import DamagedFileError
from uniteam.evaluation.recording.action_file import read_actions
from uniteam.evaluation.recording.archive import read_member
from uniteam.evaluation.recording.order import ACTION_SUFFIX, RECORDINGS, SUFFIX, recording_path
from uniteam.evaluation.results.result import EpisodeResult, result_from_line
from uniteam.evaluation.results.run_folder import RunFolder
from uniteam.files import try_folder


def bring_recordings(run: RunFolder, folder: Path) -> None:
    """Put the recordings of a run's results into the folder of another run, by hard links where that is possible.

    What has no result yet, such as what was begun when the run was killed, is left behind.

    Raises:
        DamagedFileError: a recording cannot be read, or is of another playing than the result beside it.
        OSError: the folder cannot be written.
    """
    checks = {SUFFIX: _check_recording, ACTION_SUFFIX: _check_actions}
    for agent, results in run.results.items():
        for episode, result in results.items():
            for suffix, check in checks.items():
                path = recording_path(run.directory / RECORDINGS, agent, episode, suffix)
                if path.is_file():
                    check(path, agent, result)
                    _put(path, recording_path(folder / RECORDINGS, agent, episode, suffix))


def _check_recording(path: Path, agent: str, result: EpisodeResult) -> None:
    if result_from_line(read_member(path, "result.json")) != (agent, result):
        raise _of_another_playing(path)


def _check_actions(path: Path, agent: str, result: EpisodeResult) -> None:
    if len(read_actions(path, agent, result.episode)) != result.measures.num_steps:
        raise _of_another_playing(path)


def _of_another_playing(path: Path) -> DamagedFileError:
    return DamagedFileError(
        f"'{path}' is of another playing than the result that stands beside it; "
        "remove that file, or play the shard again"
    )


def _put(path: Path, target: Path) -> None:
    try_folder(target.parent)
    try:
        os.link(path, target)
    except OSError:  # another disk, or a system of files without links
        shutil.copy2(path, target)
