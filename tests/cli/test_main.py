"""The command line: what it says when asked well, and when asked badly."""

import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pytest
from worlds.called import call, complaint

from uniteam.cli.main import COMMANDS, main
from uniteam.errors import UnknownNameError


def test_the_overview_names_every_command_with_an_example(capsys: pytest.CaptureFixture[str]) -> None:
    assert call("--help") == 0
    shown = capsys.readouterr().out
    for name, command in COMMANDS.items():
        assert command.purpose in shown
        assert command.example in shown
        assert command.example.startswith(f"uniteam {name}")


def test_the_package_runs_as_the_command_does() -> None:
    done = subprocess.run([sys.executable, "-m", "uniteam", "--version"], capture_output=True, text=True, check=True)
    assert done.stdout == f"uniteam {version('uniteam')}\n"


def test_the_overview_imports_nothing_slow() -> None:
    code = (
        "import sys\nfrom uniteam.cli.main import main\n"
        "try:\n    main(['--help'])\nexcept SystemExit:\n    pass\n"
        "print(sorted({'numba', 'mujoco', 'cv2', 'numpy', 'tyro'} & set(sys.modules)), file=sys.stderr)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stderr.strip() == "[]"


def test_the_version_is_the_packages_own(capsys: pytest.CaptureFixture[str]) -> None:
    assert call("--version") == 0
    assert capsys.readouterr().out.strip() == f"uniteam {version('uniteam')}"


@pytest.mark.parametrize("name", COMMANDS)
def test_each_commands_help_teaches_with_an_example(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert call(name, "--help") == 0
    words = " ".join(capsys.readouterr().out.replace("│", " ").split())
    assert f"Example: {COMMANDS[name].example}" in words


def test_a_misspelt_command_is_answered_with_the_nearest(capsys: pytest.CaptureFixture[str]) -> None:
    assert "unknown command 'evalute': did you mean 'evaluate'?" in complaint(capsys, "evalute")


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("--split", "minvial"), "unknown split or episode file 'minvial': did you mean 'minival'?"),
        (("--agents", "unitem"), "unknown agent 'unitem': did you mean 'uniteam'?"),
        (("--agents", "orakle"), "unknown agent 'orakle': did you mean 'oracle'?"),
        (("--perception", "truht"), "unknown perception 'truht': did you mean 'truth'?"),
        (("--without", "edge_margins"), "unknown improvement 'edge_margins': did you mean 'edge_margin'?"),
        (("--with", "drop_hight"), "unknown improvement 'drop_hight': did you mean 'drop_height'?"),
        (("--workers", "0"), "--workers must be at least 1, got 0"),
        (("--episodes", "0"), "--episodes must be at least 1, got 0"),
        (("--workers", "-" + "9" * 400), "--workers must be at least 1, got -999"),
        (("--agents",), "--agents needs at least one name"),
        (("--episode-seconds", "0"), "--episode-seconds must be above 0"),
        (("--episode-seconds", "nan"), "--episode-seconds must be above 0"),
        (("--episode-seconds", "1e400"), "--episode-seconds must be above 0"),
        (("--split", "\x1b[31m"), r"'\x1b[31m' holds a control character"),
    ],
)
def test_a_bad_value_of_evaluate_is_answered_in_one_sentence(
    arguments: tuple[str, ...], sentence: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert sentence in complaint(capsys, "evaluate", *arguments, "--out", str(tmp_path))
    assert list(tmp_path.iterdir()) == []


def test_a_flag_that_does_not_exist_is_answered_with_the_nearest(capsys: pytest.CaptureFixture[str]) -> None:
    assert call("evaluate", "--worker", "2") == 2
    assert "--workers" in capsys.readouterr().err


def test_a_damaged_split_is_answered_in_one_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    damaged = tmp_path / "mine.jsonl.gz"
    damaged.write_bytes(b"\x1f\x8b damaged")
    assert f"the episode file {damaged} cannot be read" in complaint(capsys, "run", "--split", str(damaged))


def test_an_episode_that_does_not_exist_is_answered_with_those_that_do(capsys: pytest.CaptureFixture[str]) -> None:
    assert "has episodes 0 to 9, there is no episode 10" in complaint(capsys, "run", "--episode", "10")


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("evaluate", "--agents", "random", "--out", "file"), "'file' cannot be written (File exists)"),
        (("evaluate", "--agents", "random", "--out", "file/out"), "'file/out' cannot be written (Not a directory)"),
        (("evaluate", "--agents", "random", "--out", "x" * 300), "cannot be written (File name too long)"),
        (("bench", "--out", "."), "'.' is a folder; give the name of a file"),
        (("bench", "--out", "file/bench.json"), "'file' cannot be written (File exists)"),
        (("run", "--video", ""), "'.' is a folder; give the name of a file"),
        (("run", "--video", "folder.mp4"), "'folder.mp4' is a folder; give the name of a file"),
        (("run", "--video", "film.avi"), "'film.avi' must end in .mp4"),
        (("run", "--video", "file/film.mp4"), "'file' cannot be written (File exists)"),
    ],
)
def test_an_output_that_cannot_be_written_is_told_before_the_work(
    arguments: tuple[str, ...],
    sentence: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("file").touch()
    Path("folder.mp4").mkdir()
    assert sentence in complaint(capsys, *arguments)
    assert capsys.readouterr().out == ""
    assert sorted(path.name for path in tmp_path.iterdir()) == ["file", "folder.mp4"]


def test_errors_show_their_traceback_where_it_is_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("UNITEAM_DEBUG", "1")
    with pytest.raises(UnknownNameError):
        main(["evalute"])
