"""What a run of many episodes would take, from what a run of some has taken."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from statistics import fmean

from uniteam.errors import InvalidInputError
from uniteam.evaluation.analysis.contestants import Contestant
from uniteam.evaluation.recording.order import ACTION_SUFFIX, RECORDINGS, SUFFIX
from uniteam.evaluation.results.result import result_to_line
from uniteam.files import file_name


@dataclass(frozen=True)
class Taken:
    """What an agent's episodes have taken, of those that did not crash.

    Attributes:
        label: of the agent.
        episodes: how many there are.
        seconds: of one, mean (s).
        slowest: of one, the most (s).
        slowest_home: of all episodes in one home together, the most (s).
        memory: largest resident memory of a process (MB).
        line: of the results, mean (bytes).
        recording: of one episode, mean (bytes); 0 without any.
    """

    label: str
    episodes: int
    seconds: float
    slowest: float
    slowest_home: float
    memory: float
    line: float
    recording: float

    def hours(self, episodes: int, workers: int) -> float:
        """Return how long that many episodes take that many workers (h), of which none gets less than a home."""
        return max(episodes * self.seconds / workers, self.slowest_home) / 3600.0


def taken_by(contestant: Contestant) -> Taken:
    """Return what an agent's episodes have taken; raises InvalidInputError where all of them crashed."""
    results = [result for result in contestant.results.values() if not result.crashed]
    if not results:
        raise InvalidInputError(f"no episode of '{contestant.label}' came to its end; name another run or agent")
    by_home: dict[str, float] = {}
    for result in results:
        by_home[result.home] = by_home.get(result.home, 0.0) + result.seconds
    folder = contestant.run.directory / RECORDINGS / file_name(contestant.agent)
    files = [path for path in folder.glob("*") if path.name.endswith((SUFFIX, ACTION_SUFFIX))]
    return Taken(
        label=contestant.label,
        episodes=len(results),
        seconds=fmean(result.seconds for result in results),
        slowest=max(result.seconds for result in results),
        slowest_home=max(by_home.values()),
        memory=max(result.peak_memory for result in results),
        line=fmean(len(result_to_line(contestant.agent, result).encode()) for result in results),
        recording=_mean_size(files),
    )


def _mean_size(files: Iterable[Path]) -> float:
    sizes = [path.stat().st_size for path in files]
    return fmean(sizes) if sizes else 0.0
