"""`uniteam evaluate`: agents over a split, and the challenge's table."""

import os
from collections import Counter
from pathlib import Path
from typing import Annotated, Literal

import tyro
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, SpinnerColumn, TextColumn, TimeRemainingColumn

import uniteam
from uniteam.errors import InvalidInputError
from uniteam.evaluation.agent_spec import label_agents
from uniteam.evaluation.analysis.table import challenge_table
from uniteam.evaluation.evaluation import Evaluation, Run
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.evaluation.results.summary import Summary, summarize


def evaluate(
    agents: tuple[str, ...] = ("baseline", "uniteam"),
    split: str = "minival",
    perception: str = "truth",
    episodes: Annotated[int | None, tyro.conf.arg(metavar="N")] = None,
    workers: Annotated[int | None, tyro.conf.arg(metavar="N")] = None,
    camera: Literal["half", "full"] = "half",
    out: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None,
    with_: Annotated[tuple[str, ...], tyro.conf.arg(name="with")] = (),
    without: tuple[str, ...] = (),
    breakdown: bool = False,
) -> None:
    """Play a split's episodes with one or more agents, in parallel, and print the challenge's table.

    The results are kept as they come: stop with Ctrl-C and give the same command again to go on. Give it with other
    agents to add rows to the table.

    Args:
        agents: Which agents: baseline, uniteam, random, or oracle, which is told the truth.
        split: A built-in split (minival, val, test-standard, test-challenge, train) or a file of episodes.
        perception: What the agents see with.
        episodes: How many episodes, taken from the homes in turn; all by default.
        workers: How many processes; as many as there are cores by default.
        camera: Images of 240x320 (half) or of 480x640 (full).
        out: Directory of the results; runs/SPLIT-PERCEPTION-CAMERA by default.
        with_: Improvements to add to the agents that lack them, by name (a wrong name lists them).
        without: Improvements to take from the agents that have them, by name.
        breakdown: Add a row for the seen and one for the unseen object categories.
    """
    _check_at_least_one(episodes=episodes, workers=workers)
    console = Console()
    run = Run(split, label_agents(agents, perception, with_, without), perception, camera, episodes)
    directory = out or Path("runs") / f"{Path(split).name.split('.')[0]}-{perception}-{camera}"
    evaluation = Evaluation(run, directory)
    _play(evaluation, workers or os.cpu_count() or 1, console)
    evaluation.write_summary()
    console.print(challenge_table(_rows(evaluation, breakdown), _caption(evaluation)))
    _report(evaluation, console)


def _check_at_least_one(**counts: int | None) -> None:
    for name, count in counts.items():
        if count is not None and count < 1:
            raise InvalidInputError(f"--{name} must be at least 1, got {count}")


def _play(evaluation: Evaluation, worker_count: int, console: Console) -> None:
    """Play what remains under a progress bar that counts the successes so far."""
    remaining, total = len(evaluation.remaining), len(evaluation.attempts)
    directory = evaluation.store.directory
    if remaining < total:
        console.print(f"{total - remaining} of {total} episodes were played before; their results are in {directory}.")
    if not remaining:
        return
    columns = (
        SpinnerColumn(),
        BarColumn(),
        MofNCompleteColumn(),
        TimeRemainingColumn(),
        TextColumn("{task.description}"),
    )
    with Progress(*columns, console=console, speed_estimate_period=600.0) as progress:
        bar = progress.add_task("starting (the first time on a machine, compiling)", total=total)
        progress.update(bar, completed=total - remaining)
        tally = _Tally(evaluation)

        def advance(agent: str, result: EpisodeResult) -> None:
            progress.update(bar, advance=1, description=tally.after(agent, result))
            if not console.is_terminal:  # a log has no bar to watch
                done = f"{total - len(evaluation.remaining)}/{total}"
                console.print(
                    f"{done} {agent}, {result.episode}: {result.failure or 'success'}", markup=False, soft_wrap=True
                )

        try:
            evaluation.play(worker_count, advance)
        except KeyboardInterrupt:
            kept = total - len(evaluation.remaining)
            progress.update(bar, description="stopped")
            console.print(f"Stopped: {kept} of {total} results are kept in {directory}. The same command goes on.")
            raise


class _Tally:
    """Overall successes so far, as the progress bar's words."""

    def __init__(self, evaluation: Evaluation) -> None:
        self._played: Counter[str] = Counter()
        self._succeeded: Counter[str] = Counter()
        for agent in evaluation.run.agents:
            for result in evaluation.store.results.get(agent, {}).values():
                self.after(agent, result)

    def after(self, agent: str, result: EpisodeResult) -> str:
        """Count a result and return the words."""
        self._played[agent] += 1
        self._succeeded[agent] += result.measures.overall_success
        return "succeeded: " + ", ".join(f"{name} {self._succeeded[name]}/{n}" for name, n in self._played.items())


def _rows(evaluation: Evaluation, breakdown: bool) -> dict[str, Summary]:
    """Return the table's rows: each agent's, and by kind of object category where that is asked for."""
    if not breakdown:
        return evaluation.summaries()
    rows = {}
    for agent, results in evaluation.store.results.items():
        rows[agent] = summarize(list(results.values()))
        for heading, unseen in (("seen categories", False), ("unseen categories", True)):
            some = [result for result in results.values() if result.unseen is unseen]
            if some:
                rows[f"{agent}, {heading}"] = summarize(some)
    return rows


def _caption(evaluation: Evaluation) -> str:
    run = evaluation.run
    return (
        f"Percent, steps: mean over 95 % interval. Split {evaluation.split.name}, perception {run.perception}, "
        f"camera {run.camera}, {len(evaluation.attempts) // len(run.agents)} episodes, uniteam {uniteam.__version__}."
    )


def _report(evaluation: Evaluation, console: Console) -> None:
    """Say where the results are, and what went wrong."""
    store = evaluation.store
    results = [result for agent in store.results.values() for result in agent.values()]
    crashed = sum(result.crashed for result in results)
    if crashed:
        console.print(f"[red]Crashed and counted as failures: {crashed}.[/] Each result's 'traceback' says where.")
    memory = max((result.peak_memory for result in results), default=0.0)
    console.print(f"Results, configuration and summary: {store.directory} (a worker used at most {memory:.0f} MB).")
