"""The tests of paired differences against other implementations, closed forms, and data whose truth is known."""

import sys
from math import comb

import numpy as np
import pytest

from uniteam.errors import UnavailableError
from uniteam.evaluation.results.intervals import estimate_proportion
from uniteam.evaluation.statistics.significance import MOST_ENUMERATED, holm, mcnemar, sign_flip


@pytest.mark.parametrize(("only_first", "only_second"), [(0, 0), (0, 5), (5, 0), (1, 9), (12, 20), (7, 7), (30, 61)])
def test_mcnemars_p_is_that_of_statsmodels(only_first: int, only_second: int) -> None:
    tables = pytest.importorskip("statsmodels.stats.contingency_tables")
    theirs = tables.mcnemar([[40, only_first], [only_second, 11]], exact=True).pvalue
    assert mcnemar(only_first, only_second) == pytest.approx(theirs, abs=1e-12)


@pytest.mark.parametrize("differing", [1, 5, 6, 20])
def test_mcnemars_p_of_pairs_that_all_differ_one_way_is_a_coins(differing: int) -> None:
    assert mcnemar(0, differing) == pytest.approx(2.0 * 0.5**differing)
    tail = sum(comb(differing, k) for k in range(2)) * 0.5**differing
    assert mcnemar(1, differing - 1) == pytest.approx(min(2.0 * tail, 1.0))


def test_wilsons_interval_is_that_of_statsmodels() -> None:
    proportion = pytest.importorskip("statsmodels.stats.proportion")
    for successes, trials in ((0, 7), (3, 10), (58, 58), (177, 200)):
        estimate = estimate_proportion(successes, trials)
        theirs = proportion.proportion_confint(successes, trials, method="wilson")
        assert (estimate.low, estimate.high) == pytest.approx(theirs, abs=1e-9)


@pytest.mark.parametrize("p_values", [[0.04], [0.01, 0.02, 0.03], [0.5, 0.001, 0.02, 0.02, 1.0], [0.9, 0.8]])
def test_holms_correction_is_that_of_statsmodels(p_values: list[float]) -> None:
    multitest = pytest.importorskip("statsmodels.stats.multitest")
    assert holm(p_values) == pytest.approx(multitest.multipletests(p_values, method="holm")[1], abs=1e-12)


@pytest.mark.parametrize(("only_first", "only_second"), [(2, 9), (0, 6), (5, 5), (3, 4)])
def test_flipping_homes_of_one_episode_is_mcnemars_test(only_first: int, only_second: int) -> None:
    differences = np.array([-1.0] * only_first + [1.0] * only_second + [0.0] * 20)
    homes = [f"h{k}" for k in range(differences.size)]
    assert sign_flip(differences, homes) == pytest.approx(mcnemar(only_first, only_second), abs=1e-12)


def test_signs_that_are_drawn_agree_with_scipys_permutations() -> None:
    from scipy.stats import permutation_test

    differences = np.random.default_rng(3).normal(0.35, 1.0, 40)
    homes = [f"h{k}" for k in range(differences.size)]
    assert differences.size > MOST_ENUMERATED
    theirs = permutation_test(
        (differences,), np.sum, permutation_type="samples", n_resamples=20_000, rng=np.random.default_rng(8)
    ).pvalue
    assert sign_flip(differences, homes) == pytest.approx(theirs, abs=0.01)


def test_episodes_of_one_home_count_as_one_fact() -> None:
    """Five homes cannot show anything, however many episodes were played in them."""
    differences = np.ones(100)
    assert sign_flip(differences, [f"h{k % 5}" for k in range(100)]) == pytest.approx(2.0 / 2**5)
    assert sign_flip(differences, [f"h{k}" for k in range(100)]) < 0.001


def test_no_difference_has_no_significance() -> None:
    assert sign_flip(np.zeros(8), list("abcdefgh")) == 1.0
    assert sign_flip(np.array([1.0, -1.0]), ["a", "b"]) == 1.0


def test_alike_agents_are_told_apart_no_more_often_than_promised() -> None:
    """Homes in which episodes go alike, and no difference in truth: 5 % of the tests may be wrong, and not more."""
    generator = np.random.default_rng(11)
    homes = [f"h{k // 5}" for k in range(60)]
    wrong = 0
    for _ in range(300):
        by_home = np.repeat(generator.normal(0.0, 1.0, 12), 5)
        wrong += sign_flip(by_home + generator.normal(0.0, 1.0, 60), homes) < 0.05
    assert wrong / 300 < 0.05 + 2.0 * np.sqrt(0.05 * 0.95 / 300)


def test_without_scipy_the_answer_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "scipy", None)
    with pytest.raises(UnavailableError, match=r"pip install 'uniteam\[study\]'"):
        mcnemar(1, 2)
