"""`uniteam compare`: agents on the episodes that all have played."""

from collections.abc import Sequence
from typing import Annotated

import tyro

from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.evaluation.analysis.comparison import Comparison, corrected
from uniteam.evaluation.analysis.comparison import compare as compared
from uniteam.evaluation.analysis.comparison_table import SHOWN, comparison_table
from uniteam.evaluation.analysis.contestants import Contestant, contestants_named, shared_episodes
from uniteam.evaluation.analysis.likeness import differences_of, software_differs
from uniteam.evaluation.results.run_folder import RunFolder


class UnlikeRunsError(InvalidInputError):
    """Runs that differ in more than their agents."""


def compare(
    runs: Annotated[tuple[str, ...], tyro.conf.Positional, tyro.conf.arg(metavar="RUN[:AGENT]")] = (),
    allow_unlike: Annotated[bool, tyro.conf.FlagCreatePairsOff] = False,
) -> None:
    """Compare agents with the first that is named, on the episodes that all of them have played.

    Rates have Wilson's interval. Differences are paired: McNemar's exact test for success and each phase, and for
    partial success and steps one that flips the signs of whole homes; the intervals of the differences are over homes
    like these. With more than two agents, p is corrected for the number of comparisons (Holm). docs/statistics.md
    says what each figure means.

    Args:
        runs: Folders of runs, for all agents in them, or FOLDER:AGENT for one; two agents at least.
        allow_unlike: Compare runs that differ in split, version, camera, perception or rules too; the table then says
            that the differences are not the agents' alone.
    """
    contestants = contestants_named(runs)
    if len(contestants) < 2:
        raise InvalidInputError(
            f"two agents are needed to compare, got {len(contestants)}; give a folder with two, or FOLDER:AGENT twice"
        )
    folders = list({contestant.run.directory: contestant.run for contestant in contestants}.values())
    unlike = differences_of(folders)
    if unlike and not allow_unlike:
        raise UnlikeRunsError(
            f"the runs differ in more than their agents ({'; '.join(unlike)}), so a difference would not be "
            "the agents' own; compare runs that agree in this, or give --allow-unlike to have it said in the table"
        )
    caption = _caption(contestants, folders, unlike)
    console = make_console()
    with console.status("comparing"):
        comparisons = _comparisons(contestants)
    for comparison in comparisons:
        console.print(comparison_table(comparison, shown(caption), shown))
        console.print()


def _comparisons(contestants: Sequence[Contestant]) -> list[Comparison]:
    episodes = shared_episodes(contestants)
    first, *others = contestants
    return corrected(
        [compared(first.label, o.label, [(first.results[e], o.results[e]) for e in episodes]) for o in others]
    )


def _caption(contestants: Sequence[Contestant], folders: Sequence[RunFolder], unlike: Sequence[str]) -> str:
    told = folders[0].configuration
    count = len(contestants) - 1
    sentences = [
        f"UNLIKE RUNS, so these differences are not the agents' alone. {'; '.join(unlike)}." if unlike else "",
        f"Percent, steps: mean over 95 % interval. {SHOWN}: shown (p below .05 and 0 outside the interval).",
        "Least to show: the smallest difference that so many episodes show with a power of .8.",
        f"p is corrected for {count} comparisons (Holm)." if count > 1 else "",
        "The runs were made with other versions of packages or on other processors."
        if software_differs(folders)
        else "",
        ""
        if unlike
        else f"Split {told.get('split')} (version {told.get('split_version')}), perception {told.get('perception')}, "
        f"camera {told.get('camera')}, grasp {told.get('grasp')}, uniteam {told.get('version')}.",
    ]
    return " ".join(filter(None, sentences))
