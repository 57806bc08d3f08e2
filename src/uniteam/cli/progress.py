"""An evaluation under a progress bar, or line by line in a log."""

from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, SpinnerColumn, TextColumn, TimeRemainingColumn

from uniteam.cli.terminal import Interrupted, shown
from uniteam.evaluation.backends.processes import Lost
from uniteam.evaluation.engines import Engine, in_processes
from uniteam.evaluation.evaluation import Evaluation, home_of
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.world.task.episode import Episode


@contextmanager
def counting(console: Console, what: str, total: int) -> Iterator[Callable[[], None]]:
    """Show a bar that counts; what is given is called after each."""
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console) as progress:
        bar = progress.add_task(what, total=total)
        yield lambda: progress.advance(bar)


Words = Callable[[str, EpisodeResult], str]
"""Makes of an agent's result what stands beside the bar, markup of rich."""


def counting_successes(evaluation: Evaluation) -> Words:
    """Return the words that count each agent's successes so far."""
    return _Tally(evaluation).after


def play_under_bar(
    evaluation: Evaluation,
    worker_count: int,
    console: Console,
    make_words: Callable[[Evaluation], Words] = counting_successes,
    group_of: Callable[[Episode], str] = home_of,
    record: str | None = None,
    beginning: str = "starting (the first time on a machine, compiling)",
    engine: Engine = in_processes,
) -> list[str]:
    """Play what remains under a progress bar; return why episodes were lost.

    Args:
        evaluation: what to play.
        worker_count: in how many processes.
        console: to show the bar on.
        make_words: of the evaluation, what stands beside the bar.
        group_of: as `Evaluation.play` takes it.
        record: which episodes to record, as `Evaluation.play` takes it.
        beginning: what stands beside the bar until the first episode ends.
        engine: what plays them, as `Evaluation.play` takes it.
    """
    remaining, total = len(evaluation.remaining), len(evaluation.attempts)
    directory = shown(evaluation.store.directory)
    if remaining < total:
        console.print(f"{total - remaining} of {total} episodes were played before; their results are in {directory}.")
    if not remaining:
        return []
    columns = (
        SpinnerColumn(),
        BarColumn(),
        MofNCompleteColumn(),
        TimeRemainingColumn(),
        TextColumn("{task.description}"),
    )
    lost: list[str] = []
    with Progress(*columns, console=console, speed_estimate_period=600.0) as progress:
        bar = progress.add_task(beginning, total=total)
        progress.update(bar, completed=total - remaining)
        words_after = make_words(evaluation)

        def log(agent: str, episode: str, words: str) -> None:
            if not console.is_terminal:  # a log has no bar to watch
                done = f"{total - len(evaluation.remaining)}/{total}"
                console.print(f"{done} {shown(f'{agent}, {episode}: {words}')}", soft_wrap=True)

        def advance(agent: str, result: EpisodeResult) -> None:
            progress.update(bar, advance=1, description=words_after(agent, result))
            log(agent, result.episode, result.failure or "success")

        def note_lost(agent: str, episode: Episode, outcome: Lost) -> None:
            lost.append(outcome.reason)
            log(agent, episode.id, f"lost: {outcome.reason}")

        try:
            evaluation.play(worker_count, advance, note_lost, group_of, record, engine)
        except KeyboardInterrupt as stop:
            kept = total - len(evaluation.remaining)
            progress.update(bar, description="stopped")
            by = f" by {stop}" if isinstance(stop, Interrupted) else ""
            console.print(f"Stopped{by}: {kept} of {total} results are kept in {directory}. The same command goes on.")
            raise
    return lost


class _Tally:
    """Overall successes so far, as the progress bar's words."""

    def __init__(self, evaluation: Evaluation) -> None:
        self._played: Counter[str] = Counter()
        self._succeeded: Counter[str] = Counter()
        for agent, results in evaluation.results().items():
            for result in results:
                if agent in evaluation.run.agents:
                    self.after(agent, result)

    def after(self, agent: str, result: EpisodeResult) -> str:
        """Count a result and return the words."""
        self._played[agent] += 1
        self._succeeded[agent] += result.measures.overall_success
        counts = ", ".join(f"{name} {self._succeeded[name]}/{n}" for name, n in self._played.items())
        return shown(f"succeeded: {counts}")
