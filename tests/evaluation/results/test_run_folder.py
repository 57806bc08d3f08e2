"""The folder of a run as it is read: as it stands, and nothing in it changes."""

import logging
from pathlib import Path

import pytest
from worlds.runs import result, write_run

from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.evaluation.results.run_folder import read_run


def test_a_run_is_read_with_its_agents_in_the_configurations_order(tmp_path: Path) -> None:
    folder = write_run(tmp_path / "run", {"uniteam": [result(1, True)], "baseline": [result(1, False)], "oracle": []})
    lines = (folder / "results.jsonl").read_text().splitlines(keepends=True)
    (folder / "results.jsonl").write_text("".join(reversed(lines)))
    run = read_run(folder)
    assert list(run.results) == ["uniteam", "baseline"]
    assert run.results["uniteam"]["e001"].measures.overall_success
    assert run.configuration["split"] == "val"


def test_a_line_that_is_still_being_written_is_left_alone(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    folder = write_run(tmp_path / "run", {"uniteam": [result(1, True), result(2, True)]})
    whole = (folder / "results.jsonl").read_bytes()
    (folder / "results.jsonl").write_bytes(whole[:-40])
    with caplog.at_level(logging.WARNING):
        assert list(read_run(folder).results["uniteam"]) == ["e001"]
    assert "is not counted" in caplog.text
    assert (folder / "results.jsonl").read_bytes() == whole[:-40]
    assert sorted(path.name for path in folder.iterdir()) == ["config.json", "results.jsonl"]


def test_a_folder_that_is_no_run_and_a_damaged_one_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InvalidInputError, match=r"not the folder of a run.*uniteam evaluate"):
        read_run(tmp_path)
    folder = write_run(tmp_path / "run", {"uniteam": [result(1, True)]})
    (folder / "results.jsonl").write_text("{}\n")
    with pytest.raises(DamagedFileError, match="line 1 is"):
        read_run(folder)
