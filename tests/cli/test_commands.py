"""The commands at work, on short episodes: the random agent stops soon."""

import json
from pathlib import Path

import cv2
import pytest
from worlds.called import call


def test_run_tells_an_episode_and_films_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    film = tmp_path / "film.mp4"
    assert call("run", "--agent", "random", "--episode", "3", "--video", str(film)) == 0
    told = capsys.readouterr().out
    assert "RANDOM: The dice say" in told
    assert "partial_success" in told
    steps = int(next(line.split()[1] for line in told.splitlines() if line.strip().startswith("num_steps")))
    capture = cv2.VideoCapture(str(film))
    frames = [frame for ok, frame in iter(capture.read, (False, None)) if ok]
    assert len(frames) == steps - 1 + 20
    assert frames[0].shape == (720, 1280, 3)
    assert frames[0][56:378, 674:1266].std() > 15.0  # the third-person view shows something
    assert frames[0][56:480, 14:332].std() > 5.0  # and so does the head camera


def test_evaluate_prints_the_table_and_goes_on_from_what_it_has(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    command = ("evaluate", "--agents", "random", "--episodes", "1", "--workers", "1", "--out", str(tmp_path))
    assert call(*command) == 0
    first = capsys.readouterr().out
    for word in ("FindObj", "Overall", "random", "Split minival", "perception learned"):
        assert word in first
    assert json.loads((tmp_path / "summary.json").read_text())["random"]["episode_count"] == 1
    assert call(*command) == 0
    assert "1 of 1 episodes were played before" in capsys.readouterr().out
    assert len((tmp_path / "results.jsonl").read_text().splitlines()) == 1


def test_doctor_finds_this_installation_whole(capsys: pytest.CaptureFixture[str]) -> None:
    assert call("doctor") == 0
    told = capsys.readouterr().out
    assert "Everything is in place" in told
    assert "checksum" in told
    assert "graspable objects" in told
