"""Standings as they are written into a page."""

from collections.abc import Iterable, Sequence

from uniteam.evaluation.analysis.leaderboard import PARTS, Standing, Standings
from uniteam.evaluation.analysis.published import PUBLISHED, UNLIKE
from uniteam.evaluation.analysis.table import PERCENTAGES, STEPS
from uniteam.evaluation.results.intervals import Estimate

OVERALL = "overall_success"


def standings_markdown(standings: Iterable[Standings]) -> str:
    """Return, for each run, a table of the measures and one of overall success by part."""
    return "\n\n".join(_of_run(each) for each in standings)


def published_markdown() -> str:
    """Return the published rows, with a word that they are unlike."""
    head = ("system", "split, perception", *PERCENTAGES, STEPS, "printed in")
    rows = [
        (
            row.system,
            row.setting,
            *(_printed(v) for v in (row.find_object, row.pick, row.find_receptacle, row.overall, row.partial)),
            _printed(row.steps),
            row.source,
        )
        for row in PUBLISHED
    ]
    return f"{UNLIKE}\n\n{_table(head, rows)}"


def _of_run(standings: Standings) -> str:
    paragraphs = [f"{standings.told}; percent, mean over 95 % interval."]
    if standings.shared:
        count = standings.shared[0].summary.episode_count
        paragraphs += [f"On the {count} episodes that all of them have played:", _measures(standings.shared)]
        paragraphs.append("Each on all the episodes that it has played:")
    paragraphs += [_measures(standings.own), "Overall success by part of the episodes:", _parts(standings.own)]
    return "\n\n".join(paragraphs)


def _measures(standings: Sequence[Standing]) -> str:
    rows = []
    for standing in standings:
        estimates = standing.summary.estimates
        figures = (_figure(estimates[name], 100.0, 1) for name in PERCENTAGES.values())
        steps = _figure(estimates["num_steps"], 1.0, 0)
        rows.append((f"`{standing.agent}`", str(standing.summary.episode_count), *figures, steps))
    return _table(("agent", "episodes", *PERCENTAGES, STEPS), rows)


def _parts(standings: Sequence[Standing]) -> str:
    return _table(
        ("agent", *PARTS),
        [(f"`{standing.agent}`", *(_part(standing, part) for part in PARTS)) for standing in standings],
    )


def _part(standing: Standing, part: str) -> str:
    if part not in standing.parts:
        return "none"
    summary = standing.parts[part]
    return f"{_figure(summary.estimates[OVERALL], 100.0, 1)} of {summary.episode_count}"


def _figure(estimate: Estimate, scale: float, digits: int) -> str:
    mean, low, high = (scale * v for v in (estimate.mean, estimate.low, estimate.high))
    return f"{mean:,.{digits}f} ({low:,.0f}–{high:,.0f})"


def _printed(value: float | None) -> str:
    return "" if value is None else f"{value:,.1f}"


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    escaped = ([cell.replace("|", "\\|") for cell in cells] for cells in (head, ["---"] * len(head), *rows))
    lines = (" | ".join(cells) for cells in escaped)
    return "\n".join(f"| {line} |" for line in lines)
