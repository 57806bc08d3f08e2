"""What replacing one module by the truth heals: paired over the episodes that both agents have played."""

from collections.abc import Sequence
from dataclasses import dataclass

from rich.table import Table

from uniteam.evaluation.analysis.comparison import Comparison, MeasureComparison, compare, corrected
from uniteam.evaluation.analysis.comparison_table import SHOWN, p_words
from uniteam.evaluation.analysis.swap_plan import Swap
from uniteam.evaluation.results.reading import Results

OVERALL = "overall_success"

WORDS = (
    "Healed: failures of the agent as it is that are overall successes with the module replaced; broken: the other way "
    f"round. Percentage points over 95 % intervals. {SHOWN}: shown (p below .05, corrected for the number of swaps by "
    "Holm, and 0 outside the interval). A gain is an upper bound of what a better module is worth to this agent."
)


@dataclass(frozen=True)
class SwapEffect:
    """A swap, and the comparison of its two agents: the second has the module replaced."""

    swap: Swap
    comparison: Comparison

    @property
    def overall(self) -> MeasureComparison:
        """Of overall success."""
        return self.comparison.measures[OVERALL]

    @property
    def failures(self) -> int:
        """How many of the episodes the agent as it is failed at."""
        return round(self.comparison.episodes * (1.0 - self.overall.first.mean))


def measure_swaps(swaps: Sequence[Swap], results: Results) -> list[SwapEffect]:
    """Return the effects of the swaps of which both agents have played an episode, p corrected for their number.

    Raises:
        UnavailableError: SciPy is not installed.
    """
    found = []
    for swap in swaps:
        first, second = results.get(swap.as_it_is, {}), results.get(swap.swapped, {})
        pairs = [(first[episode], second[episode]) for episode in sorted(set(first) & set(second))]
        if pairs:
            found.append((swap, compare(swap.as_it_is, swap.swapped, pairs)))
    comparisons = corrected([comparison for _, comparison in found])
    return [SwapEffect(swap, comparison) for (swap, _), comparison in zip(found, comparisons, strict=True)]


def swap_table(effects: Sequence[SwapEffect]) -> Table:
    """Return the table of the effects on overall success."""
    table = Table(caption=WORDS, caption_justify="left", pad_edge=False)
    table.add_column("module", overflow="fold")
    for heading in ("episodes", "failed", "healed", "broken", "gain", "p"):
        table.add_column(heading, justify="right", no_wrap=True)
    for effect in effects:
        table.add_row(f"[bold]{effect.swap.module}[/]\n[dim]{effect.swap.as_it_is}[/]", *_cells(effect))
    return table


def _cells(effect: SwapEffect) -> tuple[str, ...]:
    overall = effect.overall
    low, mean, high = (100.0 * v for v in (overall.difference.low, overall.difference.mean, overall.difference.high))
    mark = SHOWN if overall.is_shown else ""
    return (
        str(effect.comparison.episodes),
        str(effect.failures),
        str(overall.only_second),
        str(overall.only_first),
        f"[bold]{mean:+.1f}{mark}[/]\n[dim]{low:+.0f} to {high:+.0f}[/]",
        p_words(overall.p_corrected),
    )
