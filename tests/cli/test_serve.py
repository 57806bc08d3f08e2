"""`uniteam serve`, as a process, and agents that play what it serves."""

import json
import os
import re
import signal
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from threading import Thread
from typing import Any

import pytest

from uniteam.cli.main import main

pytest.importorskip("grpc", reason="the extra 'serve' is not installed")

import uniteam_client
from worlds.served import Turner, write_episodes

LONG = 150.0
"""s; on a machine with much to do a command takes a while to start and to end."""


@pytest.fixture
def starting() -> Iterator[Callable[..., subprocess.Popen[str]]]:
    """Start `uniteam serve`; whatever still runs is killed in the end."""
    started: list[subprocess.Popen[str]] = []

    def start(folder: Path, *arguments: str) -> subprocess.Popen[str]:
        command = [sys.executable, "-m", "uniteam.cli.main", "serve", "guest", *arguments]
        environment = {**os.environ, "COLUMNS": "200", "UNITEAM_TOKEN": ""}
        pipe = subprocess.PIPE
        started.append(subprocess.Popen(command, stdout=pipe, stderr=pipe, text=True, env=environment, cwd=folder))
        return started[-1]

    yield start
    for process in started:
        process.kill()
        process.wait()


def address_of(process: subprocess.Popen[str]) -> str:
    assert process.stdout is not None
    told = re.search(r'uniteam_client\.play\(agent, "(127\.0\.0\.1:\d+)"\)', process.stdout.readline())
    assert told is not None
    return told.group(1)


def free_port() -> str:
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return str(one.getsockname()[1])


@pytest.mark.slow
def test_a_run_that_is_stopped_goes_on_with_the_same_command_and_the_same_agent(
    starting: Callable[..., subprocess.Popen[str]], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_episodes(tmp_path / "two.jsonl.gz", 2)
    command = ("--split", "two.jsonl.gz", "--port", free_port(), "--out", "out", "--perception", "truth")
    first = starting(tmp_path, *command)
    address = address_of(first)

    def stop_the_server(episode: uniteam_client.Episode) -> None:
        if episode.id == "e0":
            first.send_signal(signal.SIGINT)
            first.wait(timeout=LONG)

    played: list[Any] = []
    agent = Thread(
        target=lambda: played.extend(uniteam_client.play(Turner(), address, wait=LONG, on_episode=stop_the_server)),
        daemon=True,
    )
    agent.start()
    told, errors = first.communicate(timeout=LONG)
    assert first.returncode == 130
    second = starting(tmp_path, *command)
    assert "1 of 2 results are kept in out. The same command goes on." in told and errors == ""
    again, _ = second.communicate(timeout=LONG)
    agent.join(timeout=LONG)
    assert [episode.id for episode in played] == ["e0", "e1"]
    assert "1 of 2 episodes were played before" in again and "guest (remote)" in again
    assert json.loads((tmp_path / "out" / "summary.json").read_text())["guest (remote)"]["episode_count"] == 2

    split, out, page = (str(tmp_path / name) for name in ("two.jsonl.gz", "out", "page.html"))
    beside = (
        "evaluate",
        "--agents",
        "random",
        "--perception",
        "truth",
        "--split",
        split,
        "--out",
        out,
        "--workers",
        "1",
    )
    readings = {
        beside: "guest",
        ("leaderboard", out): "guest",
        ("compare", out): "guest",
        ("report", out, "--out", page): "",
    }
    for reading, name in readings.items():
        with pytest.raises(SystemExit) as ended:
            main(reading)
        assert (reading, ended.value.code) == (reading, 0)
        assert name in capsys.readouterr().out
    assert "guest (remote)" in (tmp_path / "page.html").read_text()


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("guest", "--port", "70000"), "--port must be from 0 to 65535"),
        (("guest", "--host", "192.0.2.1"), "192.0.2.1:8085 cannot be listened at"),
        (("guest", "--seats", "0"), "--seats must be at least 1"),
        (("guest", "--answer-seconds", "0"), "--answer-seconds must be above 0"),
        (("guest", "--episode-seconds", "nan"), "--episode-seconds must be above 0"),
        (("guest", "--split", "minval"), "did you mean 'minival'"),
        ((" ",), "the agent needs a name"),
    ],
)
def test_what_cannot_be_served_is_refused_in_a_sentence(
    arguments: tuple[str, ...],
    sentence: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit) as ended:
        main(["serve", *arguments])
    assert ended.value.code == 2
    assert sentence in capsys.readouterr().err
