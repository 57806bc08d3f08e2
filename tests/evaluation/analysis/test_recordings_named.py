"""Recordings by the names that people give them."""

from pathlib import Path

import pytest
from worlds.runs import result, write_run

from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.evaluation.analysis.recordings_named import recordings_named


def run_with_recordings(folder: Path, *agents: str) -> Path:
    run = write_run(folder, {agent: [result(0, True), result(1, False)] for agent in (*agents, "unrecorded")})
    for agent in agents:
        path = run / "recordings" / agent / "e000.zip"
        path.parent.mkdir(parents=True)
        path.touch()
    return run


def test_files_are_what_they_are_called() -> None:
    assert recordings_named(["a.zip"]) == [Path("a.zip")]
    assert recordings_named(["a.zip", "b/c.zip"]) == [Path("a.zip"), Path("b/c.zip")]


def test_a_run_and_an_episode_are_the_recordings_of_its_agents(tmp_path: Path) -> None:
    run = run_with_recordings(tmp_path / "run", "one", "two")
    one, two = (run / "recordings" / agent / "e000.zip" for agent in ("one", "two"))
    assert recordings_named([str(run), "e000"]) == [one, two]
    assert recordings_named([f"{run}:two", "e000"]) == [two]
    other = run_with_recordings(tmp_path / "other", "three")
    assert recordings_named([f"{run}:one", "e000", str(other)]) == [one, other / "recordings" / "three" / "e000.zip"]


def test_what_names_none_or_too_many_is_answered_with_what_to_do(tmp_path: Path) -> None:
    run = run_with_recordings(tmp_path / "run", "one", "two")
    other = run_with_recordings(tmp_path / "other", "three")
    with pytest.raises(InvalidInputError, match=r"give one FILE\.zip or two"):
        recordings_named([])
    with pytest.raises(InvalidInputError, match="3 agents have a recording of 'e000'"):
        recordings_named([str(run), "e000", str(other)])
    with pytest.raises(InvalidInputError, match="has no recording of 'e001'"):
        recordings_named([str(run), "e001"])
    with pytest.raises(UnknownNameError, match="did you mean 'e000'"):
        recordings_named([str(run), "e0000"])
