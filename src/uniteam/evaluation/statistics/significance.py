"""Tests of paired differences: McNemar's, one that keeps homes together, and Holm's correction for several."""

from collections.abc import Sequence
from itertools import product

import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.statistics.homes import SEED, sums_by_home
from uniteam.evaluation.statistics.library import distributions

LEVEL = 0.05
"""A difference whose p is below is said to be shown."""

MOST_ENUMERATED = 14
"""Homes that differ up to which all 2^14 signs are gone through; beyond, `DRAWS` of them are drawn."""

DRAWS = 20_000

_TIE = 1e-9


def mcnemar(only_first: int, only_second: int) -> float:
    """Return the two-sided p of McNemar's exact test (McNemar 1947), conditional on the pairs that differ.

    Args:
        only_first: how many pairs only the first of two succeeded at.
        only_second: how many only the second did.
    """
    differing = only_first + only_second
    if differing == 0:
        return 1.0
    return float(distributions().binomtest(only_first, differing, 0.5).pvalue)


def sign_flip(differences: NDArray[np.float64], homes: Sequence[str]) -> float:
    """Return the two-sided p of a randomisation test that flips the signs of whole homes.

    Were the two agents alike, a home's differences would as soon have had the other sign. With one episode a home and
    differences of -1, 0 and 1 this is McNemar's exact test.

    Args:
        differences: (n,) one of an episode.
        homes: n names; the differences of one home keep together.
    """
    sums, _ = sums_by_home(differences, homes)
    sums = sums[sums != 0.0]
    observed = abs(sums.sum())
    if not sums.size or observed == 0.0:
        return 1.0
    if sums.size <= MOST_ENUMERATED:
        signs = np.array(list(product((-1.0, 1.0), repeat=sums.size)))
        return float(np.mean(np.abs(signs @ sums) >= observed - _TIE))
    signs = np.random.default_rng(SEED).choice((-1.0, 1.0), (DRAWS, sums.size))
    return float((1 + np.sum(np.abs(signs @ sums) >= observed - _TIE)) / (1 + DRAWS))


def holm(p_values: Sequence[float]) -> list[float]:
    """Return the p values as Holm (1979) corrects them for being several, in their order."""
    adjusted, largest = [1.0] * len(p_values), 0.0
    for place, index in enumerate(sorted(range(len(p_values)), key=lambda k: p_values[k])):
        largest = max(largest, min((len(p_values) - place) * p_values[index], 1.0))
        adjusted[index] = largest
    return adjusted
