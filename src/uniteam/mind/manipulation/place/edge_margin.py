"""Placing points that keep away from the edges of what they lie on (`edge_margin`)."""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.mind.manipulation.arm_clearance import Load
from uniteam.mind.manipulation.place.around_samples import cells_as_high
from uniteam.mind.manipulation.place.headroom import CELL, RISE
from uniteam.mind.skills.view import Points

EDGE_SAMPLES = 150
"""How many points to weigh: three times the baseline's, since what is sought is a place and no longer a crowd."""
_HALF = 16
"""Cells to either side of a point that are looked at: 0.4 m."""
BEYOND_MARGIN = 0.1
"""What a metre from the edge beyond the margin is worth: enough to decide between points that all have the margin."""


@dataclass(frozen=True)
class EdgeMargin:
    """Weighs points by their distance from where the surface ends.

    A surface ends where nothing of the receptacle is seen that is as high: at its edge, and at what lies on it. A back,
    a rim or a wall of the receptacle itself is no edge, so the middle of a seat, a basin or a bowl is safe.

    Attributes:
        margin: the distance (m) that is enough for what is not larger; points that have more are worth hardly more.
        least: points that have less (m) are not offered, unless no point has more.
    """

    margin: float = 0.12
    least: float = 0.04

    def __call__(self, points: Points, samples: Points, load: Load) -> NDArray[np.float64]:
        """Return the (K,) worth (m) of (K, 3) samples of (N, 3) points; -inf where they are not offered."""
        distance = edge_distances(points, samples)
        margin = max(self.margin, load.along_base)
        worth = np.minimum(distance, margin) + BEYOND_MARGIN * distance
        return np.where(distance >= min(self.least, distance.max(initial=0.0)), worth, -np.inf)


def edge_distances(points: Points, samples: Points) -> NDArray[np.float64]:
    """Return how far (m) each of (K, 3) samples is from where its surface ends, up to 0.4 m."""
    cells = cells_as_high(points, samples, _HALF, np.float32(CELL), np.float32(1.5 * RISE))
    return np.array([_inside(of_sample) for of_sample in cells], dtype=np.float64) * CELL


def _inside(cells: NDArray[np.uint8]) -> float:
    """Return how many cells the middle one is from the nearest empty one, gaps of one cell left out of account."""
    closed = cv2.morphologyEx(cells, cv2.MORPH_CLOSE, np.ones((3, 3), np.uint8))
    padded = cv2.copyMakeBorder(closed, 1, 1, 1, 1, cv2.BORDER_CONSTANT, value=0)
    return float(cv2.distanceTransform(padded, cv2.DIST_L2, 3)[_HALF + 1, _HALF + 1])
