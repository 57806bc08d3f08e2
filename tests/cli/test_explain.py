"""`uniteam explain`: causes of recorded episodes, and what is said where there is no recording."""

import json
from dataclasses import replace
from pathlib import Path

import cv2
import pytest
from worlds.called import call
from worlds.recorded import record_made
from worlds.runs import result, write_run
from worlds.saboteur import Saboteur

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.recording.order import RECORDINGS, recording_path
from uniteam.interface import DiscreteAction


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Ten episodes of two agents, one failure of which is recorded: a blind grasp."""
    made = tmp_path_factory.mktemp("recorded") / "one.zip"
    spoilt = AgentSpec("random", "truth")
    played = record_made(
        made, lambda environment: Saboteur(environment, lambda decisions: iter([DiscreteAction.SNAP_OBJECT])), spoilt
    )
    touching = result(9, True)
    touching = replace(touching, measures=replace(touching.measures, robot_scene_colls=2))
    agents = {
        "uniteam": [*(result(k, k < 6) for k in range(8)), touching, played.result],
        "baseline": [result(k, k < 1) for k in range(10)],
    }
    folder = write_run(tmp_path_factory.mktemp("runs") / "run", agents)
    path = recording_path(folder / RECORDINGS, "uniteam", played.result.episode)
    path.parent.mkdir(parents=True)
    made.rename(path)
    return folder


def test_causes_are_counted_from_all_episodes_to_overall_success(run: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert call("explain", str(run)) == 0
    lines = [[cell.strip() for cell in line.strip("│┃").split("│")] for line in capsys.readouterr().out.splitlines()]
    assert ["all", "10", "10"] in lines
    assert ["failed: find object", "-1", "0"] in lines and ["grasp out of view", "1", "0"] in lines
    assert ["failed: pick object", "-2", "-9"] in lines
    assert ["not to be told without a recording", "2", "9"] in lines
    assert ["failed: no collision", "-1", "0"] in lines and ["arm or load collided", "1", "0"] in lines
    assert ["overall success", "6", "1"] in lines and ["", "60.0 %", "10.0 %"] in lines


def test_each_failure_has_its_evidence_and_its_recording_in_figure_and_file(
    run: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    picture, file = tmp_path / "why.png", tmp_path / "why.json"
    assert call("explain", f"{run}:uniteam", "--figure", str(picture), "--json", str(file)) == 0
    told = capsys.readouterr().out
    assert "grasp out of view (find object), step 0 at (" in told
    recording = next((run / RECORDINGS / "uniteam").glob("*.zip"))
    assert f"  {recording}\n" in told and "no recording, so by the line of the result alone" in told
    image = cv2.imread(str(picture))
    assert image is not None and image.std() > 5.0
    (data,) = json.loads(file.read_text())
    assert (data["agent"], data["episodes"], data["overall_success"]) == ("uniteam", 10, 6)
    assert data["failed"]["find object"] == {"grasp out of view": 1}
    assert [each["recording"] for each in data["failures"] if each["cause"] == "grasp out of view"] == [str(recording)]
    assert len(data["failures"]) == 4


def test_a_recording_of_another_playing_is_not_used(
    run: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], caplog: pytest.LogCaptureFixture
) -> None:
    recording = next((run / RECORDINGS / "uniteam").glob("*.zip"))
    other = write_run(tmp_path / "other", {"uniteam": [replace(result(0, False), episode=recording.stem)]})
    copy = recording_path(other / RECORDINGS, "uniteam", recording.stem)
    copy.parent.mkdir(parents=True)
    copy.write_bytes(recording.read_bytes())
    assert call("explain", str(other)) == 0
    assert "not to be told without a recording" in capsys.readouterr().out
    assert "is of another playing than the result" in caplog.text
    copy.write_bytes(b"no archive")
    assert call("explain", str(other)) == 0
    assert "cannot be read" in caplog.text


def test_what_cannot_be_explained_is_answered_in_a_sentence(run: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert call("explain") == 2
    assert "name the folder of a run" in capsys.readouterr().err
    assert call("explain", str(run), "--figure", "why.gif") == 2
    assert "must end in .png" in capsys.readouterr().err
    assert call("explain", f"{run}:uniteem") == 2
    assert "did you mean 'uniteam'?" in capsys.readouterr().err
