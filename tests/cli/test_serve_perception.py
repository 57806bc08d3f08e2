"""`uniteam serve-perception`, as a process, and an episode played with what it serves."""

import os
import re
import signal
import subprocess
import sys
from collections.abc import Iterator

import pytest

from uniteam.cli.main import main
from uniteam.testing.depth_bands import DepthBands

pytest.importorskip("httpx", reason="the extra 'remote' is not installed")

SERVED = f"{DepthBands.__module__}:DepthBands"


@pytest.fixture
def server() -> Iterator[subprocess.Popen[str]]:
    command = [sys.executable, "-m", "uniteam.cli.main", "serve-perception", SERVED, "--port", "0"]
    environment = {**os.environ, "COLUMNS": "200"}
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment)
    yield process
    process.kill()
    process.wait()


def test_it_says_how_it_is_reached_serves_an_episode_and_ends_with_ctrl_c(
    server: subprocess.Popen[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert server.stdout is not None
    name = re.search(r"--perception (remote:http://127\.0\.0\.1:\d+)", server.stdout.readline())
    assert name is not None
    with pytest.raises(SystemExit) as ended:
        main(["run", "--agent", "random", "--perception", name.group(1)])
    assert ended.value.code in (0, None)
    server.send_signal(signal.SIGINT)
    assert server.wait(timeout=20) == 130


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("truth",), "needs the simulator's truth"),
        (("thruth",), "did you mean 'truth'"),
        ((SERVED, "--port", "70000"), "--port must be from 0 to 65535"),
        ((SERVED, "--host", "192.0.2.1"), "cannot be listened at"),
    ],
)
def test_what_cannot_be_served_is_refused_in_a_sentence(
    arguments: tuple[str, ...], sentence: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["serve-perception", *arguments])
    assert ended.value.code == 2
    assert sentence in capsys.readouterr().err
