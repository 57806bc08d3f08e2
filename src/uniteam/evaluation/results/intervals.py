"""95 % confidence intervals of proportions and of means."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import NormalDist, fmean, stdev

_Z = NormalDist().inv_cdf(0.975)


@dataclass(frozen=True)
class Estimate:
    """A mean and the bounds of its 95 % interval."""

    mean: float
    low: float
    high: float


def estimate_proportion(successes: int, trials: int) -> Estimate:
    """Return a proportion with Wilson's score interval (Wilson 1927), which holds for few trials and near 0 and 1."""
    if trials == 0:
        return Estimate(math.nan, 0.0, 1.0)
    share, weight = successes / trials, _Z * _Z / trials
    center = (share + weight / 2.0) / (1.0 + weight)
    half = _Z * math.sqrt(share * (1.0 - share) / trials + weight / (4.0 * trials)) / (1.0 + weight)
    low = 0.0 if successes == 0 else center - half
    high = 1.0 if successes == trials else center + half
    return Estimate(share, low, high)


def estimate_mean(values: Sequence[float], bounds: tuple[float, float]) -> Estimate:
    """Return a mean with Student's t interval, cut off at the bounds that no value can leave.

    A single value says nothing of the spread: its interval is the whole range.
    """
    if len(values) < 2:
        return Estimate(values[0] if values else math.nan, *bounds)
    mean = fmean(values)
    half = student_quantile(len(values) - 1) * stdev(values) / math.sqrt(len(values))
    return Estimate(mean, max(mean - half, bounds[0]), min(mean + half, bounds[1]))


def student_quantile(degrees_of_freedom: int) -> float:
    """Return the 97.5 % quantile of Student's t distribution.

    Exact for one and two degrees of freedom, else by the expansion in Abramowitz and Stegun 26.7.5 (error under 1 %).
    """
    if degrees_of_freedom == 1:
        return math.tan(math.pi * 0.475)
    if degrees_of_freedom == 2:
        return 0.95 * math.sqrt(2.0 / (1.0 - 0.95**2))
    z, n = _Z, float(degrees_of_freedom)
    return (
        z
        + (z**3 + z) / (4.0 * n)
        + (5.0 * z**5 + 16.0 * z**3 + 3.0 * z) / (96.0 * n**2)
        + (3.0 * z**7 + 19.0 * z**5 + 17.0 * z**3 - 15.0 * z) / (384.0 * n**3)
    )
