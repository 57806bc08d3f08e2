"""A run that is played in shards, killed and taken up again: the same as one that was not."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from worlds.called import call

from uniteam.evaluation.recording.order import RECORDINGS, recording_path
from uniteam.evaluation.recording.recording import read_recording
from uniteam.evaluation.results.result import result_from_line
from uniteam.world.task.episode import Split
from uniteam.world.task.splits import load_split, write_split

PLAY = ("evaluate", "--agents", "random", "--workers", "1")


def command(*arguments: str) -> list[str]:
    return [sys.executable, "-m", "uniteam.cli.main", *arguments]


def kill_after(folder: Path, size: int, *arguments: str) -> None:
    """Begin a run, and kill it and its workers with SIGKILL as soon as its results are larger than `size` bytes."""
    run = subprocess.Popen(command(*arguments), stdout=subprocess.DEVNULL, start_new_session=True)
    results = folder / "results.jsonl"
    for _ in range(6000):  # five minutes: the first command on a machine compiles the kernels
        if run.poll() is not None or (results.exists() and results.stat().st_size > size):
            break
        time.sleep(0.05)
    os.killpg(run.pid, signal.SIGKILL)
    run.wait()


@pytest.mark.slow
def test_shards_that_are_killed_and_taken_up_make_the_run_that_was_not(tmp_path: Path) -> None:
    whole, parts, out = tmp_path / "whole", [tmp_path / f"part{k}" for k in (1, 2)], tmp_path / "out"
    play = (*PLAY, "--record", "all")
    subprocess.run(command(*play, "--out", str(whole)), check=True, stdout=subprocess.DEVNULL)
    for number, part in enumerate(parts, start=1):
        given = (*play, "--shard", f"{number}/2", "--out", str(part))
        kill_after(part, 0 if number == 1 else -1, *given)  # after the first result, and before any
        kill_after(part, 1500, *given)
        with (part / "results.jsonl").open("ab") as file:
            file.write(b'{"agent": "random", "epis')  # what a power cut leaves
        subprocess.run(command(*given), check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    assert call("merge", *map(str, parts), "--out", str(out)) == 0
    for name in ("summary.json", "config.json"):
        assert (out / name).read_bytes() == (whole / name).read_bytes()
    lines = (out / "results.jsonl").read_text().splitlines()
    assert len(lines) == 10
    for line in lines:
        agent, result = result_from_line(line)
        recording = read_recording(recording_path(out / RECORDINGS, agent, result.episode))
        assert recording.result == result
    assert sum(path.is_file() for path in (out / RECORDINGS).rglob("*")) == 10


@pytest.fixture(scope="module")
def two_episodes(tmp_path_factory: pytest.TempPathFactory) -> Path:
    minival = load_split("minival")
    episodes = minival.episodes[:2]
    path = tmp_path_factory.mktemp("split") / "two.jsonl.gz"
    write_split(Split("two", episodes, {e.home: minival.homes[e.home] for e in episodes}), path)
    return path


def test_a_shard_has_a_folder_of_its_own_and_no_other_is_played_into_it(
    two_episodes: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    given = (*PLAY, "--split", str(two_episodes), "--shard")
    assert call(*given, "1/2") == 0
    folder = tmp_path / "runs" / "two-learned-half-challenge-shard-1-of-2"
    assert len((folder / "results.jsonl").read_text().splitlines()) == 1
    assert call(*given, "2/2", "--out", str(folder)) == 2
    assert "shard.number was 1 and is now 2" in capsys.readouterr().err
    assert call("merge", str(folder), "--out", "whole") == 2
    told = capsys.readouterr()
    assert "1 results of 1 shards are in whole" in told.out
    assert "'whole' is not complete, since these are missing: shard 2 of 2" in told.err
    assert call(*given[:-1], "--out", "whole") == 0
    assert "1 of 2 episodes were played before" in capsys.readouterr().out
    assert len((tmp_path / "whole" / "results.jsonl").read_text().splitlines()) == 2


@pytest.mark.parametrize("shard", ["0/2", "3/2", "half", "12/12"])
def test_a_shard_that_cannot_be_is_answered_in_a_sentence(
    shard: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert call(*PLAY, "--shard", shard, "--out", str(tmp_path)) == 2
    assert "shard" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
