"""Worker processes: every job is done once, whatever becomes of the worker that holds it."""

import logging
import os
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from contextlib import closing
from pathlib import Path
from typing import Any

import pytest
from worlds import jobs
from worlds.jobs import FOREVER, CountStarts

from uniteam.errors import UniteamError
from uniteam.evaluation.backends import processes
from uniteam.evaluation.backends.processes import SINGLE_THREADED, Lost, OutOfTime, WorkerProcesses


def third(number: int) -> str:
    return str(number % 3)


def outcomes_of(recipe: Any, todo: Sequence[Any], worker_count: int = 1, seconds: float = FOREVER) -> dict[Any, Any]:
    """Do the jobs and return their outcomes."""
    workers: WorkerProcesses[Any, Any] = WorkerProcesses(recipe, worker_count, seconds)
    return dict(workers.do(todo, str))


def is_alive(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    return True


def wait_for(path: Path) -> int:
    """Return the number that a process has written into a file."""
    for _ in range(600):
        if path.exists() and path.read_text():
            return int(path.read_text())
        time.sleep(0.05)
    raise AssertionError(f"{path} was never written")


def test_every_job_is_done_once_and_a_killed_worker_loses_only_its_own() -> None:
    workers: WorkerProcesses[int, tuple[int, int]] = WorkerProcesses(jobs.square_or_die, 2, FOREVER)
    outcomes = list(workers.do([1, 2, 3, -1, 4, 5, 6], third))
    squares = {number: outcome[0] for number, outcome in outcomes if isinstance(outcome, tuple)}
    lost = {number: outcome.reason for number, outcome in outcomes if isinstance(outcome, Lost)}
    assert len(outcomes) == 7
    assert squares == {n: n * n for n in (1, 2, 3, 4, 5, 6)}
    assert list(lost) == [-1]
    assert "memory" in lost[-1]
    assert os.getpid() not in {outcome[1] for _, outcome in outcomes if isinstance(outcome, tuple)}


def test_a_worker_goes_on_with_its_own_group() -> None:
    workers: WorkerProcesses[int, tuple[int, int]] = WorkerProcesses(jobs.square_or_die, 1, FOREVER)
    done = [number for number, _ in workers.do([1, 2, 3, 4, 5, 6, 7], third)]
    assert [n % 3 for n in done] == [1, 1, 1, 2, 2, 0, 0]


def test_the_second_worker_starts_when_the_first_is_ready(tmp_path: Path) -> None:
    assert len(outcomes_of(CountStarts(tmp_path), [1, 2, 3, 4], worker_count=2)) == 4
    seen = sorted(path.read_text() for path in tmp_path.glob("started_*"))
    assert seen in (["0 0", "1 1"], ["0 0"])


def test_a_users_error_in_a_worker_ends_the_run_with_its_sentence() -> None:
    with pytest.raises(UniteamError, match="the pack is damaged"):
        outcomes_of(jobs.fail_at_once, [1], worker_count=2)
    with pytest.raises(UniteamError, match="unknown number '99': did you mean '98'"):
        outcomes_of(jobs.square_or_die, [99])


def test_what_a_worker_cannot_import_is_told_in_one_sentence(capfd: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(UniteamError, match=r"cannot import .*No module named 'my_agent'"):
        outcomes_of(jobs.import_nothing, [1])
    assert capfd.readouterr().err == ""


def test_what_cannot_be_sent_to_a_worker_is_told_in_one_sentence() -> None:
    with pytest.raises(UniteamError, match=r"cannot be sent to a worker process .*package\.module:attribute"):
        WorkerProcesses(lambda charging: abs, 1, FOREVER)


def test_a_worker_that_dies_while_starting_ends_the_run_with_a_sentence() -> None:
    with pytest.raises(UniteamError, match="ended by itself with exit code 3 before its first episode"):
        outcomes_of(jobs.die_while_starting, [1])


def test_a_job_that_hangs_is_ended_and_charged_to_whom_it_belongs() -> None:
    outcomes = outcomes_of(jobs.hang, ["own", "world", "neither"], worker_count=2, seconds=1.0)
    assert outcomes["own"] == OutOfTime(1.0)
    assert isinstance(outcomes["world"], Lost)
    assert "more than 1 s" in outcomes["world"].reason
    assert outcomes["neither"] == "neither"


def test_workers_are_single_threaded_and_the_parent_is_left_as_it_was() -> None:
    before, mask = dict(os.environ), signal.pthread_sigmask(signal.SIG_BLOCK, [])
    assert outcomes_of(jobs.report_threads, SINGLE_THREADED) == dict.fromkeys(SINGLE_THREADED, "1")
    assert dict(os.environ) == before
    assert signal.pthread_sigmask(signal.SIG_BLOCK, []) == mask


class Collected(logging.Handler):
    """Keeps what it is handed."""

    def __init__(self) -> None:
        super().__init__()
        self.records: list[logging.LogRecord] = []

    def emit(self, record: logging.LogRecord) -> None:
        self.records.append(record)


def test_what_a_worker_logs_comes_out_in_the_parent_and_only_there(
    capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """The logger is this test's alone: what other tests have left at the root neither hears it nor prints it."""
    logger, collected = logging.getLogger("a_module"), Collected()
    monkeypatch.setattr(logger, "handlers", [collected])
    monkeypatch.setattr(logger, "propagate", False)
    monkeypatch.setattr(logging.getLogger(processes.__name__), "level", logging.WARNING)
    assert outcomes_of(jobs.log, ["the map is full"]) == {"the map is full": "the map is full"}
    assert [(record.name, record.getMessage()) for record in collected.records] == [("a_module", "the map is full")]
    assert capfd.readouterr().err == ""


def test_threads_that_an_agent_leaves_behind_do_not_keep_its_worker() -> None:
    began = time.monotonic()
    assert outcomes_of(jobs.leave_threads, [1]) == {1: 1}
    assert time.monotonic() - began < 20.0


def test_a_death_is_noticed_though_a_child_keeps_the_pipe_open() -> None:
    outcomes = outcomes_of(jobs.fork_and_die, [1], seconds=20.0)
    assert outcomes == {1: Lost("its process ended by itself with exit code 4")}


def test_leaving_early_ends_the_workers() -> None:
    workers: WorkerProcesses[int, tuple[int, int]] = WorkerProcesses(jobs.square_or_die, 1, FOREVER)
    with closing(workers.do([1, 2, 3], third)) as outcomes:
        _, (_, process) = next(outcomes)  # type: ignore[misc]
    assert not is_alive(process)


def test_workers_end_with_their_parent_in_the_middle_of_a_job(tmp_path: Path) -> None:
    parent = subprocess.Popen([sys.executable, jobs.__file__, str(tmp_path / "process")])
    worker = wait_for(tmp_path / "process")
    assert is_alive(worker)
    parent.kill()
    parent.wait()
    deadline = time.monotonic() + 2.0
    while is_alive(worker) and time.monotonic() < deadline:
        time.sleep(0.02)
    assert not is_alive(worker)
