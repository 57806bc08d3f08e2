"""Worker processes that each do one job at a time, and may die of it or overrun their time without ending the run.

`concurrent.futures` gives up everything when one process is killed; here the job that it held is reported as lost and
another worker takes its place.
"""

import logging
import os
import pickle
import signal
from collections import Counter
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from multiprocessing import get_context, resource_tracker
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess
from time import monotonic, sleep
from typing import Generic, TypeVar

from uniteam.errors import UniteamError
from uniteam.evaluation.backends.serving import SIGNALS_LEFT_TO_PARENT, Charged, Charging, new_charged, serve

Job = TypeVar("Job")
Outcome = TypeVar("Outcome")

SINGLE_THREADED = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")
"""Environment variables that are 1 in a worker: parallel episodes beat parallel loops."""

_SIGNAL_GRACE = 0.2
"""s: a signal to the whole process group that ended a worker has reached this process by then, and ends the run."""

_EXIT_GRACE = 2.0
"""s that a worker without jobs has to end by itself."""

_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Lost:
    """A job came to nothing, by no fault of what it tried; `reason` says how ("its process was killed")."""

    reason: str
    traceback: str = ""


@dataclass(frozen=True)
class OutOfTime:
    """A job was ended after `seconds`, most of which it had itself charged to what it tried."""

    seconds: float


@dataclass
class _Worker(Generic[Job]):
    process: BaseProcess
    pipe: Connection
    charged: Charged
    is_ready: bool = False
    job: Job | None = None
    group: str = ""
    elapsed: float = 0.0
    elapsed_charged: float = 0.0


