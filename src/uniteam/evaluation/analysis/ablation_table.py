"""The effects of an ablation as rows: for the terminal, and for a page of the docs."""

from collections.abc import Mapping, Sequence

from rich.table import Table

from uniteam.evaluation.analysis.ablation import MeasuredEffect
from uniteam.evaluation.analysis.ablation_plan import GROUPS
from uniteam.evaluation.analysis.comparison import MeasureComparison
from uniteam.evaluation.analysis.comparison_table import HEADINGS, SHOWN, p_words, scale_of

COLUMNS = ("improvement", "n", "without", "with", "worth", "only without, with", "p", "least to show")

PAGE_MEASURES = ("overall_success", "partial_success")
"""What the page has a table of: what counts, and what shows more, since it counts the phases."""

WORDS = (
    "An improvement's worth is the figure with it less the figure without it, on the same episodes: percentage points "
    f"over 95 % intervals. {SHOWN}: shown (p below .05, corrected within a table by Holm, and 0 outside the interval). "
    "Least to show: the smallest worth that so many episodes show with a power of .8."
)


ENOUGH = 0.05
"""A worth that a study should be large enough to show."""


def enough_words(effects: Sequence[MeasuredEffect], measure: str) -> str:
    """Return for how many of the effects there are episodes enough to show a worth of 5 points."""
    least = [effect.comparison.measures[measure].smallest for effect in effects]
    found = sum(value is not None and value <= ENOUGH for value in least)
    which = "all" if found == len(least) else f"{found or 'none'} of the {len(least)}"
    return f"There are episodes enough to show a worth of 5 points for {which}."


def ablation_tables(measured: Mapping[str, Sequence[MeasuredEffect]], measure: str) -> list[Table]:
    """Return a table for each question, of one measure."""
    tables = []
    for group, effects in measured.items():
        title, words = f"{HEADINGS[measure]}: {GROUPS[group]}", enough_words(effects, measure)
        table = Table(title=title, title_justify="left", caption=words, caption_justify="left", pad_edge=False)
        table.add_column(COLUMNS[0], no_wrap=True)
        for heading in ("w/o\nwith", "worth", "only w/o\nor with", "p", "least\nto show"):
            table.add_column(heading, justify="right", no_wrap=True)
        for effect in effects:
            name, n, without, with_, worth, only, p, least = _cells(effect, measure)
            mean, interval = worth.removesuffix(")").split(" (")
            figures = (f"{without}\n{with_}", f"[bold]{mean}[/]\n[dim]{interval}[/]", only.replace(", ", "\n"))
            table.add_row(f"[bold]{name}[/]\n[dim]{n} episodes[/]", *figures, p, least)
        tables.append(table)
    return tables


def ablation_markdown(measured: Mapping[str, Sequence[MeasuredEffect]]) -> str:
    """Return the tables of `PAGE_MEASURES` for a page, with a heading for each question."""
    parts = []
    for group, effects in measured.items():
        parts.append(f"### {GROUPS[group][0].upper()}{GROUPS[group][1:]}")
        for measure in PAGE_MEASURES:
            rows = [" | ".join(_cells(effect, measure)) for effect in effects]
            own = (f"{HEADINGS[measure]} {column}" for column in COLUMNS[2:5])
            head = " | ".join((*COLUMNS[:2], *own, *COLUMNS[5:]))
            parts.append("\n".join(f"| {row} |" for row in (head, " | ".join(["---"] * len(COLUMNS)), *rows)))
            parts.append(enough_words(effects, measure))
    return "\n\n".join(parts)


def _cells(effect: MeasuredEffect, measure: str) -> tuple[str, ...]:
    found: MeasureComparison = effect.comparison.measures[measure]
    scale = scale_of(measure)
    mean, low, high = (v * scale for v in (found.difference.mean, found.difference.low, found.difference.high))
    return (
        effect.effect.improvement,
        str(effect.comparison.episodes),
        f"{found.first.mean * scale:.1f}",
        f"{found.second.mean * scale:.1f}",
        f"{mean:+.1f}{SHOWN if found.is_shown else ''} ({low:+.0f} to {high:+.0f})",
        f"{found.only_first}, {found.only_second}",
        p_words(found.p_corrected),
        "none" if found.smallest is None else f"{found.smallest * scale:.1f}",
    )
