"""The interval of the difference of two proportions that are of the same episodes."""

import math
from statistics import NormalDist

_Z = NormalDist().inv_cdf(0.975)


def bonett_price(only_first: int, only_second: int, pairs: int) -> tuple[float, float]:
    """Return the 95 % interval of the second proportion less the first, as Bonett and Price (2012) have it.

    It adds one pair to each kind that differs, and so does not shrink to nothing where few or no pairs differ
    ("Adjusted Wald confidence interval for a difference of binomial proportions based on paired data", Journal of
    Educational and Behavioral Statistics 37).

    Args:
        only_first: how many pairs only the first of two succeeded at.
        only_second: how many only the second did.
        pairs: how many there are in all.
    """
    first, second = (only_first + 1) / (pairs + 2), (only_second + 1) / (pairs + 2)
    middle = second - first
    half = _Z * math.sqrt((first + second - middle * middle) / (pairs + 2))
    return max(middle - half, -1.0), min(middle + half, 1.0)
