"""Where on a receptacle a thing can be put: placing points chosen from the points that are seen of it.

All points are (N, 3) in the base frame or any other with z up (m).
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.mind.manipulation.arm_clearance import Load
from uniteam.mind.skills.view import Points

SLAB_WIDTH = 0.2
"""Side of the square around a placing point that should be at its height (m)."""
SLAB_THICKNESS = 0.04
"""Heights this close together (m) are equal."""
SAMPLES = 50
"""How many points of a receptacle are weighed."""


@dataclass(frozen=True)
class PlacingPoints:
    """Points on which a thing can be put.

    Attributes:
        points: (K, 3) m, K >= 0, in the frame of the points they were chosen from.
        worth: (K,); the higher, the better.
    """

    points: Points
    worth: NDArray[np.float64]

    def best_first(self) -> NDArray[np.intp]:
        """Return the indices in the order of falling worth; the first of equals comes first."""
        return np.argsort(-self.worth, kind="stable")


PointRule = Callable[[Points, Load, np.random.Generator], PlacingPoints]
"""From the points seen of a receptacle and what is to be put there to the points on which it can be."""


def densest_slab(points: Points, load: Load, generator: np.random.Generator) -> PlacingPoints:
    """Return 50 sampled points, each worth the number of points in the square of equal height around it.

    The rule of HomeRobot's heuristic placing (arXiv 2306.11565).
    """
    chosen = generator.choice(len(points), size=min(SAMPLES, len(points)), replace=False)
    samples = points[chosen]
    return PlacingPoints(samples, _slab_counts(points, samples).astype(np.float64))


def _slab_counts(points: Points, samples: Points) -> NDArray[np.int64]:
    """Return (K,): how many points lie in the slab around each sample."""
    half = np.array([SLAB_WIDTH, SLAB_WIDTH, SLAB_THICKNESS], dtype=np.float32) / 2
    return np.array([np.count_nonzero((np.abs(points - sample) < half).all(axis=1)) for sample in samples])
