"""What plays a run's attempts: processes of this machine, or a Ray cluster."""

import shutil
from collections.abc import Callable, Generator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import mkdtemp
from typing import Protocol

from uniteam.evaluation.backends.processes import Lost, OutOfTime, WorkerProcesses
from uniteam.evaluation.backends.ray_tasks import RayTasks
from uniteam.evaluation.backends.serving import Charging
from uniteam.evaluation.recording.order import RecordingOrder, forget_recordings
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.evaluation.worker import Attempt, EpisodePlayer, PlayerSetup
from uniteam.files import try_folder, write_whole

Outcomes = Generator[tuple[Attempt, EpisodeResult | Lost | OutOfTime]]


class Playing(Protocol):
    """Plays attempts, several at a time."""

    def do(self, jobs: Sequence[Attempt], group_of: Callable[[Attempt], str]) -> Outcomes:
        """Yield each attempt with its outcome, once what was recorded of it is on the disk."""


Engine = Callable[[PlayerSetup, int], Playing]
"""Takes what to play, and how many attempts at a time."""


def in_processes(setup: PlayerSetup, worker_count: int) -> Playing:
    """Play in processes of this machine."""
    workers: WorkerProcesses[Attempt, EpisodeResult | Lost] = WorkerProcesses(
        setup, worker_count, setup.run.episode_seconds
    )
    return workers


def on_ray(setup: PlayerSetup, task_count: int) -> Playing:
    """Play on a Ray cluster, of which no node but this one writes into the run; raises UnavailableError."""
    return _OnRay(setup, task_count)


@dataclass(frozen=True)
class _Carried:
    """An outcome with the files that were recorded of it, by their paths below the folder of recordings."""

    outcome: EpisodeResult | Lost
    files: Mapping[str, bytes]


@dataclass(frozen=True)
class _CarryingSetup:
    setup: PlayerSetup

    def __call__(self, charging: Charging) -> Callable[[Attempt], _Carried]:
        folder = Path(mkdtemp(prefix="uniteam-"))
        order = replace(self.setup.recordings, folder=folder)
        return _CarryingPlayer(replace(self.setup, recordings=order)(charging), folder)


class _CarryingPlayer:
    """Plays attempts, and hands over what was recorded in a folder of its own."""

    def __init__(self, player: EpisodePlayer, folder: Path) -> None:
        self._player, self._folder = player, folder

    def __call__(self, attempt: Attempt) -> _Carried:
        try:
            outcome = self._player(attempt)
            files = [path for path in self._folder.rglob("*") if path.is_file()]
            return _Carried(outcome, {path.relative_to(self._folder).as_posix(): path.read_bytes() for path in files})
        finally:
            shutil.rmtree(self._folder, ignore_errors=True)  # a recorder makes it anew


class _OnRay:
    def __init__(self, setup: PlayerSetup, task_count: int) -> None:
        self._order = setup.recordings
        self._tasks: RayTasks[Attempt, _Carried] = RayTasks(
            _CarryingSetup(setup), task_count, setup.run.episode_seconds
        )

    def do(self, jobs: Sequence[Attempt], group_of: Callable[[Attempt], str]) -> Outcomes:
        for attempt, carried in self._tasks.do(jobs, lambda job: f"{job.agent} {group_of(job)}"):
            if isinstance(carried, _Carried):
                _keep(self._order, attempt, carried)
                yield attempt, carried.outcome
            else:
                yield attempt, carried


def _keep(order: RecordingOrder, attempt: Attempt, carried: _Carried) -> None:
    """Write what was recorded, in place of what a run that was killed has left; raises UnwritableError."""
    if isinstance(carried.outcome, EpisodeResult):
        forget_recordings(order.folder, attempt.agent, carried.outcome.episode)
    for name, content in carried.files.items():
        path = order.folder / name
        try_folder(path.parent)
        write_whole(path, content)
