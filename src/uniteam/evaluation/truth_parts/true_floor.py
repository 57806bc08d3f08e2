"""The true floor of a home in the frame in which an agent's episode began."""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose, transform_points
from uniteam.grid import Cell, Grid, Mask
from uniteam.world.physics.navigable_floor import CELL_SIZE, NavigableFloor


@dataclass(frozen=True)
class TrueFloor:
    """A floor, seen from where the robot started.

    Attributes:
        floor: in the world's frame.
        start: the pose (world) that is the start frame.
    """

    floor: NavigableFloor
    start: BasePose

    def obstacles(self, grid: Grid, shape: Cell) -> Mask:
        """Return the (H, W) cells of a grid of the start frame in which something stands, or that lie outside rooms."""
        blocked = cv2.dilate((self.floor.cells <= 0.0).astype(np.uint8), np.ones((3, 3), np.uint8))
        sampled = cv2.warpAffine(
            blocked,
            self._cells_to_floor(grid),
            (shape[1], shape[0]),
            flags=cv2.INTER_NEAREST | cv2.WARP_INVERSE_MAP,
            borderValue=1,
        )
        return np.asarray(sampled, dtype=np.bool_)

    def to_world(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return (N, 2) points of the start frame (m) in the world's."""
        return _transformed(self.start, points)

    def to_start(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return (N, 2) points of the world (m) in the start frame."""
        return _transformed(self.start.inverse(), points)

    def _cells_to_floor(self, grid: Grid) -> NDArray[np.float64]:
        """Return the (2, 3) map from a cell (column, row) of a grid to one of the floor."""
        corners = self.to_world(grid.to_points(np.array([[0, 0], [0, 1], [1, 0]])))
        origin, right, up = (corners - self.floor.to_point(0, 0)) / CELL_SIZE
        return np.column_stack([right - origin, up - origin, origin])


def _transformed(pose: BasePose, points: NDArray[np.float64]) -> NDArray[np.float64]:
    return transform_points(pose.matrix(), np.column_stack([points, np.zeros(len(points))]))[:, :2]
