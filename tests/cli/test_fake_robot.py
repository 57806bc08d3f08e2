"""`uniteam fake-robot`, as a process that a plain client drives, and `uniteam rehearse`."""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from worlds.called import call
from worlds.fake_robot import free_ports
from worlds.plain_client import PlainClient

pytest.importorskip("zmq", reason="the extra 'robot' is not installed")

FIRST = free_ports()


@pytest.fixture
def process() -> Iterator[subprocess.Popen[str]]:
    command = [sys.executable, "-m", "uniteam.cli.main", "fake-robot", "--port", str(FIRST), "--agility", "5"]
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    process = subprocess.Popen(command, text=True, env={**os.environ, "COLUMNS": "200"}, **pipes)  # type: ignore[call-overload]
    yield process
    process.kill()
    process.wait()


@pytest.mark.slow
def test_it_says_where_it_is_is_driven_and_hears_its_run_stop(process: subprocess.Popen[str]) -> None:
    assert process.stdout is not None and process.stdin is not None
    assert process.stdout.readline().startswith("Move ")
    assert f"ports {FIRST} to {FIRST + 3}" in process.stdout.readline()
    client = PlainClient(FIRST)
    client.head_to(0.4, -0.6)
    process.stdin.write("r\n")
    process.stdin.flush()
    client.wait(lambda: client.state["is_runstopped"], 20.0, "the run-stop")
    client.close()
    assert process.stdout.readline().strip() == "The run-stop is engaged."
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=30) == 130


def test_a_rehearsal_has_a_row_for_each_drift_and_a_column_for_each_latency(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", "200")
    folder = tmp_path / "rehearsal"
    dials = ("--drift", "0", "0.05", "--latency", "0", "0.05", "--agility", "4", "--steps", "3")
    assert call("rehearse", "--agent", "baseline", "--episodes", "1", *dials, "--out", str(folder)) == 0
    told = capsys.readouterr().out
    assert "latency 0.05 s" in told
    assert told.count("0 of 1 (0-79 %), 0 %") == 5
    assert told.count("0 unlike the simulator") == 4
    written = json.loads((folder / "rehearsal.json").read_text())
    settings = written["settings"]
    assert [run["measures"]["num_steps"] for run in written["simulator"]] == [3]
    tried = [(each["dials"]["drift"], each["dials"]["latency"]) for each in settings]
    assert tried == [(0.0, 0.0), (0.0, 0.05), (0.05, 0.0), (0.05, 0.05)]
    assert [s["runs"][0]["steps"] for s in settings] == [3, 3, 3, 3]
    assert settings[1]["runs"][0]["seconds"] > settings[0]["runs"][0]["seconds"]


def test_a_rehearsal_goes_on_where_it_was_stopped_and_with_more_dials(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    def rehearse(*more: str) -> int:
        plain = ("--agent", "baseline", "--episodes", "1", "--latency", "0", "--agility", "4", "--out", str(tmp_path))
        return call("rehearse", *plain, *more)

    assert rehearse("--drift", "0", "0.05", "--steps", "3") == 0
    journal = tmp_path / "rehearsed.jsonl"
    whole = journal.read_bytes()
    first, _, _ = whole.split(b"\n", 2)
    journal.write_bytes(first.replace(b'"steps":3', b'"steps":99') + b"\n" + whole.splitlines()[1][:40])
    assert rehearse("--drift", "0", "0.05", "0.1", "--steps", "3") == 0
    lines = journal.read_text().splitlines()
    assert json.loads(lines[0])["rehearsed"]["steps"] == 99  # what was played is not played again
    assert [json.loads(line)["rehearsed"]["steps"] for line in lines[1:]] == [3, 3, 3]
    assert [json.loads(line)["dials"] and json.loads(line)["dials"]["drift"] for line in lines] == [None, 0, 0.05, 0.1]
    capsys.readouterr()
    assert rehearse("--drift", "0", "--steps", "4") == 2
    assert "holds a rehearsal of another configuration (steps was 3 and is now 4)" in capsys.readouterr().err


def test_a_rehearsal_over_sockets_says_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", "200")
    dials = ("--drift", "0", "--latency", "0", "--agility", "4", "--steps", "3", "--over", "sockets")
    assert call("rehearse", "--agent", "baseline", "--episodes", "1", *dials, "--out", str(tmp_path)) == 0
    told = capsys.readouterr().out
    assert "over sockets" in told
    assert "0 unlike the simulator" in told
    assert "stopped" not in told


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("fake-robot", "--latency", "9"), "the dial latency must be from 0 to 2, got 9"),
        (("fake-robot", "--drift", "nan"), "the dial drift must be from 0 to 0.5"),
        (("fake-robot", "--episode", "99"), "has episodes 0 to 9, not 99"),
        (("fake-robot", "--port", "0"), "it is the first of four"),
        (("rehearse", "--episodes", "0"), "--episodes must be at least 1"),
        (("rehearse", "--drift"), "need at least one number each"),
        (("rehearse", "--holes", "2"), "the dial holes must be from 0 to 0.9"),
        (("rehearse", "--out", __file__), "cannot be written"),
    ],
)
def test_what_cannot_be_is_refused_in_a_sentence(
    arguments: tuple[str, ...], sentence: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert call(*arguments) == 2
    (line,) = capsys.readouterr().err.strip().splitlines()
    assert sentence in line
