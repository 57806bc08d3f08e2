"""The smallest difference that so many pairs are likely to show."""

from functools import lru_cache

import numpy as np

from uniteam.evaluation.statistics.library import distributions
from uniteam.evaluation.statistics.significance import LEVEL

POWER = 0.8
"""How likely a difference of that size is to be shown."""

_HALVINGS = 20


def mcnemar_power(pairs: int, differing: float, difference: float) -> float:
    """Return how likely McNemar's exact test is to find a difference, and on the right side.

    Args:
        pairs: how many episodes both play.
        differing: the share of them that only one of the two succeeds at.
        difference: of the two rates; at most `differing`.
    """
    binomial = distributions().binom
    counts = np.arange(pairs + 1)
    rarest = binomial.ppf(LEVEL / 2.0, counts, 0.5)
    rarest -= binomial.cdf(rarest, counts, 0.5) > LEVEL / 2.0  # so many or fewer on the one side are significant
    found = binomial.sf(counts - rarest - 1.0, counts, (1.0 + difference / differing) / 2.0)
    return float(binomial.pmf(counts, pairs, differing) @ np.where(rarest >= 0.0, found, 0.0))


@lru_cache(maxsize=1024)
def smallest_rate_difference(pairs: int, differing: float) -> float | None:
    """Return the smallest difference of two rates that McNemar's test finds with a power of .8; None where none is.

    A difference cannot be larger than the share of pairs that differ: beyond the observed share, all of them are taken
    to differ the same way.

    Args:
        pairs: how many episodes both play.
        differing: the observed share of them that only one of the two succeeds at.
    """
    low, high = 0.0, 1.0
    if mcnemar_power(pairs, 1.0, 1.0) < POWER:
        return None
    for _ in range(_HALVINGS):
        middle = (low + high) / 2.0
        enough = mcnemar_power(pairs, max(differing, middle), middle) >= POWER
        low, high = (low, middle) if enough else (middle, high)
    return high


def smallest_mean_difference(error: float, homes: int) -> float:
    """Return the smallest difference of two means that is found with a power of .8.

    Args:
        error: standard error of the difference.
        homes: how many homes it is from, at least two; Student's t has one degree of freedom less.
    """
    student = distributions().t
    return float(student.ppf(1.0 - LEVEL / 2.0, homes - 1) + student.ppf(POWER, homes - 1)) * error
