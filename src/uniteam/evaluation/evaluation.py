"""Play a split's episodes with several agents in parallel, keeping every result as it comes."""

from collections.abc import Callable, Iterable, Mapping
from contextlib import closing
from dataclasses import dataclass
from hashlib import sha256
from itertools import chain, zip_longest
from pathlib import Path
from typing import Any

import uniteam
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.backends.processes import Job, Lost, WorkerPool
from uniteam.evaluation.episode_loop import crashed_result
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.evaluation.results.store import ResultStore
from uniteam.evaluation.results.summary import Summary, summarize
from uniteam.evaluation.worker import Attempt, PlayerSetup, camera_named
from uniteam.world.task.episode import Episode, Split
from uniteam.world.task.splits import load_split

OnResult = Callable[[str, EpisodeResult], None]


@dataclass(frozen=True)
class Run:
    """What to evaluate.

    Attributes:
        split: a built-in split's name or a split file's path.
        agents: by the label they have in the results.
        perception: the kind of perception that the agents see with.
        camera: "half" or "full".
        episode_count: how many episodes to play; None for all of the split.
    """

    split: str
    agents: Mapping[str, AgentSpec]
    perception: str
    camera: str
    episode_count: int | None = None


class Evaluation:
    """A run in its directory: what is there, and what is still to be played."""

    def __init__(self, run: Run, directory: Path) -> None:
        """Open the split and take up what the directory holds.

        Raises:
            UniteamError: an unknown name, a damaged file, or a directory of another configuration.
        """
        camera_named(run.camera)
        self.run = run
        self.split = load_split(run.split)
        self.store = ResultStore(directory, resolve(run, self.split))
        self._wanted = choose_episodes(self.split.episodes, run.episode_count)

    @property
    def attempts(self) -> list[Attempt]:
        """Every attempt of the run, episode by episode."""
        return [Attempt(agent, index) for index in self._wanted for agent in self.run.agents]

    @property
    def remaining(self) -> list[Attempt]:
        """The attempts without a result yet."""
        return [a for a in self.attempts if self._episode(a).id not in self.store.results.get(a.agent, {})]

    def play(self, worker_count: int, on_result: OnResult) -> None:
        """Play what remains in `worker_count` processes and record each result as it comes."""
        jobs = [Job(attempt, self._episode(attempt).home) for attempt in self.remaining]
        pool: WorkerPool[Attempt, EpisodeResult] = WorkerPool(
            PlayerSetup(self.run.split, self.run.agents, self.run.camera), worker_count
        )
        with closing(pool.do(jobs)) as outcomes:
            for attempt, outcome in outcomes:
                result = self._lost(attempt, outcome) if isinstance(outcome, Lost) else outcome
                self.store.append(attempt.agent, result)
                on_result(attempt.agent, result)

    def summaries(self) -> dict[str, Summary]:
        """Return the figures of every agent that the directory has results of."""
        return {agent: summarize(list(results.values())) for agent, results in self.store.results.items() if results}

    def write_summary(self) -> None:
        """Write the figures to `summary.json`; each agent's say what they are from."""
        source = {
            "split": self.split.name,
            "perception": self.run.perception,
            "camera": self.run.camera,
            "version": uniteam.__version__,
        }
        self.store.write_summary({agent: {**source, **s.to_data()} for agent, s in self.summaries().items()})

    def _episode(self, attempt: Attempt) -> Episode:
        return self.split.episodes[attempt.episode]

    def _lost(self, attempt: Attempt, lost: Lost) -> EpisodeResult:
        sentence = f"its process {lost.reason}"
        return crashed_result(self._episode(attempt), f"crashed: {sentence}", f"No traceback: {sentence}.")


def resolve(run: Run, split: Split) -> dict[str, Any]:
    """Return everything the results depend on, as plain JSON data."""
    return {
        "version": uniteam.__version__,
        "code": source_digest(),
        "split": split.name,
        "episodes": _digest(repr(split.episodes).encode()),
        "perception": run.perception,
        "camera": run.camera,
        "agents": {label: spec.describe() for label, spec in run.agents.items()},
    }


def choose_episodes(episodes: Iterable[Episode], count: int | None) -> list[int]:
    """Return the indices of the first `count` episodes, taken from the homes in turn so that a few show many homes."""
    by_home: dict[str, list[int]] = {}
    for index, episode in enumerate(episodes):
        by_home.setdefault(episode.home, []).append(index)
    in_turn = [index for index in chain.from_iterable(zip_longest(*by_home.values())) if index is not None]
    return in_turn[:count]


def source_digest() -> str:
    """Return a digest of the source of world and mind: results of different code are different results."""
    root = Path(uniteam.__file__).parent
    paths = chain(root.glob("*.py"), (root / "world").rglob("*.py"), (root / "mind").rglob("*.py"))
    return _digest(b"".join(path.read_bytes() for path in sorted(paths)))


def _digest(content: bytes) -> str:
    return sha256(content).hexdigest()[:12]
