"""Placing points that keep away from the edges of what they lie on."""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.mind.manipulation.arm_clearance import Load
from uniteam.mind.manipulation.place.flat_surfaces import CELL, RISE, level_points
from uniteam.mind.manipulation.place.placing_points import PlacingPoints
from uniteam.mind.skills.view import Points

FLATNESS_WORTH = 0.05
"""m of distance from the edge that it is worth to have level ground all around."""
FLATNESS_RADIUS = 0.1
"""m."""


@dataclass(frozen=True)
class SafeFromEdges:
    """Points on which a thing can stand, worth their distance from where the surface ends.

    A surface ends where nothing of the receptacle is seen that is as high: at its edge, and at what lies on it. A back,
    a rim or a wall of the receptacle itself is no edge, so the middle of a seat, a basin or a bowl is safe.

    Attributes:
        margin: the distance (m) that is enough for what is not larger; points that have more are worth hardly more.
        least: points that have less (m) are not offered, unless no point has more.
        samples: how many points to weigh.
    """

    margin: float = 0.12
    least: float = 0.04
    samples: int = 150

    def __call__(self, points: Points, load: Load, generator: np.random.Generator) -> PlacingPoints:
        """Return sampled points with their worth."""
        level = level_points(points)
        chosen = generator.choice(len(level), size=min(self.samples, len(level)), replace=False)
        candidates = level[chosen]
        distance = np.array([self._edge_distance(points, candidate) for candidate in candidates])
        offered = distance >= min(self.least, distance.max(initial=0.0))
        flatness = np.array([_flatness(points, candidate) for candidate in candidates])
        margin = max(self.margin, load.along_base)
        worth = np.minimum(distance, margin) + 0.1 * distance + FLATNESS_WORTH * flatness
        return PlacingPoints(candidates[offered], worth[offered])

    def _edge_distance(self, points: Points, sample: NDArray[np.float32]) -> float:
        """Return how far (m) the sample is from where its surface ends, up to 0.4 m."""
        half = 16
        near = np.abs(points[:, :2] - sample[:2]).max(axis=1) < half * CELL
        as_high = points[near & (points[:, 2] > sample[2] - 1.5 * RISE), :2]
        column, row = np.rint((as_high - sample[:2]) / CELL).astype(np.int64).T
        cells = np.zeros((2 * half + 1, 2 * half + 1), dtype=np.uint8)
        cells[row + half, column + half] = 1
        closed = cv2.morphologyEx(cells, cv2.MORPH_CLOSE, np.ones((3, 3), np.uint8))
        padded = cv2.copyMakeBorder(closed, 1, 1, 1, 1, cv2.BORDER_CONSTANT, value=0)
        return float(cv2.distanceTransform(padded, cv2.DIST_L2, 3)[half + 1, half + 1]) * CELL


def _flatness(points: Points, sample: NDArray[np.float32]) -> float:
    """Return the share of the points around a sample that are at its height: 1 on a table, little on a slope."""
    near = points[np.abs(points[:, :2] - sample[:2]).max(axis=1) < FLATNESS_RADIUS, 2]
    return float(np.mean(np.abs(near - sample[2]) < RISE)) if len(near) else 0.0
