"""The example of an agent of one's own works as its first lines say."""

from pathlib import Path

import pytest
from examples.conftest import Call

from uniteam.testing import check_agent


def test_the_wanderer_has_its_row_in_the_table(
    call: Call, tidy_loft: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = ("--out", str(tmp_path / "out"), "--workers", "1")
    assert call("evaluate", "--agents", "bring_an_agent:Wanderer", "--split", str(tidy_loft), *out) == 0
    told = capsys.readouterr().out
    assert "bring_an_agent:Wanderer, loft-2-mug: " in told
    assert "crashed" not in told


def test_the_wanderer_keeps_what_an_agent_promises() -> None:
    check_agent("bring_an_agent:Wanderer")


def test_the_wanderer_drives_turns_and_stops_before_the_cup(
    call: Call, tidy_loft: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert call("run", "--agent", "bring_an_agent:Wanderer", "--split", str(tidy_loft)) == 0
    told = capsys.readouterr().out
    for words in ("DRIVE: There is room ahead.", "TURN: Something is in the way.", "FOUND: I stand before a cup."):
        assert words in told
