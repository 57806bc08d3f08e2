"""Worker processes that each do one task at a time, and may die of it without ending the run.

`concurrent.futures` gives up the whole pool when one process is killed; here the task that it held is reported as
lost and another worker takes its place.
"""

import os
import signal
from collections import Counter
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from multiprocessing import get_context
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from typing import Any, Generic, TypeVar

from uniteam.errors import UniteamError

Task = TypeVar("Task")
Outcome = TypeVar("Outcome")

SINGLE_THREADED = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")
"""Environment variables that are 1 in a worker: parallel episodes beat parallel loops."""


@dataclass(frozen=True)
class Job(Generic[Task]):
    """A task, and the group it belongs to: a worker goes on with its own group as long as it can."""

    task: Task
    group: str


@dataclass(frozen=True)
class Lost:
    """A worker died over its task; `reason` says how."""

    reason: str


@dataclass
class _Worker(Generic[Task]):
    process: BaseProcess
    pipe: Connection
    is_ready: bool = False
    job: Job[Task] | None = None
    group: str = ""


class WorkerPool(Generic[Task, Outcome]):
    """Does jobs in processes; a first worker starts alone, so that the others find in the cache what it compiles."""

    def __init__(self, make_player: Callable[[], Callable[[Task], Outcome]], worker_count: int) -> None:
        """Prepare the pool; no process starts yet.

        Args:
            make_player: picklable; called once in each worker, it returns the function that does a task.
            worker_count: how many processes at most.
        """
        self._make_player = make_player
        self._worker_count = worker_count
        self._workers: list[_Worker[Task]] = []
        self._queue: list[Job[Task]] = []

    def do(self, jobs: Sequence[Job[Task]]) -> Generator[tuple[Task, Outcome | Lost]]:
        """Yield each job's task with its outcome as it ends; the workers are gone when the iterator is.

        Raises:
            UniteamError: as raised in a worker, or when a worker dies before its first task.
        """
        self._queue = list(jobs)
        try:
            if self._queue:
                self._start_worker()
            while self._workers:
                pipes = {worker.pipe: worker for worker in self._workers}
                for pipe in wait(list(pipes)):
                    yield from self._answer(pipes[pipe])  # type: ignore[index]
        finally:
            for worker in self._workers:
                worker.process.terminate()
            for worker in self._workers:
                worker.process.join()
            self._workers.clear()

    def _answer(self, worker: _Worker[Task]) -> Iterator[tuple[Task, Outcome | Lost]]:
        """Receive what a worker has to say and give it its next job."""
        try:
            kind, content = worker.pipe.recv()
        except (EOFError, OSError):
            yield from self._bury(worker)
            return
        if kind == "error":
            raise UniteamError(content)
        if worker.job is not None:
            yield worker.job.task, content
        elif not worker.is_ready:
            worker.is_ready = True
            self._grow()
        self._assign(worker)

    def _bury(self, worker: _Worker[Task]) -> Iterator[tuple[Task, Outcome | Lost]]:
        worker.process.join()
        self._workers.remove(worker)
        reason = _describe_exit(worker.process.exitcode)
        if not worker.is_ready:
            raise UniteamError(f"a worker process {reason} before its first episode; run with fewer --workers")
        if worker.job is not None:
            yield worker.job.task, Lost(reason)
        self._grow()

    def _grow(self) -> None:
        """Start the workers that are still missing, as far as there is work for them."""
        waiting = sum(1 for worker in self._workers if worker.job is None)
        for _ in range(min(self._worker_count - len(self._workers), len(self._queue) - waiting)):
            self._start_worker()

    def _start_worker(self) -> None:
        context = get_context("spawn")
        ours, theirs = context.Pipe()
        process = context.Process(target=_work, args=(theirs, self._make_player), daemon=True)
        with _inherited(dict.fromkeys(SINGLE_THREADED, "1")):
            process.start()
        theirs.close()
        self._workers.append(_Worker(process, ours))

    def _assign(self, worker: _Worker[Task]) -> None:
        """Give a worker its next job, or let it go."""
        worker.job = None
        if not self._queue:
            worker.pipe.close()
            worker.process.join()
            self._workers.remove(worker)
            return
        worker.job = self._next_job(worker)
        worker.group = worker.job.group
        self._queue.remove(worker.job)
        with suppress(OSError):  # a worker that died while idle is found dead by the next wait
            worker.pipe.send(worker.job.task)

    def _next_job(self, worker: _Worker[Task]) -> Job[Task]:
        """Choose from the worker's group, else from the largest group that nobody is in, else the largest at all."""
        left = Counter(job.group for job in self._queue)
        taken = {other.group for other in self._workers if other is not worker}
        group = max(left, key=lambda name: (name == worker.group, name not in taken, left[name]))
        return next(job for job in self._queue if job.group == group)


def _work(pipe: Connection, make_player: Callable[[], Callable[[Any], Any]]) -> None:
    """Do tasks until the pipe closes."""
    try:
        player = make_player()
        pipe.send(("ready", None))
        while True:
            pipe.send(("outcome", player(pipe.recv())))
    except EOFError:
        return
    except UniteamError as error:
        pipe.send(("error", str(error)))


@contextmanager
def _inherited(variables: dict[str, str]) -> Iterator[None]:
    """Give the processes started within these environment variables, and leave Ctrl-C to their parent."""
    before = dict(os.environ)
    mask = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    os.environ.update(variables)
    try:
        yield
    finally:
        for name in variables:
            del os.environ[name]
        os.environ.update(before)
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)


def _describe_exit(code: int | None) -> str:
    if code == -signal.SIGKILL:
        return "was killed (by the system for want of memory, most likely)"
    if code is not None and code < 0:
        return f"was ended by {signal.Signals(-code).name}"
    return f"ended by itself with exit code {code}"
