"""The smallest difference that can be shown, against a closed form and against simulated episodes."""

import math

import numpy as np
import pytest

from uniteam.evaluation.statistics.paired_proportions import bonett_price
from uniteam.evaluation.statistics.power import mcnemar_power, smallest_mean_difference, smallest_rate_difference
from uniteam.evaluation.statistics.significance import mcnemar


def pairs_needed(differing: float, difference: float) -> float:
    """Return how many pairs Connor's formula asks for (Biometrics 43, 1987), for a level of .05 and a power of .8."""
    spread = 1.959964 * math.sqrt(differing) + 0.841621 * math.sqrt(differing - difference**2)
    return (spread / difference) ** 2


@pytest.mark.parametrize(("pairs", "differing"), [(200, 0.2), (400, 0.1), (1000, 0.3), (1000, 0.05)])
def test_it_is_near_connors_closed_form(pairs: int, differing: float) -> None:
    smallest = smallest_rate_difference(pairs, differing)
    assert smallest is not None
    assert pairs_needed(differing, smallest) == pytest.approx(pairs, rel=0.15)
    assert pairs_needed(differing, smallest) < pairs  # the exact test asks for more than the closed form says


@pytest.mark.parametrize(("pairs", "differing"), [(60, 0.3), (200, 0.15)])
def test_four_of_five_simulated_studies_show_a_difference_of_that_size(pairs: int, differing: float) -> None:
    smallest = smallest_rate_difference(pairs, differing)
    assert smallest is not None
    chances = [(differing - smallest) / 2, (differing + smallest) / 2, 1 - differing]
    drawn = np.random.default_rng(9).multinomial(pairs, chances, 1500)
    shown = np.mean([mcnemar(int(a), int(b)) < 0.05 and b > a for a, b, _ in drawn])
    assert shown == pytest.approx(0.8, abs=0.03)


def test_where_no_pair_differs_a_difference_must_be_all_one_way() -> None:
    """Six pairs that differ are significant: of ten episodes .8 of the studies have as many with a share of .67."""
    smallest = smallest_rate_difference(10, 0.0)
    assert smallest is not None
    assert sum(math.comb(10, k) * smallest**k * (1 - smallest) ** (10 - k) for k in range(6, 11)) == pytest.approx(0.8)


def test_five_episodes_show_nothing() -> None:
    assert smallest_rate_difference(5, 0.4) is None
    assert mcnemar_power(5, 1.0, 1.0) == 0.0


def test_more_episodes_show_smaller_differences() -> None:
    found = [smallest_rate_difference(n, 0.2) or 1.0 for n in (20, 50, 100, 400, 1000)]
    assert found == sorted(found, reverse=True)
    assert found[-1] < 0.05 < found[2]


def test_a_mean_needs_students_two_quantiles_of_its_error() -> None:
    """t(.975, 9) + t(.8, 9) of the printed tables."""
    assert smallest_mean_difference(2.0, 10) == pytest.approx(2.0 * (2.2622 + 0.8834), abs=1e-3)


def test_the_interval_of_many_paired_differences_is_that_of_their_mean() -> None:
    differences = np.repeat([-1.0, 1.0, 0.0], [900, 1400, 7700])
    half = 1.959964 * differences.std(ddof=1) / math.sqrt(10_000)
    assert bonett_price(900, 1400, 10_000) == pytest.approx((0.05 - half, 0.05 + half), abs=1e-4)


@pytest.mark.parametrize(("pairs", "chances"), [(10, (0.05, 0.05)), (30, (0.02, 0.1)), (200, (0.01, 0.01))])
def test_the_interval_of_a_paired_difference_covers_the_truth(pairs: int, chances: tuple[float, float]) -> None:
    drawn = np.random.default_rng(12).multinomial(pairs, [*chances, 1 - sum(chances)], 2000)
    bounds = np.array([bonett_price(int(a), int(b), pairs) for a, b, _ in drawn])
    truth = chances[1] - chances[0]
    assert np.mean((bounds[:, 0] <= truth) & (truth <= bounds[:, 1])) >= 0.95
