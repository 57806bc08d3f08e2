"""The challenge's table, with what its figures are from."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from rich.console import Console
from rich.measure import Measurement
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

COLLISIONS = {"Arm": "robot_scene_colls", "Held": "obj_scene_colls", "Objects": "robot_obj_colls"}
"""Headings of the steps in which the arm touched the scene (which costs the success), the held object touched anything,
and the arm touched small objects; they are shown where there is room."""

STEPS = "Steps"
EPISODES = "episodes"

_ANY_WIDTH = 10_000


@dataclass(frozen=True)
class Row:
    """A row's figures, and how many episodes they should be from: where they are from fewer, the row says so."""

    summary: Summary
    episodes_asked: int


def challenge_table(rows: Mapping[str, Row], caption: str, width: int, shown: Callable[[str], str]) -> Table:
    """Return the table: each figure over its 95 % interval.

    Args:
        rows: by the agent's label.
        caption: what the figures are from.
        width: columns of the terminal; where an agent's name would be broken, the collisions are left out, and where it
            still would be, the measures are the rows.
        shown: makes an agent's label fit to be shown, whatever it contains.
    """
    cells = {shown(agent): _cells(row) for agent, row in rows.items()}
    tables = (_wide(cells, (*PERCENTAGES, *more, STEPS, EPISODES), caption) for more in (COLLISIONS, ()))
    return next((table for table in tables if _least_width(table) <= width), _narrow(cells, caption))


def _least_width(table: Table) -> int:
    """Return how many columns of a terminal a table needs so that no word of it is broken."""
    console = Console(width=_ANY_WIDTH)
    return Measurement.get(console, console.options, table).minimum


Cells = dict[str, tuple[str, str]]
"""By heading: a figure, and what stands below it."""


def _cells(row: Row) -> Cells:
    summary, asked = row.summary, row.episodes_asked
    cells = {heading: _cell(summary.estimates[name], 100.0) for heading, name in PERCENTAGES.items()}
    cells |= {heading: _cell(summary.estimates[name], 1.0) for heading, name in COLLISIONS.items()}
    cells[STEPS] = _cell(summary.estimates["num_steps"], 1.0)
    count = summary.episode_count
    crashed = f"[red]{summary.crash_count} crashed[/]" if summary.crash_count else ""
    cells[EPISODES] = (str(count) if count == asked else f"{count} of {asked}", crashed)
    return cells


def _cell(estimate: Estimate, scale: float) -> tuple[str, str]:
    low, high = estimate.low * scale, estimate.high * scale
    return f"[bold]{estimate.mean * scale:.1f}[/]", f"[dim]{low:.0f}–{high:.0f}[/]"


def _wide(rows: Mapping[str, Cells], headings: Iterable[str], caption: str) -> Table:
    table = Table(caption=caption, caption_justify="left", pad_edge=False)
    table.add_column("agent", overflow="fold")
    shown = tuple(headings)
    for heading in shown:
        table.add_column(heading, justify="right", no_wrap=True)
    for agent, row in rows.items():
        table.add_row(f"[bold]{agent}[/]", *("\n".join(filter(None, row[heading])) for heading in shown))
    return table


def _narrow(rows: Mapping[str, Cells], caption: str) -> Table:
    """Return a table of two columns: an agent's name stands above its measures."""
    table = Table(caption=caption, caption_justify="left", pad_edge=False)
    table.add_column("agent", overflow="fold")
    table.add_column("mean, interval", overflow="fold", justify="right")
    for agent, row in rows.items():
        table.add_row(f"[bold]{agent}[/]", "")
        for number, (heading, cell) in enumerate(row.items(), start=1):
            table.add_row(f" {heading}", " ".join(filter(None, cell)), end_section=number == len(row))
    return table