class WorkerProcesses(Generic[Job, Outcome]):
    """Does jobs in processes; a first worker starts alone, so that the others find in the cache what it compiles."""

    def __init__(
        self, make_player: Callable[[Charging], Callable[[Job], Outcome]], worker_count: int, seconds: float
    ) -> None:
        """Prepare; no process starts yet.

        Args:
            make_player: picklable; called once in each worker, it returns the function that does a job. It is given a
                context manager: time spent inside is charged to what the job tries (the agent), time outside is not.
            worker_count: how many processes at most.
            seconds: how long one job may take.

        Raises:
            UniteamError: `make_player` cannot be sent to another process.
        """
        try:
            self._recipe = pickle.dumps(make_player)
        except (pickle.PicklingError, AttributeError, TypeError) as error:
            raise UniteamError(
                f"what is to be played cannot be sent to a worker process ({error}); "
                "name it 'package.module:attribute', defined at the top of a module"
            ) from error
        self._worker_count = worker_count
        self._seconds = seconds
        self._workers: list[_Worker[Job]] = []
        self._queue: list[Job] = []
        self._group_of: Callable[[Job], str] = str
        self._last_tick = 0.0

    def do(
        self, jobs: Sequence[Job], group_of: Callable[[Job], str]
    ) -> Generator[tuple[Job, Outcome | Lost | OutOfTime]]:
        """Yield each job with its outcome as it ends; the workers are gone when the iterator is.

        Args:
            jobs: what to do.
            group_of: the group that a job belongs to; a worker goes on with its own group as long as it can.

        Raises:
            UniteamError: as raised in a worker, or when the only worker dies before its first job.
        """
        self._queue, self._group_of = list(jobs), group_of
        tick = min(1.0, self._seconds / 20.0)
        self._last_tick = monotonic()
        try:
            if self._queue:
                self._start_worker()
            while self._workers:
                for worker in self._wait(tick):
                    yield from self._answer(worker)
                yield from self._end_overdue(longest_tick=2.0 * tick)
        finally:
            for worker in self._workers:
                worker.process.kill()
            for worker in self._workers:
                worker.process.join(_EXIT_GRACE)
            self._workers.clear()

    def _wait(self, timeout: float) -> list[_Worker[Job]]:
        """Return the workers that have something to say or have died.

        A pipe alone does not tell a death: what a worker's agent has forked keeps it open.
        """
        ready = wait([worker.pipe for worker in self._workers], timeout)
        return [worker for worker in self._workers if worker.pipe in ready or not worker.process.is_alive()]

    def _answer(self, worker: _Worker[Job]) -> Iterator[tuple[Job, Outcome | Lost | OutOfTime]]:
        """Receive what a worker has to say and give it its next job."""
        try:
            if not worker.pipe.poll():
                raise EOFError
            kind, content = worker.pipe.recv()
        except (EOFError, OSError):
            yield from self._bury(worker)
            return
        if kind == "log":
            logging.getLogger(content.name).handle(content)
            return
        if kind == "error":
            raise UniteamError(content)
        if worker.job is not None:
            yield worker.job, content
        elif not worker.is_ready:
            worker.is_ready = True
            self._grow()
        self._assign(worker)

    def _end_overdue(self, longest_tick: float) -> Iterator[tuple[Job, Lost | OutOfTime]]:
        """Charge the time since the last tick to the jobs, and end the workers whose job has used up its own.

        A tick that took far too long was slept through by this process (a stopped process group, a laptop's lid), and
        so it was by the workers: only what a tick may take is counted.
        """
        now = monotonic()
        passed, self._last_tick = min(now - self._last_tick, longest_tick), now
        for worker in [w for w in self._workers if w.job is not None]:
            worker.elapsed += passed
            worker.elapsed_charged += passed if worker.charged.value else 0.0
            if worker.elapsed >= self._seconds and worker.job is not None:
                _log.warning("a worker process is ended: its job has taken %.0f s", worker.elapsed)
                worker.process.kill()
                worker.process.join()
                self._workers.remove(worker)
                is_own = worker.elapsed_charged >= worker.elapsed / 2.0
                late = f"took more than {self._seconds:g} s, most of them spent by the simulator or the machine"
                yield worker.job, OutOfTime(self._seconds) if is_own else Lost(late)
                self._grow()

    def _bury(self, worker: _Worker[Job]) -> Iterator[tuple[Job, Outcome | Lost | OutOfTime]]:
        worker.process.join()
        sleep(_SIGNAL_GRACE if worker.process.exitcode in (-signal.SIGTERM, -signal.SIGINT) else 0.0)
        self._workers.remove(worker)
        reason = _describe_exit(worker.process.exitcode)
        if not worker.is_ready:
            self._do_without(reason)
            return
        if worker.job is not None:
            yield worker.job, Lost(f"its process {reason}")
        self._grow()

    def _do_without(self, reason: str) -> None:
        """Go on with fewer workers after one died before its first job; raises UniteamError where it was the only one.

        The queue is not empty then, and no further worker would fare better.
        """
        if not self._workers:
            raise UniteamError(
                f"a worker process {reason} before its first episode; run with fewer --workers, and from a script "
                "only under 'if __name__ == \"__main__\":'"
            )
        self._worker_count = len(self._workers)
        _log.warning("a worker process %s before its first episode; %d go on", reason, self._worker_count)

    def _grow(self) -> None:
        """Start the workers that are still missing, as far as there is work for them."""
        waiting = sum(1 for worker in self._workers if worker.job is None)
        for _ in range(min(self._worker_count - len(self._workers), len(self._queue) - waiting)):
            self._start_worker()

    def _start_worker(self) -> None:
        context = get_context("spawn")
        ours, theirs = context.Pipe()
        charged = new_charged(context)
        process = context.Process(
            target=serve, args=(theirs, self._recipe, charged, _log.getEffectiveLevel()), daemon=True
        )
        with _inherited(dict.fromkeys(SINGLE_THREADED, "1")):
            process.start()
        theirs.close()
        self._workers.append(_Worker(process, ours, charged))

    def _assign(self, worker: _Worker[Job]) -> None:
        """Give a worker its next job, or let it go."""
        worker.job = None
        if not self._queue:
            worker.pipe.close()
            worker.process.join(_EXIT_GRACE)
            worker.process.kill()
            self._workers.remove(worker)
            return
        worker.job = self._next_job(worker)
        worker.group = self._group_of(worker.job)
        worker.elapsed = worker.elapsed_charged = 0.0
        self._queue.remove(worker.job)
        with suppress(OSError):  # a worker that died while idle is found dead by the next wait
            worker.pipe.send(worker.job)

    def _next_job(self, worker: _Worker[Job]) -> Job:
        """Choose from the worker's group, else from the largest group that nobody is in, else the largest at all."""
        left = Counter(self._group_of(job) for job in self._queue)
        taken = {other.group for other in self._workers if other is not worker}
        group = max(left, key=lambda name: (name == worker.group, name not in taken, left[name]))
        return next(job for job in self._queue if self._group_of(job) == group)


@contextmanager
def _inherited(variables: dict[str, str]) -> Iterator[None]:
    """Give the processes started within these environment variables, with the signals blocked that their parent gets.

    They are blocked until a worker has its own handlers, so that Ctrl-C while it imports leaves no traceback.
    """
    before = dict(os.environ)
    os.environ.update(variables)
    try:
        if hasattr(signal, "pthread_sigmask"):
            resource_tracker.ensure_running()  # it would unblock the signals when it starts
            mask = signal.pthread_sigmask(signal.SIG_BLOCK, SIGNALS_LEFT_TO_PARENT)
            try:
                yield
            finally:
                signal.pthread_sigmask(signal.SIG_SETMASK, mask)
        else:  # Windows
            yield
    finally:
        for name in variables:
            del os.environ[name]
        os.environ.update(before)


def _describe_exit(code: int | None) -> str:
    if code is not None and code < 0:
        if -code == getattr(signal, "SIGKILL", None):
            return "was killed (by the system for want of memory, most likely)"
        return f"was ended by {signal.Signals(-code).name}"
    return f"ended by itself with exit code {code}"
