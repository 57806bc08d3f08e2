"""Two agents on the same episodes: what either comes to, the paired difference, and whether it is shown."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.results.intervals import Estimate, estimate_mean, estimate_proportion
from uniteam.evaluation.results.result import EpisodeResult, measures_to_data
from uniteam.evaluation.results.summary import MEANS
from uniteam.evaluation.statistics.homes import FEWEST_HOMES, error_by_home, interval_by_home
from uniteam.evaluation.statistics.paired_proportions import bonett_price
from uniteam.evaluation.statistics.power import smallest_mean_difference, smallest_rate_difference
from uniteam.evaluation.statistics.significance import LEVEL, holm, mcnemar, sign_flip

RATES = (
    "find_object_phase_success",
    "pick_object_phase_success",
    "find_recep_phase_success",
    "place_success",
    "overall_success",
)
"""Compared by McNemar's exact test."""

COMPARED = (*RATES, "partial_success", "num_steps")


@dataclass(frozen=True)
class MeasureComparison:
    """One measure of two agents on the same episodes.

    Attributes:
        first, second: the agents' own figures, with Wilson's interval for a rate and Student's for a mean.
        difference: of the second less the first, with its interval over homes like these.
        only_first, only_second: how many episodes the one succeeded at and the other not, or was better by.
        p: of no difference, by McNemar's exact test for a rate and by flipping the signs of homes for a mean.
        p_corrected: `p` after Holm's correction for all comparisons that were made; the same where there is one.
        smallest: the smallest difference that this many episodes show with a power of .8; None where they show none.
    """

    first: Estimate
    second: Estimate
    difference: Estimate
    only_first: int
    only_second: int
    p: float
    p_corrected: float
    smallest: float | None

    @property
    def is_shown(self) -> bool:
        """Whether the corrected p is below .05 and the interval leaves 0 out: each may err where the other does not."""
        return self.p_corrected < LEVEL and not self.difference.low <= 0.0 <= self.difference.high


@dataclass(frozen=True)
class Comparison:
    """Two agents on the same episodes.

    Attributes:
        first, second: the agents' labels.
        episodes, homes: how many it is from.
        measures: by the challenge's name of a measure.
    """

    first: str
    second: str
    episodes: int
    homes: int
    measures: Mapping[str, MeasureComparison]


def compare(first: str, second: str, pairs: Sequence[tuple[EpisodeResult, EpisodeResult]]) -> Comparison:
    """Return two agents' comparison over results of the same episodes, at least one; raises UnavailableError."""
    homes = [result.home for result, _ in pairs]
    rows = [(measures_to_data(a.measures), measures_to_data(b.measures)) for a, b in pairs]
    measures = {}
    for name in COMPARED:
        values = np.array([(float(a[name]), float(b[name])) for a, b in rows])
        measures[name] = _compared_rate(values, homes) if name in RATES else _compared_mean(values, homes, MEANS[name])
    return Comparison(first, second, len(pairs), len(set(homes)), measures)


def corrected(comparisons: Sequence[Comparison]) -> list[Comparison]:
    """Return the comparisons with Holm's correction of each measure's p for their number."""
    by_measure = {name: holm([c.measures[name].p for c in comparisons]) for name in COMPARED}
    return [
        replace(c, measures={name: replace(m, p_corrected=by_measure[name][k]) for name, m in c.measures.items()})
        for k, c in enumerate(comparisons)
    ]


def _compared_rate(values: NDArray[np.float64], homes: Sequence[str]) -> MeasureComparison:
    """Compare successes, (n, 2) of 0 and 1.

    The interval is the hull of two: Bonett and Price's, which few differing episodes do not mislead, and the
    bootstrap's, which homes whose episodes go alike do not. In the same way the smallest difference is the larger of
    what the test and what the error over homes allow.
    """
    count = len(homes)
    only_first, only_second = _better(values)
    differences = values[:, 1] - values[:, 0]
    by_pairs = bonett_price(only_first, only_second, count)
    by_homes = interval_by_home(differences, homes, (-1.0, 1.0))
    p = mcnemar(only_first, only_second)
    by_test = smallest_rate_difference(count, (only_first + only_second) / count)
    by_error = _smallest_mean(differences, homes)
    return MeasureComparison(
        estimate_proportion(round(values[:, 0].sum()), count),
        estimate_proportion(round(values[:, 1].sum()), count),
        Estimate(float(differences.mean()), min(by_pairs[0], by_homes[0]), max(by_pairs[1], by_homes[1])),
        only_first,
        only_second,
        p,
        p,
        None if by_test is None or by_error is None else max(by_test, by_error),
    )


def _compared_mean(values: NDArray[np.float64], homes: Sequence[str], bounds: tuple[float, float]) -> MeasureComparison:
    """Compare numbers, (n, 2)."""
    differences = values[:, 1] - values[:, 0]
    widest = bounds[1] - bounds[0]
    p = sign_flip(differences, homes)
    return MeasureComparison(
        estimate_mean(values[:, 0].tolist(), bounds),
        estimate_mean(values[:, 1].tolist(), bounds),
        Estimate(float(differences.mean()), *interval_by_home(differences, homes, (-widest, widest))),
        *_better(values),
        p,
        p,
        _smallest_mean(differences, homes) if differences.any() else None,
    )


def _better(values: NDArray[np.float64]) -> tuple[int, int]:
    return int(np.sum(values[:, 0] > values[:, 1])), int(np.sum(values[:, 1] > values[:, 0]))


def _smallest_mean(differences: NDArray[np.float64], homes: Sequence[str]) -> float | None:
    """Return the smallest difference that the error over homes allows; None where those are too few."""
    count = len(set(homes))
    return smallest_mean_difference(error_by_home(differences, homes), count) if count >= FEWEST_HOMES else None
