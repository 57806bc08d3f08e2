"""`uniteam data check` of a file of ProcTHOR's houses: an account, and one sentence where none can be read."""

import gzip
import json
from pathlib import Path

import pytest
from worlds.called import call
from worlds.procthor_miniature import first_house, write_miniature


def test_houses_are_counted_and_what_is_left_out_of_them(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = write_miniature(tmp_path)
    assert call("data", "check", str(path)) == 0
    told = capsys.readouterr().out
    assert "2 houses; the first 2 were read." in told and "missing" not in told
    assert "have no like here, and are left out: 2 (1 DogBed, 1 Lettuce)." in told
    assert "found no place, and are left out: 1 (1 Pillow)." in told
    assert "uniteam home 0 --source procthor:" in told


def test_a_house_that_cannot_be_read_is_named_and_the_others_count(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "houses.jsonl"
    path.write_text(json.dumps(first_house()) + "\n" + json.dumps({**first_house(), "rooms": []}) + "\n")
    assert call("data", "check", str(path)) == 0
    told = " ".join(capsys.readouterr().out.split())
    assert "asset-database.json beside it" in told
    assert "1 houses cannot be read; the first: house 1 of" in told and "`rooms`" in told


@pytest.mark.parametrize("content", [b"", b"{}\n"])
def test_a_file_without_a_house_ends_the_command(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], content: bytes
) -> None:
    path = tmp_path / "houses.jsonl.gz"
    path.write_bytes(gzip.compress(content))
    assert call("data", "check", str(path)) == 2
    assert "no house of" in " ".join(capsys.readouterr().err.split())
