"""Where on a receptacle a thing can be put: placing points chosen from the points that are seen of it.

All points are (N, 3) in the base frame or any other with z up (m).
"""

from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.mind.manipulation.view import Points

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


PointRule = Callable[[Points, np.random.Generator], PlacingPoints]
"""From the points seen of a receptacle to those on which a thing can be put."""


def densest_slab(points: Points, generator: np.random.Generator) -> PlacingPoints:
    """Return 50 sampled points, each worth the number of points in the square of equal height around it.

    The rule of HomeRobot's heuristic placing (arXiv 2306.11565).
    """
    chosen = generator.choice(len(points), size=min(SAMPLES, len(points)), replace=False)
    samples = points[chosen]
    return PlacingPoints(samples, _slab_counts(points, samples).astype(np.float64))


@dataclass(frozen=True)
class SafeFromEdges:
    """Sampled points of the middle of level surfaces: each keeps its distance from the surface's edges.

    Attributes:
        margin: the distance (m) that is asked for; where no point has it, the ones with the most are offered.
        cell: size of the grid on which edges are found (m).
        smallest_slab: seen points that a level square must hold.
    """

    margin: float = 0.12
    cell: float = 0.025
    smallest_slab: int = 12

    def __call__(self, points: Points, generator: np.random.Generator) -> PlacingPoints:
        """Return sampled points, worth their distance from the edge up to the margin and a little beyond it."""
        level = self._level_points(points)
        if len(level) == 0:
            return PlacingPoints(level, np.zeros(0))
        chosen = generator.choice(len(level), size=min(4 * SAMPLES, len(level)), replace=False)
        samples = level[chosen]
        distance = np.array([self._edge_distance(points, sample) for sample in samples])
        enough = distance >= min(self.margin, float(distance.max()))
        return PlacingPoints(samples[enough], np.minimum(distance[enough], 2.0 * self.margin))

    def _level_points(self, points: Points) -> Points:
        """Return the points whose cell shows nothing much above or below them: no walls, no fronts."""
        column = np.floor(points[:, :2] / self.cell).astype(np.int64)
        _, inverse = np.unique(column, axis=0, return_inverse=True)
        inverse = inverse.ravel()
        top = np.full(inverse.max() + 1, -np.inf, dtype=np.float32) if len(points) else np.zeros(0, dtype=np.float32)
        np.maximum.at(top, inverse, points[:, 2])
        return points[points[:, 2] >= top[inverse] - SLAB_THICKNESS / 2]

    def _edge_distance(self, points: Points, sample: NDArray[np.float32]) -> float:
        """Return how far (m) the sample is from where its level surface ends, measured up to 0.4 m."""
        half = 16
        near = np.abs(points[:, :2] - sample[:2]).max(axis=1) < half * self.cell
        level = near & (np.abs(points[:, 2] - sample[2]) < SLAB_THICKNESS / 2)
        cells = np.zeros((2 * half + 1, 2 * half + 1), dtype=np.uint8)
        column, row = np.rint((points[level, :2] - sample[:2]) / self.cell).astype(np.int64).T
        cells[row + half, column + half] = 1
        closed = cv2.morphologyEx(cells, cv2.MORPH_CLOSE, np.ones((3, 3), np.uint8))
        padded = cv2.copyMakeBorder(closed, 1, 1, 1, 1, cv2.BORDER_CONSTANT, value=0)
        return float(cv2.distanceTransform(padded, cv2.DIST_L2, 3)[half + 1, half + 1]) * self.cell


def _slab_counts(points: Points, samples: Points) -> NDArray[np.int64]:
    """Return (K,): how many points lie in the slab around each sample."""
    offset = np.abs(points[None, :, :] - samples[:, None, :])
    inside = (offset[..., 0] < SLAB_WIDTH / 2) & (offset[..., 1] < SLAB_WIDTH / 2)
    return np.count_nonzero(inside & (offset[..., 2] < SLAB_THICKNESS / 2), axis=1)
