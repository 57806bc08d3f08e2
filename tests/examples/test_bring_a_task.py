"""The example of a task of one's own works as its first lines say."""

from pathlib import Path

import pytest
from examples.conftest import Call

from uniteam.world.task.splits import load_split


def test_the_episodes_made_by_hand_make_a_split(tidy_loft: Path) -> None:
    split = load_split(tidy_loft)
    assert [str(episode.instruction) for episode in split.episodes] == ["Move cup from table to couch"] * 3
    assert len({split.homes[episode.home].by_name["mug_1"].position for episode in split.episodes}) == 3


def test_the_episodes_made_by_hand_are_played(
    call: Call, tidy_loft: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = ("--out", str(tmp_path / "out"), "--workers", "1", "--episodes", "1")
    assert call("evaluate", "--agents", "uniteam-plus", "--perception", "truth", "--split", str(tidy_loft), *out) == 0
    assert "uniteam-plus, loft-0-mug: success" in capsys.readouterr().out
