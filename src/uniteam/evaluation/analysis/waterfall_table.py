"""Waterfalls as tables of a terminal: agents side by side, and a line an episode that failed."""

from collections.abc import Callable, Iterator, Sequence

from rich.table import Table

from uniteam.evaluation.analysis.explanation import Explanations
from uniteam.evaluation.analysis.waterfall import Stage, Waterfall, causes_in
from uniteam.evaluation.causes.cause import REPORT, Cause
from uniteam.evaluation.causes.diagnosis import PHASES
from uniteam.evaluation.results.intervals import estimate_proportion

NO_RECORDING = "no recording, so by the line of the result alone"


def waterfall_table(waterfalls: Sequence[Waterfall], caption: str, shown: Callable[[str], str]) -> Table:
    """Return the table of some agents' waterfalls; `shown` makes a label fit to be shown, whatever it contains."""
    table = Table(caption=caption, caption_justify="left", pad_edge=False)
    table.add_column("episodes", no_wrap=True)
    for waterfall in waterfalls:
        table.add_column(shown(waterfall.label), justify="right", overflow="fold")
    table.add_row("[bold]all[/]", *(f"[bold]{w.episodes}[/]" for w in waterfalls), end_section=True)
    for number, phase in enumerate(PHASES):
        stages = [waterfall.stages[number] for waterfall in waterfalls]
        causes = causes_in(waterfalls, phase)
        table.add_row(f"[bold]failed: {phase}[/]", *(_lost(stage) for stage in stages), end_section=not causes)
        for cause in causes:
            counts = (_count(stage, cause) for stage in stages)
            table.add_row(f"  {cause.value}{_mark(cause)}", *counts, end_section=cause is causes[-1])
    table.add_row("[bold]overall success[/]", *(_success(waterfall) for waterfall in waterfalls))
    return table


def failure_lines(explanations: Explanations, shown: Callable[[str], str]) -> Iterator[str]:
    """Yield three lines for each failed episode of an agent: what was asked, cause and evidence, and the recording."""
    for explained in explanations.episodes:
        found = explained.diagnosis
        if found is not None:
            yield f"{shown(explained.result.episode)}  [dim]{shown(explained.result.instruction)}[/]"
            yield f"  [bold]{found.cause.value}[/] ({found.phase}), {shown(found.evidence)}"
            yield f"  [dim]{shown(str(explained.recording or NO_RECORDING))}[/]"


def _lost(stage: Stage) -> str:
    return f"[red]-{stage.lost}[/]" if stage.lost else "[dim]0[/]"


def _count(stage: Stage, cause: Cause) -> str:
    return str(stage.causes[cause]) if cause in stage.causes else "[dim]0[/]"


def _mark(cause: Cause) -> str:
    return " (report)" if cause in REPORT else ""


def _success(waterfall: Waterfall) -> str:
    estimate = estimate_proportion(waterfall.successes, waterfall.episodes)
    mean, low, high = (100.0 * value for value in (estimate.mean, estimate.low, estimate.high))
    return f"[bold]{waterfall.successes}[/]\n{mean:.1f} %\n[dim]{low:.0f}–{high:.0f}[/]"
