"""The commands that make and measure networks refuse what makes no sense, and say what to install."""

from importlib.util import find_spec
from pathlib import Path

import pytest

from uniteam.cli.main import main


def refused(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    """Run `uniteam`, which must end with a sentence and code 2, and return the sentence."""
    with pytest.raises(SystemExit) as ended:
        main(arguments)
    assert ended.value.code == 2
    return " ".join(capsys.readouterr().err.split())


@pytest.mark.parametrize(
    ("option", "value", "words"),
    [
        ("--homes", "0", "--homes must be from 1 to 4000, got 0"),
        ("--steps", "-3", "--steps must be from 1 to"),
        ("--proposal-homes", "5000", "--proposal-homes must be from 0 to"),
    ],
)
def test_train_refuses_numbers_without_sense(
    option: str, value: str, words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert words in refused(capsys, "train", "namer", "--work", str(tmp_path), option, value)


@pytest.mark.skipif(find_spec("torch") is not None, reason="PyTorch is installed")
def test_train_says_what_to_install(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert "pip install 'uniteam[train]'" in refused(capsys, "train", "segmenter", "--work", str(tmp_path))


def test_a_calibration_needs_networks(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert "train the segmenter and the namer first" in refused(capsys, "train", "calibration", "--work", str(tmp_path))


def test_perception_refuses_what_it_cannot_measure(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert "--views from 1" in refused(capsys, "perception", "--views", "0")
    assert "must end in .md" in refused(capsys, "perception", "--out", str(tmp_path / "tables.txt"))
    assert "unknown split" in refused(capsys, "perception", "--split", "vall")
