"""What is shown comes through every encoding, and what comes from outside does nothing to the terminal."""

import os
import subprocess
import sys
from collections.abc import Mapping

import pytest
from rich.console import Console

from uniteam.cli.terminal import shown


@pytest.mark.parametrize(
    "text",
    [
        "\x1b[31mred",
        "a\nb",
        "a\rb",
        "\x9b2J",
        "right\u202eleft",
        "half\udc80",
        "nul\0",
        "\x7f",
        "line\u2028two",
        "[/b]",
    ],
)
def test_what_comes_from_outside_is_shown_and_does_nothing(text: str) -> None:
    console = Console(width=200, emoji=False)
    with console.capture() as captured:
        console.print(shown(text), end="")
    printed = captured.get()
    assert printed.isprintable()
    assert printed.isascii()
    assert len(printed) >= len(text)


def test_ordinary_text_is_shown_as_it_is() -> None:
    assert shown("Küche – 3.5 m") == "Küche – 3.5 m"


def uniteam(*arguments: str, **variables: str) -> subprocess.CompletedProcess[bytes]:
    environment: Mapping[str, str] = os.environ | variables
    command = [sys.executable, "-m", "uniteam.cli.main", *arguments]
    return subprocess.run(command, env=environment, capture_output=True)


@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "cp1252", "utf-8"])
@pytest.mark.parametrize("command", [("--help",), ("evaluate", "--help"), ("assets", "--category", "chair")])
def test_nothing_is_lost_to_an_encoding(encoding: str, command: tuple[str, ...]) -> None:
    done = uniteam(*command, PYTHONIOENCODING=encoding)
    assert done.returncode == 0
    assert done.stderr == b""
    done.stdout.decode(encoding)


@pytest.mark.parametrize(
    "variables",
    [
        {"TERM": "dumb"}, {"TERM": ""}, {"COLUMNS": "1"}, {"COLUMNS": "0"}, {"COLUMNS": "-5"}, {"COLUMNS": "wide"},
        {"LANG": "C", "LC_ALL": "C"}, {"LC_ALL": "no_SUCH.locale"}, {"HOME": "/nowhere"}, {"TMPDIR": "/nowhere"},
        {"NO_COLOR": "1"}, {"FORCE_COLOR": "1"}, {"UNITEAM_LOG": "debug"}, {"PYTHONUTF8": "0"},
    ],
    ids=str,
)  # fmt: skip
def test_an_odd_environment_does_no_harm(variables: dict[str, str]) -> None:
    done = uniteam("assets", **variables)
    assert done.returncode == 0
    assert b"Traceback" not in done.stderr


@pytest.mark.parametrize(
    ("variable", "value"), [("NUMBA_NUM_THREADS", "0"), ("UNITEAM_LOG", "loud"), ("MUJOCO_GL", "nonsense")]
)
def test_an_environment_that_cannot_work_is_one_sentence(variable: str, value: str) -> None:
    done = uniteam("evaluate", "--agents", "nobody", **{variable: value})
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1
    assert variable in done.stderr.decode()


def test_output_that_nobody_reads_to_its_end_is_no_error() -> None:
    command = f"{sys.executable} -m uniteam.cli.main assets --category cup | head -n 1"
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True)
    assert done.stderr == ""


def test_output_that_is_closed_is_no_error() -> None:
    done = subprocess.run(["bash", "-c", f"{sys.executable} -m uniteam.cli.main --version >&-"], capture_output=True)
    assert done.stderr == b""
    assert done.returncode == 0


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="this system has no device that is always full")  # noqa: PTH110
def test_output_that_cannot_be_written_is_one_sentence() -> None:
    with open("/dev/full", "wb") as full:  # noqa: PTH123
        command = [sys.executable, "-m", "uniteam.cli.main", "assets"]
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True)
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1
    assert "No space left" in done.stderr
