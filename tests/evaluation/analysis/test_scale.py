"""What many episodes would take."""

from dataclasses import replace
from pathlib import Path

import pytest
from worlds.runs import result, write_run

from uniteam.errors import InvalidInputError
from uniteam.evaluation.analysis.contestants import contestants_named
from uniteam.evaluation.analysis.scale import Taken, taken_by
from uniteam.evaluation.recording.order import RECORDINGS
from uniteam.evaluation.results.result import EpisodeResult


def slow(number: int, home: str, seconds: float) -> EpisodeResult:
    return replace(result(number, True, home), seconds=seconds, peak_memory=100.0 * number)


def taken(folder: Path, results: list[EpisodeResult]) -> Taken:
    (contestant,) = contestants_named([str(write_run(folder, {"a": results}))])
    return taken_by(contestant)


def test_the_mean_counts_and_no_worker_has_less_than_a_home(tmp_path: Path) -> None:
    each = taken(tmp_path / "run", [slow(1, "h1", 10.0), slow(2, "h1", 30.0), slow(3, "h2", 35.0)])
    assert (each.episodes, each.seconds, each.slowest, each.slowest_home) == (3, 25.0, 35.0, 40.0)
    assert (each.memory, each.recording) == (300.0, 0.0)
    assert each.hours(1440, 2) == pytest.approx(5.0)
    assert each.hours(1440, 10_000) == pytest.approx(40.0 / 3600.0)


def test_recordings_are_weighed_and_crashes_are_left_out(tmp_path: Path) -> None:
    folder = tmp_path / "run" / RECORDINGS / "a"
    crashed = replace(slow(3, "h2", 900.0), traceback="x")
    write_run(tmp_path / "run", {"a": [slow(1, "h1", 10.0), crashed]})
    folder.mkdir(parents=True)
    (folder / "e001.zip").write_bytes(b"x" * 100)
    (folder / "e003.zip").write_bytes(b"x" * 300)
    (folder / "e003.zip.cause.json").write_bytes(b"x" * 20)
    (contestant,) = contestants_named([str(tmp_path / "run")])
    each = taken_by(contestant)
    assert (each.episodes, each.slowest_home, each.recording) == (1, 10.0, 200.0)


def test_a_run_that_only_crashed_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InvalidInputError, match="no episode of 'a' came to its end"):
        taken(tmp_path / "run", [replace(slow(1, "h1", 1.0), traceback="x")])
