"""Play a split's episodes with several agents in parallel, keeping every result as it comes."""

from collections.abc import Callable
from contextlib import closing
from pathlib import Path
from types import TracebackType
from typing import Self

from uniteam.errors import InvalidInputError
from uniteam.evaluation.backends.processes import Lost, OutOfTime
from uniteam.evaluation.configuration import Run, resolve, wanted_episodes
from uniteam.evaluation.engines import Engine, in_processes
from uniteam.evaluation.episode_loop import crashed_result
from uniteam.evaluation.recording.order import RECORDINGS, RecordingOrder, recording_order
from uniteam.evaluation.results.home_robot import write_home_robot_results
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.evaluation.results.store import ResultStore
from uniteam.evaluation.results.summary import Summary, summarize, summarize_run
from uniteam.evaluation.worker import Attempt, PlayerSetup, camera_named
from uniteam.files import file_name
from uniteam.world.task.episode import Episode
from uniteam.world.task.grasp_rules import grasp_rule_named
from uniteam.world.task.splits import load_split

HOME_ROBOT = "home-robot"
"""The folder of a run that holds the results as HomeRobot's evaluator writes them, by agent."""

OnResult = Callable[[str, EpisodeResult], None]
OnLost = Callable[[str, Episode, Lost], None]


def home_of(episode: Episode) -> str:
    """Return the home of an episode."""
    return episode.home


class Evaluation:
    """A run in its directory: what is there, and what is still to be played. Close it, or use it in a `with`."""

    def __init__(self, run: Run, directory: Path) -> None:
        """Open the split and take up what the directory holds.

        Raises:
            UniteamError: an unknown name, a damaged file, a directory of another configuration, one that cannot be
                written, or one that another run writes into.
        """
        camera_named(run.camera)
        grasp_rule_named(run.grasp)
        self.run = run
        self.split = load_split(run.split)
        ids = {episode.id for episode in self.split.episodes}
        if len(ids) < len(self.split.episodes):
            raise InvalidInputError(f"the split {run.split} holds two episodes of one id; give each an id of its own")
        self._configuration = resolve(run, self.split)
        self._wanted = wanted_episodes(run, self.split)
        self.store = ResultStore(directory, self._configuration, ids)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self.close()

    def close(self) -> None:
        """Let other processes have the directory."""
        self.store.close()

    @property
    def attempts(self) -> list[Attempt]:
        """Every attempt of the run, episode by episode."""
        return [Attempt(agent, index) for index in self._wanted for agent in self.run.agents]

    @property
    def remaining(self) -> list[Attempt]:
        """The attempts without a result yet."""
        return [a for a in self.attempts if self._episode(a).id not in self.store.results.get(a.agent, {})]

    @property
    def wanted(self) -> list[Episode]:
        """The episodes that the run asks for."""
        return [self.split.episodes[index] for index in self._wanted]

    def results(self) -> dict[str, list[EpisodeResult]]:
        """Return the results of the episodes asked for, by agent in the configuration's order; agents with any only."""
        wanted = [episode.id for episode in self.wanted]
        played = self.store.results
        by_agent = {
            agent: [played[agent][i] for i in wanted if i in played[agent]]
            for agent in self.store.agents
            if agent in played
        }
        return {agent: results for agent, results in by_agent.items() if results}

    def play(
        self,
        worker_count: int,
        on_result: OnResult,
        on_lost: OnLost,
        group_of: Callable[[Episode], str] = home_of,
        record: str | None = None,
        engine: Engine = in_processes,
    ) -> None:
        """Play what remains, `worker_count` attempts at a time, and keep each result as it comes.

        An attempt that was lost by no fault of the agent has no result: a later run plays it again.

        Args:
            worker_count: how many processes, or tasks of a cluster.
            on_result: is told each result, once it is on the disk.
            on_lost: is told what was lost.
            group_of: a worker goes on with an episode of the same group as long as it can, and then with the first of
                those left.
            record: which episodes to record: "all", "failures", how many of the first ones, "actions" for those of all
                alone, or None for none.
            engine: what plays them.

        Raises:
            UniteamError: as raised in a worker.
            UnwritableError: a result cannot be written.
        """
        playing = engine(PlayerSetup(self.run, self._configuration, self.recordings(record)), worker_count)
        with closing(playing.do(self.remaining, lambda attempt: group_of(self._episode(attempt)))) as outcomes:
            for attempt, outcome in outcomes:
                self.keep(attempt, outcome, on_result, on_lost)

    def keep(
        self, attempt: Attempt, outcome: EpisodeResult | Lost | OutOfTime, on_result: OnResult, on_lost: OnLost
    ) -> None:
        """Put what came of an attempt on the disk, and tell it; raises UnwritableError."""
        episode = self._episode(attempt)
        if isinstance(outcome, Lost):
            self.store.record_lost(attempt.agent, episode.id, outcome.reason, outcome.traceback)
            on_lost(attempt.agent, episode, outcome)
            return
        result = _out_of_time(episode, outcome) if isinstance(outcome, OutOfTime) else outcome
        self.store.append(attempt.agent, result)
        on_result(attempt.agent, result)

    def recordings(self, record: str | None) -> RecordingOrder:
        """Return what `play` would record, and where; raises InvalidInputError where `record` is no such wish."""
        return recording_order(record, self.store.directory / RECORDINGS, [episode.id for episode in self.wanted])

    def summaries(self) -> dict[str, Summary]:
        """Return the figures of every agent over the episodes that the run asks for."""
        return {agent: summarize(results) for agent, results in self.results().items()}

    def write_summary(self) -> None:
        """Write the figures to `summary.json`, each agent's with what they are from, and the files of HomeRobot."""
        self.store.write_summary(summarize_run(self._configuration, self.results(), len(self._wanted)))
        numbers = {episode.id: number for number, episode in enumerate(self.split.episodes)}
        for agent, results in self.results().items():
            write_home_robot_results(self.store.directory / HOME_ROBOT / file_name(agent), results, numbers)

    def _episode(self, attempt: Attempt) -> Episode:
        return self.split.episodes[attempt.episode]


def _out_of_time(episode: Episode, outcome: OutOfTime) -> EpisodeResult:
    sentence = f"the agent took more than {outcome.seconds:g} s"
    return crashed_result(episode, f"ran out of time: {sentence}", f"No traceback: {sentence}.")
