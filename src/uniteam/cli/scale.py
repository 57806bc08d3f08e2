"""`uniteam scale`: what a run of many episodes would take."""

from collections.abc import Sequence
from typing import Annotated

import tyro
from rich.filesize import decimal
from rich.table import Table

from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.evaluation.analysis.contestants import contestants_named
from uniteam.evaluation.analysis.scale import Taken, taken_by


def scale(
    runs: Annotated[tuple[str, ...], tyro.conf.Positional, tyro.conf.arg(metavar="RUN[:AGENT]")] = (),
    episodes: Annotated[tuple[int, ...], tyro.conf.arg(metavar="N")] = (1_000, 100_000),
    workers: Annotated[tuple[int, ...], tyro.conf.arg(metavar="W")] = (2, 64, 1_000),
) -> None:
    """Say what a run of many episodes would take, from the seconds, the memory and the files of one that was played.

    The hours are the mean seconds of an episode times their number over the workers, and at least the time of the
    slowest home, which one worker plays. The time to begin, which 'uniteam bench' is about, is not in them, and another
    machine has other seconds.

    Args:
        runs: Folders of runs, for all agents in them, or FOLDER:AGENT for one.
        episodes: How many episodes, one row each.
        workers: How many workers, one column each.
    """
    if min((*episodes, *workers), default=1) < 1:
        raise InvalidInputError("--episodes and --workers must be at least 1")
    taken = [taken_by(contestant) for contestant in contestants_named(runs)]
    if not taken:
        raise InvalidInputError("name the folder of a run, such as 'uniteam scale runs/val-truth-half-challenge'")
    console = make_console()
    for each in taken:
        console.print(_told(each), soft_wrap=True)
    console.print(_table(taken, episodes, workers))


def _told(taken: Taken) -> str:
    recorded = f", a recording {decimal(int(taken.recording))}" if taken.recording else ""
    words = (
        f"{taken.label}: {taken.episodes} episodes of {taken.seconds:.1f} s on average, the slowest "
        f"{taken.slowest:.0f} s, the slowest home {taken.slowest_home:.0f} s; at most {taken.memory:.0f} MB; "
        f"a line {decimal(int(taken.line))}{recorded}."
    )
    return shown(words)


def _table(taken: Sequence[Taken], episodes: Sequence[int], workers: Sequence[int]) -> Table:
    table = Table("agent", "episodes", "hours of a core", *(f"hours, {count:,} workers" for count in workers), "lines")
    for each in taken:
        for count in episodes:
            hours = [f"{each.hours(count, some):,.2f}" for some in workers]
            alone = f"{count * each.seconds / 3600.0:,.1f}"
            table.add_row(shown(each.label), f"{count:,}", alone, *hours, decimal(int(count * each.line)))
    return table
