"""Depth as LeRobot's films of depth hold it: 4,096 levels, finer near than far.

A level l is exp(a + l (b - a) / 4095) - shift metres, with a and b so that the first is `NEAREST` and the last
`FARTHEST` (lerobot 0.6, `lerobot.datasets.depth_utils`). What is nearer or farther is cut, so where nothing returned
is `NEAREST` too.
"""

import math

import numpy as np
from numpy.typing import NDArray

from uniteam.stretch import DEPTH_RANGE

LEVELS = 1 << 12
NEAREST, FARTHEST = 0.01, DEPTH_RANGE
"""m."""
SHIFT = 3.5
"""m; the larger, the more even the levels."""

_LOW, _HIGH = math.log(NEAREST + SHIFT), math.log(FARTHEST + SHIFT)


def depth_levels(depth: NDArray[np.float32]) -> NDArray[np.uint16]:
    """Return the level of each pixel of an (H, W) image of depth (m)."""
    shares = (np.log(depth + np.float32(SHIFT)) - _LOW) / (_HIGH - _LOW)
    return np.clip(np.rint(shares * (LEVELS - 1)), 0, LEVELS - 1).astype(np.uint16)


def level_distances() -> NDArray[np.float64]:
    """Return the distance (m) that each level stands for, (4096,)."""
    distances: NDArray[np.float64] = np.exp(_LOW + np.arange(LEVELS) * (_HIGH - _LOW) / (LEVELS - 1)) - SHIFT
    return distances
