"""Print the figures that the README shows, from the episodes in `results/`.

    python tools/figures_of_results.py results/val-truth-half-challenge [--but-homes NAME ...]

First each agent on all that it has played, by style and by what is asked for, then all agents on the episodes that
every one of them has played. `--but-homes` leaves homes out, as those that were looked at while an agent was made.
"""

import argparse
from collections.abc import Iterable, Sequence
from pathlib import Path

from uniteam.evaluation.results.intervals import Estimate
from uniteam.evaluation.results.result import EpisodeResult, result_from_line
from uniteam.evaluation.results.summary import summarize

PERCENTAGES = (
    "find_object_phase_success", "pick_object_phase_success", "find_recep_phase_success", "overall_success",
    "partial_success",
)  # fmt: skip
LIVED_IN = "lived_in"
"""Stands in the names of homes of that style."""


def row(what: str, results: Sequence[EpisodeResult]) -> str:
    """Return a row of a table: percentages and steps, each with its interval."""
    estimates = summarize(results).estimates
    cells = [_cell(estimates[name], 100.0, 1) for name in PERCENTAGES]
    return " | ".join([what, str(len(results)), *cells, _cell(estimates["num_steps"], 1.0, 0)])


def _cell(estimate: Estimate, scale: float, digits: int) -> str:
    mean, low, high = (scale * v for v in (estimate.mean, estimate.low, estimate.high))
    return f"{mean:,.{digits}f} ({low:,.0f}–{high:,.0f})"


def groups(results: Iterable[EpisodeResult]) -> dict[str, list[EpisodeResult]]:
    """Return results by style of the home and by whether the category is unseen, and all of them."""
    found = list(results)
    return {
        "all": found,
        "tidy": [r for r in found if LIVED_IN not in r.home],
        "lived in": [r for r in found if LIVED_IN in r.home],
        "seen": [r for r in found if not r.unseen],
        "unseen": [r for r in found if r.unseen],
    }


def main() -> None:
    """Print the figures of the folder named on the command line."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--but-homes", nargs="*", default=(), metavar="NAME")
    arguments = parser.parse_args()
    played: dict[str, dict[str, EpisodeResult]] = {}
    for line in (arguments.folder / "results.jsonl").read_text().splitlines():
        agent, result = result_from_line(line)
        if result.home not in arguments.but_homes:
            played.setdefault(agent, {})[result.episode] = result
    for agent, results in played.items():
        for what, part in groups(results.values()).items():
            if part:
                print(row(f"{agent}, {what}", part))
    shared = sorted(set.intersection(*(set(results) for results in played.values())))
    lived_in = sum(LIVED_IN in episode for episode in shared)
    print(f"\non the {len(shared)} episodes that all have played, {lived_in} of them lived in:")
    for agent, results in played.items():
        print(row(agent, [results[episode] for episode in shared]))


if __name__ == "__main__":
    main()
