"""The challenge's table, with what its figures are from."""

from collections.abc import Mapping

from rich.table import Table

from uniteam.evaluation.results.intervals import Estimate
from uniteam.evaluation.results.summary import Summary

PERCENTAGES = {
    "FindObj": "find_object_phase_success",
    "Pick": "pick_object_phase_success",
    "FindRec": "find_recep_phase_success",
    "Overall": "overall_success",
    "Partial": "partial_success",
}
"""The table's headings and the measures below them, in percent."""


def challenge_table(summaries: Mapping[str, Summary], caption: str) -> Table:
    """Return the table: a row an agent, each figure over its 95 % interval; `caption` says what it is from."""
    table = Table(caption=caption, caption_justify="left", pad_edge=False)
    table.add_column("agent", overflow="fold")
    for heading in PERCENTAGES:
        table.add_column(heading, justify="right", no_wrap=True)
    table.add_column("Steps", justify="right", no_wrap=True)
    table.add_column("episodes", justify="right", no_wrap=True)
    for agent, summary in summaries.items():
        cells = [_cell(summary.estimates[name], 100.0) for name in PERCENTAGES.values()]
        crashed = f"\n[red]{summary.crash_count} crashed[/]" if summary.crash_count else ""
        steps = _cell(summary.estimates["num_steps"], 1.0)
        table.add_row(f"[bold]{agent}[/]", *cells, steps, f"{summary.episode_count}{crashed}")
    return table


def _cell(estimate: Estimate, scale: float) -> str:
    low, high = estimate.low * scale, estimate.high * scale
    return f"[bold]{estimate.mean * scale:.1f}[/]\n[dim]{low:.0f}–{high:.0f}[/]"
