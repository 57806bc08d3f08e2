"""Jobs as tasks of a Ray cluster, one task for the jobs of a group (such as a home), on whichever node is free.

In a task the jobs are done by a worker process of `processes`, so that a job's time, its death and its exceptions come
to the same as there. A task that dies with its node or its process is given to another one by Ray, and begins anew.
"""

import logging
import os
import pickle
from collections.abc import Callable, Generator, Iterator, Sequence
from contextlib import closing
from dataclasses import dataclass
from types import ModuleType
from typing import Any, Generic, TypeVar

from uniteam.errors import UnavailableError, UniteamError
from uniteam.evaluation.backends.processes import Lost, OutOfTime, WorkerProcesses
from uniteam.evaluation.backends.serving import Charging

Job = TypeVar("Job")
Outcome = TypeVar("Outcome")

RETRIES = 10
"""How often a task is begun anew after its node or its process has died."""

_TICK = 1.0
"""s between two looks at Ctrl-C."""


@dataclass(frozen=True)
class _Refused:
    """What a worker process had to say before it gave up; it would say the same anywhere."""

    sentence: str


class RayTasks(Generic[Job, Outcome]):
    """Does jobs on a Ray cluster: of RAY_ADDRESS, one that runs on this machine, or a new one."""

    def __init__(
        self, make_player: Callable[[Charging], Callable[[Job], Outcome]], task_count: int, seconds: float
    ) -> None:
        """Connect to the cluster.

        Args:
            make_player: as `WorkerProcesses` takes it; what it names must be installed on every node.
            task_count: how many tasks at most are given to the cluster at a time; it runs one for each of its cores.
            seconds: how long one job may take.

        Raises:
            UnavailableError: Ray is not installed, or its cluster cannot be reached.
        """
        self._ray = connect()
        self._make_player, self._task_count, self._seconds = make_player, task_count, seconds

    def do(
        self, jobs: Sequence[Job], group_of: Callable[[Job], str]
    ) -> Generator[tuple[Job, Outcome | Lost | OutOfTime]]:
        """Yield each job with its outcome as its group ends; what still runs is cancelled when the iterator is closed.

        Args:
            jobs: what to do.
            group_of: the group that a job belongs to; the jobs of a group are one task.

        Raises:
            UniteamError: as raised in a worker.
        """
        ray = self._ray
        task = ray.remote(num_cpus=1, max_retries=RETRIES)(do_group)
        recipe = ray.put(pickle.dumps(self._make_player))
        waiting = list(_groups(jobs, group_of))[::-1]
        running: dict[Any, list[Job]] = {}
        try:
            while waiting or running:
                while waiting and len(running) < self._task_count:
                    group = waiting.pop()
                    running[task.remote(recipe, group, self._seconds)] = group
                for ref in ray.wait(list(running), timeout=_TICK)[0]:
                    yield from self._outcomes(ref, running.pop(ref))
        finally:
            for ref in running:
                ray.cancel(ref, force=True)

    def _outcomes(self, ref: Any, group: list[Job]) -> Iterator[tuple[Job, Outcome | Lost | OutOfTime]]:
        try:
            outcomes = self._ray.get(ref)
        except self._ray.exceptions.RayError as error:
            yield from ((job, Lost(f"its Ray task came to a {type(error).__name__}", str(error))) for job in group)
            return
        if isinstance(outcomes, _Refused):
            raise UniteamError(outcomes.sentence)
        yield from outcomes


def connect() -> ModuleType:
    """Return Ray, connected to its cluster; raises UnavailableError where it is not installed or cannot be reached."""
    os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
    try:
        import ray
    except ImportError as error:
        raise UnavailableError("Ray is not installed; install it with: pip install 'uniteam[ray]'") from error
    if not ray.is_initialized():
        try:
            ray.init(include_dashboard=False, log_to_driver=False, logging_level=logging.WARNING)
        except (ConnectionError, OSError, RuntimeError, ValueError) as error:
            raise UnavailableError(
                f"the Ray cluster cannot be reached ({error}); start it, or name another one by RAY_ADDRESS"
            ) from error
    module: ModuleType = ray
    return module


def do_group(recipe: bytes, jobs: list[Any], seconds: float) -> list[tuple[Any, Any]] | _Refused:
    """Do the jobs of a group in a process of this node and return their outcomes; what a task runs."""
    try:
        workers: WorkerProcesses[Any, Any] = WorkerProcesses(pickle.loads(recipe), 1, seconds)
        with closing(workers.do(jobs, lambda job: "")) as outcomes:
            return list(outcomes)
    except UniteamError as error:
        return _Refused(str(error))


def _groups(jobs: Sequence[Job], group_of: Callable[[Job], str]) -> Iterator[list[Job]]:
    by_group: dict[str, list[Job]] = {}
    for job in jobs:
        by_group.setdefault(group_of(job), []).append(job)
    yield from by_group.values()
