"""Recordings that come along when shards are merged: each with its own result, and only those."""

from pathlib import Path

import pytest
from worlds.recorded import Reciter, record
from worlds.runs import result, write_run

from uniteam.errors import DamagedFileError
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.recording.action_file import write_actions
from uniteam.evaluation.recording.bring_recordings import bring_recordings
from uniteam.evaluation.recording.order import ACTION_SUFFIX, RECORDINGS, recording_path
from uniteam.evaluation.results.run_folder import read_run
from uniteam.interface import DiscreteAction

SOME = [DiscreteAction.TURN_LEFT] * 300


def test_what_has_a_result_comes_along_and_what_has_none_stays(tmp_path: Path) -> None:
    folder = write_run(tmp_path / "run", {"a": [result(1, True)], "b": [result(2, True)]})
    for agent, episode in (("a", "e001"), ("a", "e002"), ("b", "e002"), ("c", "e001")):
        write_actions(recording_path(folder / RECORDINGS, agent, episode, ACTION_SUFFIX), agent, episode, SOME)
    out = tmp_path / "out"
    bring_recordings(read_run(folder), out)
    there = sorted(path for path in out.rglob("*") if path.is_file())
    assert there == [recording_path(out / RECORDINGS, *own, ACTION_SUFFIX) for own in (("a", "e001"), ("b", "e002"))]
    assert there[0].samefile(recording_path(folder / RECORDINGS, "a", "e001", ACTION_SUFFIX))  # a link


def test_actions_of_another_playing_are_refused(tmp_path: Path) -> None:
    folder = write_run(tmp_path / "run", {"a": [result(1, True)]})
    write_actions(recording_path(folder / RECORDINGS, "a", "e001", ACTION_SUFFIX), "a", "e001", SOME[1:])
    with pytest.raises(DamagedFileError, match="of another playing"):
        bring_recordings(read_run(folder), tmp_path / "out")


def test_a_recording_comes_along_and_one_of_another_playing_or_torn_is_refused(tmp_path: Path) -> None:
    made = record(tmp_path / "made.zip", Reciter((DiscreteAction.TURN_LEFT,)), AgentSpec("random", "truth"))
    folder = write_run(tmp_path / "run", {"random": [made.result]})
    path = recording_path(folder / RECORDINGS, "random", made.result.episode)
    path.parent.mkdir(parents=True)
    path.write_bytes(made.path.read_bytes())
    bring_recordings(read_run(folder), tmp_path / "out")
    brought = recording_path(tmp_path / "out" / RECORDINGS, "random", made.result.episode)
    assert brought.read_bytes() == made.path.read_bytes()
    path.unlink()
    path.write_bytes(made.path.read_bytes()[:1000])
    with pytest.raises(DamagedFileError, match="cannot be read"):
        bring_recordings(read_run(folder), tmp_path / "torn")
    other = record(path, Reciter(()), AgentSpec("random", "truth"))
    assert other.result != made.result
    with pytest.raises(DamagedFileError, match="of another playing"):
        bring_recordings(read_run(folder), tmp_path / "other")
