"""Intervals over homes cover the truth as often as they say."""

import numpy as np
import pytest

from uniteam.evaluation.statistics.homes import error_by_home, interval_by_home, resampled_means, sums_by_home

ANY = (-10.0, 10.0)


def names(homes: int, episodes: int) -> list[str]:
    return [f"h{k // episodes:02d}" for k in range(homes * episodes)]


def covered(homes: int, episodes: int, spread: float, trials: int = 200) -> float:
    """Return how often the interval holds the true mean of 0 where homes have means of their own with that spread."""
    generator, hits = np.random.default_rng(5), 0
    for _ in range(trials):
        by_home = np.repeat(generator.normal(0.0, spread, homes), episodes)
        low, high = interval_by_home(by_home + generator.normal(0.0, 1.0, by_home.size), names(homes, episodes), ANY)
        hits += low <= 0.0 <= high
    return hits / trials


@pytest.mark.parametrize(("homes", "episodes", "spread"), [(10, 1, 0.0), (13, 5, 0.0), (13, 5, 2.0), (40, 5, 1.0)])
def test_the_interval_covers_the_truth_as_often_as_it_says(homes: int, episodes: int, spread: float) -> None:
    assert 0.91 <= covered(homes, episodes, spread) <= 0.985


def test_the_error_is_the_closed_form_where_homes_have_as_many_episodes_each() -> None:
    values = np.random.default_rng(2).normal(0.0, 1.0, 200)
    means = values.reshape(40, 5).mean(1)
    assert error_by_home(values, names(40, 5)) == pytest.approx(means.std(ddof=1) / np.sqrt(40), rel=0.03)


def test_the_interval_agrees_with_scipys_bootstrap_of_the_homes() -> None:
    from scipy.stats import bootstrap

    values = np.random.default_rng(4).normal(1.0, 1.0, 300)
    means = values.reshape(100, 3).mean(1)
    theirs = bootstrap(
        (means,), np.mean, n_resamples=10_000, method="percentile", rng=np.random.default_rng(1)
    ).confidence_interval
    assert interval_by_home(values, names(100, 3), ANY) == pytest.approx(tuple(theirs), abs=0.02)


def test_homes_with_many_episodes_weigh_as_many() -> None:
    values, homes = np.array([1.0, 1.0, 1.0, 0.0]), ["b", "b", "b", "a"]
    sums, counts = sums_by_home(values, homes)
    assert (sums.tolist(), counts.tolist()) == ([0.0, 3.0], [1.0, 3.0])
    assert set(np.round(resampled_means(values, homes), 6)) == {0.0, 0.75, 1.0}


def test_few_homes_say_nothing_of_others() -> None:
    assert interval_by_home(np.ones(50), names(5, 10), ANY) == ANY
    assert interval_by_home(np.ones(50), names(10, 5), ANY) == (1.0, 1.0)


def test_the_order_of_the_episodes_changes_nothing() -> None:
    values, homes = np.random.default_rng(6).normal(0.0, 1.0, 60), names(12, 5)
    turned = np.random.default_rng(7).permutation(60)
    other = interval_by_home(values[turned], [homes[k] for k in turned], ANY)
    assert interval_by_home(values, homes, ANY) == pytest.approx(other, abs=1e-12)
