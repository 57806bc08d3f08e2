"""Two agents on the same episodes: what is said, and how often it is true."""

from collections.abc import Sequence

import numpy as np
import pytest
from worlds.runs import result

from uniteam.evaluation.analysis.comparison import COMPARED, Comparison, compare, corrected
from uniteam.evaluation.results.intervals import estimate_proportion
from uniteam.evaluation.statistics.significance import mcnemar

OVERALL = "overall_success"


def compared(first: Sequence[bool], second: Sequence[bool], homes: int = 20) -> Comparison:
    pairs = [
        (result(k, a, f"h{k % homes}", 400), result(k, b, f"h{k % homes}", 300 + k % 7))
        for k, (a, b) in enumerate(zip(first, second, strict=True))
    ]
    return compare("first", "second", pairs)


def test_a_comparison_says_what_either_comes_to_and_how_many_only_one_succeeded_at() -> None:
    comparison = compared([True] * 30 + [False] * 30, [True] * 25 + [False] * 5 + [True] * 15 + [False] * 15)
    measure = comparison.measures[OVERALL]
    assert (comparison.episodes, comparison.homes) == (60, 20)
    assert set(comparison.measures) == set(COMPARED)
    assert measure.first == estimate_proportion(30, 60)
    assert measure.second == estimate_proportion(40, 60)
    assert (measure.only_first, measure.only_second) == (5, 15)
    assert measure.p == mcnemar(5, 15)
    assert measure.difference.mean == pytest.approx(10 / 60)
    found = comparison.measures["find_object_phase_success"]
    assert (found.p, found.only_first, found.only_second) == (1.0, 0, 0)
    steps = comparison.measures["num_steps"]
    assert steps.difference.mean == pytest.approx(np.mean([k % 7 for k in range(60)]) - 100)
    assert steps.is_shown and (steps.only_first, steps.only_second) == (60, 0)


def test_agents_that_never_differ_have_an_interval_all_the_same() -> None:
    alike = compared([True] * 40, [True] * 40)
    measure, partial = alike.measures[OVERALL], alike.measures["partial_success"]
    assert (measure.smallest or 0.0) > 0.1 and partial.smallest is None
    assert measure.difference.low < -0.03 and measure.difference.high > 0.03
    assert not measure.is_shown


def test_a_difference_that_one_home_makes_is_not_shown() -> None:
    """Twelve episodes differ, and McNemar's p is small, but they are all in one home of eight."""
    homes = [f"h{k // 12}" for k in range(96)]
    pairs = [(result(k, home != "h3", home), result(k, True, home)) for k, home in enumerate(homes)]
    measure = compare("first", "second", pairs).measures[OVERALL]
    assert measure.p < 0.001
    assert measure.difference.low <= 0.0 < measure.difference.high
    assert not measure.is_shown


def test_several_comparisons_are_corrected_measure_by_measure() -> None:
    strong = compared([False] * 40, [True] * 9 + [False] * 31)
    weak = compared([False] * 40, [True] * 6 + [False] * 34)
    both = corrected([weak, strong])
    assert both[0].measures[OVERALL].p_corrected == pytest.approx(mcnemar(0, 6))
    assert both[1].measures[OVERALL].p_corrected == pytest.approx(2.0 * mcnemar(0, 9))
    assert corrected([weak])[0] == weak


def coverage(homes: int, episodes: int, spread: float, trials: int = 100) -> tuple[float, float]:
    """Return how often the interval holds the true difference, and how often one that is none is said to be shown.

    Which of the two agents a home is kinder to differs from home to home by up to `spread`; over all it is neither.
    """
    generator, held, shown = np.random.default_rng(21), 0, 0
    for _ in range(trials):
        shift = np.tile(generator.uniform(-spread, spread, homes), episodes)
        first, second = (generator.random(shift.size) < 0.5 + sign * shift / 2 for sign in (-1, 1))
        measure = compared(first.tolist(), second.tolist(), homes).measures[OVERALL]
        held += measure.difference.low <= 0.0 <= measure.difference.high
        shown += measure.is_shown
    return held / trials, shown / trials


@pytest.mark.parametrize(("homes", "episodes", "spread"), [(10, 1, 0.0), (12, 5, 0.8)])
def test_the_interval_holds_the_truth_and_alike_agents_are_rarely_told_apart(
    homes: int, episodes: int, spread: float
) -> None:
    held, shown = coverage(homes, episodes, spread)
    assert held >= 0.93
    assert shown <= 0.05
