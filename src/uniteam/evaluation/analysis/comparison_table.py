"""A comparison as a table, every figure over its 95 % interval."""

from collections.abc import Callable

from rich.table import Table

from uniteam.evaluation.analysis.comparison import RATES, Comparison, MeasureComparison
from uniteam.evaluation.results.intervals import Estimate

HEADINGS = {
    "find_object_phase_success": "FindObj",
    "pick_object_phase_success": "Pick",
    "find_recep_phase_success": "FindRec",
    "place_success": "Place",
    "overall_success": "Overall",
    "partial_success": "Partial",
    "num_steps": "Steps",
}
"""The table's words for the challenge's measures."""

SHOWN = "*"
"""Marks a difference that is shown."""


def comparison_table(comparison: Comparison, caption: str, shown: Callable[[str], str]) -> Table:
    """Return the table of one comparison.

    Args:
        comparison: of two agents.
        caption: what the figures are from.
        shown: makes an agent's label fit to be shown, whatever it contains.
    """
    first, second = shown(comparison.first), shown(comparison.second)
    title = f"A: {first}\nB: {second}\n{counted(comparison)}"
    table = Table(title=title, title_justify="left", caption=caption, caption_justify="left", pad_edge=False)
    table.add_column("measure", no_wrap=True)
    for heading in ("A", "B", "B - A", "only A\nonly B", "p", "least\nto show"):
        table.add_column(heading, justify="right", no_wrap=True)
    for name, measure in comparison.measures.items():
        table.add_row(f"[bold]{HEADINGS[name]}[/]", *_cells(measure, scale_of(name)))
    return table


def counted(comparison: Comparison) -> str:
    """Return how many episodes and homes a comparison is from, in words."""
    episodes, homes = comparison.episodes, comparison.homes
    return f"{episodes} episode{'s'[: episodes != 1]} in {homes} home{'s'[: homes != 1]}"


def scale_of(measure: str) -> float:
    """Return by what a measure is multiplied to be shown: percent, but for numbers of steps."""
    return 1.0 if measure == "num_steps" else 100.0


def is_rate(measure: str) -> bool:
    """Return whether a measure is true or false in an episode."""
    return measure in RATES


def p_words(p: float) -> str:
    """Return a p value as tables have it."""
    return "<.001" if p < 0.001 else f"{p:.3f}".removeprefix("0")


def _cells(measure: MeasureComparison, scale: float) -> tuple[str, ...]:
    mark = SHOWN if measure.is_shown else ""
    return (
        _figure(measure.first, scale, ""),
        _figure(measure.second, scale, ""),
        _figure(measure.difference, scale, "+") + mark,
        f"{measure.only_first}\n{measure.only_second}",
        p_words(measure.p_corrected),
        "none" if measure.smallest is None else f"{measure.smallest * scale:.1f}",
    )


def _figure(estimate: Estimate, scale: float, sign: str) -> str:
    mean, low, high = (value * scale for value in (estimate.mean, estimate.low, estimate.high))
    digits = 1 if scale > 1.0 else 0
    between = "–" if not sign else " to "
    return f"[bold]{mean:{sign},.{digits}f}[/]\n[dim]{low:{sign},.0f}{between}{high:{sign},.0f}[/]"
