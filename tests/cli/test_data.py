"""`uniteam data check`: a report, and one sentence where the data cannot be played."""

import shutil
from pathlib import Path

import pytest

pytest.importorskip("alktx2", reason="the encoder has wheels for Linux only")

from worlds.called import call
from worlds.ovmm_miniature.tiny import write_tiny


def test_data_are_reported_and_their_first_fault_ends_the_command(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = write_tiny(tmp_path)
    assert call("data", "check", str(tmp_path)) == 0
    told = capsys.readouterr().out
    assert "1 episodes that can be played, in 1 homes" in told
    assert f"uniteam evaluate --split ovmm:{folder}" in told
    shutil.rmtree(tmp_path / "data" / "hssd-hab" / "scenes-uncluttered")
    assert call("data", "check", str(tmp_path)) == 2
    out, err = capsys.readouterr()
    assert "missing" in out and "1 of 1 scenes" in out
    assert "the data cannot be played as they are: 1 of 1 scenes" in " ".join(err.split())


def test_a_folder_without_episodes_is_told_what_belongs_there(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert call("data", "check", str(tmp_path)) == 2
    assert "there is no episodes.json.gz" in capsys.readouterr().err
