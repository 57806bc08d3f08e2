"""The command that checks results by their actions."""

from pathlib import Path

import pytest
from worlds.called import call
from worlds.submitted import alter, write_submission


def test_it_says_how_many_agree_and_ends_with_2_where_one_does_not(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = write_submission(tmp_path)
    assert call("verify", str(folder), "--episodes", "1", "--seed", "3") == 0
    assert "1 episodes (of 2 that did not crash, drawn with --seed 3) come to" in capsys.readouterr().out
    alter(
        folder / "results.jsonl",
        lambda text: text.replace('"does_want_terminate": true', '"does_want_terminate": false'),
    )
    assert call("verify", str(folder)) == 2
    told = capsys.readouterr()
    assert told.out.count("does_want_terminate was false and is now true") == 2
    assert "2 of 2 episodes" in told.err


def test_what_cannot_be_checked_is_told_in_a_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert call("verify", str(tmp_path)) == 2
    assert "is not the folder of a run" in capsys.readouterr().err
    assert call("verify", str(tmp_path), "--seed", "-1") == 2
    assert "--seed must be from 0" in capsys.readouterr().err
