"""Worker processes: every job is done once, whatever becomes of the worker that holds it."""

import os
from contextlib import closing
from pathlib import Path

import pytest
from worlds.jobs import CountStarts, fail_at_once, report_threads, square_or_die

from uniteam.errors import UniteamError
from uniteam.evaluation.backends.processes import SINGLE_THREADED, Job, Lost, WorkerPool


def jobs(numbers: list[int]) -> list[Job[int]]:
    return [Job(number, group=str(number % 3)) for number in numbers]


def test_every_job_is_done_once_and_a_killed_worker_loses_only_its_own() -> None:
    pool: WorkerPool[int, tuple[int, int]] = WorkerPool(square_or_die, worker_count=2)
    outcomes = list(pool.do(jobs([1, 2, 3, -1, 4, 5, 6])))
    squares = {number: outcome[0] for number, outcome in outcomes if not isinstance(outcome, Lost)}
    lost = {number: outcome.reason for number, outcome in outcomes if isinstance(outcome, Lost)}
    assert len(outcomes) == 7
    assert squares == {n: n * n for n in (1, 2, 3, 4, 5, 6)}
    assert list(lost) == [-1]
    assert "memory" in lost[-1]
    assert os.getpid() not in {outcome[1] for _, outcome in outcomes if not isinstance(outcome, Lost)}


def test_a_worker_goes_on_with_its_own_group() -> None:
    pool: WorkerPool[int, tuple[int, int]] = WorkerPool(square_or_die, worker_count=1)
    done = [number for number, _ in pool.do(jobs([1, 2, 3, 4, 5, 6, 7]))]
    assert [n % 3 for n in done] == [1, 1, 1, 2, 2, 0, 0]


def test_the_second_worker_starts_when_the_first_is_ready(tmp_path: Path) -> None:
    pool: WorkerPool[int, int] = WorkerPool(CountStarts(tmp_path), worker_count=2)
    assert len(list(pool.do(jobs([1, 2, 3, 4])))) == 4
    seen = sorted(path.read_text() for path in tmp_path.glob("started_*"))
    assert seen in (["0 0", "1 1"], ["0 0"])


def test_a_users_error_in_a_worker_ends_the_run_with_its_sentence() -> None:
    with pytest.raises(UniteamError, match="the pack is damaged"):
        list(WorkerPool[int, int](fail_at_once, worker_count=2).do(jobs([1])))
    with pytest.raises(UniteamError, match="unknown number '99': did you mean '98'"):
        list(WorkerPool[int, tuple[int, int]](square_or_die, worker_count=1).do(jobs([99])))


def test_workers_are_single_threaded_and_the_parent_is_left_as_it_was() -> None:
    before = dict(os.environ)
    pool: WorkerPool[str, str | None] = WorkerPool(report_threads, worker_count=1)
    outcomes = dict(pool.do([Job(name, "all") for name in SINGLE_THREADED]))
    assert outcomes == dict.fromkeys(SINGLE_THREADED, "1")
    assert dict(os.environ) == before


def test_leaving_early_ends_the_workers() -> None:
    pool: WorkerPool[int, tuple[int, int]] = WorkerPool(square_or_die, worker_count=1)
    with closing(pool.do(jobs([1, 2, 3]))) as outcomes:
        _, (_, process) = next(outcomes)  # type: ignore[misc]
    with pytest.raises(ProcessLookupError):
        os.kill(process, 0)
