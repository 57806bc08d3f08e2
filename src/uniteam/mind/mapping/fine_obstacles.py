"""Obstacles at a finer grain than the map's cells, for ways that are hardly wider than the robot."""

import math
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.grid import Grid, Mask
from uniteam.interface import Observation
from uniteam.mind.mapping.low_obstacles import LOWEST_OBSTACLE
from uniteam.stretch import BASE_RADIUS, ROBOT_HEIGHT

_BLOCK = 8.0
"""m; by so much the grid grows, or a multiple of it."""
_AROUND = 1.2
"""m; the half side of the part that is looked at."""
_SAME_PLACE = 0.03
_SAME_HEADING = math.radians(4.0)


class FineObstacles(Protocol):
    """What is known of obstacles at a fine grain."""

    def update(self, observation: Observation) -> None:
        """Bring a frame in, seen in navigation posture."""

    def around(self, base: BasePose) -> tuple[Mask, Grid]:
        """Return the obstacles around a base (start frame), and where their cells lie."""

    def note_blocked(self, base: BasePose) -> None:
        """Remember that a motion straight ahead of a base was blocked."""

    def was_blocked(self, base: BasePose) -> bool:
        """Return whether much the same motion was blocked before."""


class NoFineObstacles:
    """Knows nothing finer than the map, as HomeRobot does."""

    def update(self, observation: Observation) -> None:
        """Do nothing."""

    def around(self, base: BasePose) -> tuple[Mask, Grid]:
        """Return no cells."""
        return np.zeros((1, 1), dtype=np.bool_), Grid((base.x, base.y), 1.0)

    def note_blocked(self, base: BasePose) -> None:
        """Do nothing."""

    def was_blocked(self, base: BasePose) -> bool:
        """Return False."""
        return False


def nothing_finer() -> FineObstacles:
    """Begin an episode as HomeRobot does."""
    return NoFineObstacles()


@dataclass(frozen=True)
class FineGrain:
    """Begins an episode with a fine grid.

    Attributes:
        cell_size, max_depth, min_height: see `FineObstacleGrid`.
    """

    cell_size: float = 0.0125
    max_depth: float = 2.5
    min_height: float = LOWEST_OBSTACLE

    def __call__(self) -> FineObstacles:
        """Return the grid, with nothing in it yet."""
        return FineObstacleGrid(self.cell_size, self.max_depth, self.min_height)


class FineObstacleGrid:
    """A grid of the start frame in which every cell is an obstacle that a single solid point was seen in."""

    def __init__(self, cell_size: float, max_depth: float, min_height: float) -> None:
        """Begin with nothing seen.

        Args:
            cell_size: m.
            max_depth: what is farther is too blurred for so fine a grain (m).
            min_height: what is lower is driven over (m).
        """
        self._cell_size, self._max_depth, self._min_height = cell_size, max_depth, min_height
        size = round(2 * _BLOCK / cell_size)
        self._cells = np.zeros((size, size), dtype=np.bool_)
        self._origin = (-_BLOCK, -_BLOCK)
        self._blocked: list[BasePose] = []

    def update(self, observation: Observation) -> None:
        """Bring a frame in, seen in navigation posture."""
        base, camera = observation.base_to_start, observation.camera
        self._cover(base)
        camera_to_grid = np.array(observation.camera_to_start[:3], dtype=np.float64)
        camera_to_grid[:2, 3] -= self._origin
        _mark_solid(
            np.ascontiguousarray(observation.depth, dtype=np.float32),
            np.array([camera.fx, camera.fy, camera.cx, camera.cy], dtype=np.float32),
            camera_to_grid.astype(np.float32),
            np.array([base.x - self._origin[0], base.y - self._origin[1]], dtype=np.float32),
            np.array([self._max_depth, self._min_height, ROBOT_HEIGHT, BASE_RADIUS - 0.03], dtype=np.float32),
            1.0 / self._cell_size,
            self._cells,
        )

    def around(self, base: BasePose) -> tuple[Mask, Grid]:
        """Return the obstacles around a base (start frame), and where their cells lie."""
        row, column = Grid(self._origin, self._cell_size).to_cell(base.x, base.y)
        half = round(_AROUND / self._cell_size)
        top, left = max(0, row - half), max(0, column - half)
        corner = self._origin[0] + left * self._cell_size, self._origin[1] + top * self._cell_size
        return self._cells[top : row + half, left : column + half], Grid(corner, self._cell_size)

    def note_blocked(self, base: BasePose) -> None:
        """Remember that a motion straight ahead of a base was blocked."""
        self._blocked.append(base)

    def was_blocked(self, base: BasePose) -> bool:
        """Return whether much the same motion was blocked before."""
        return any(
            base.distance_to(b.x, b.y) < _SAME_PLACE
            and abs(math.remainder(base.heading - b.heading, 2 * math.pi)) < _SAME_HEADING
            for b in self._blocked
        )

    def _cover(self, base: BasePose) -> None:
        """Grow until everything in reach of the robot lies on the grid."""
        size = round(_BLOCK / self._cell_size)
        for axis, position in ((1, base.x), (0, base.y)):
            while position - self._max_depth < self._origin[1 - axis]:
                self._cells = np.concatenate([self._blank(axis, size), self._cells], axis=axis)
                x, y = self._origin
                self._origin = (x - _BLOCK, y) if axis == 1 else (x, y - _BLOCK)
            while position + self._max_depth > self._origin[1 - axis] + self._cells.shape[axis] * self._cell_size:
                self._cells = np.concatenate([self._cells, self._blank(axis, size)], axis=axis)

    def _blank(self, axis: int, size: int) -> Mask:
        shape = list(self._cells.shape)
        shape[axis] = size
        return np.zeros(tuple(shape), dtype=np.bool_)


@njit(cache=True, nogil=True, fastmath=True)
def _mark_solid(
    depth: NDArray[np.float32],
    intrinsics: NDArray[np.float32],
    m: NDArray[np.float32],
    base: NDArray[np.float32],
    limits: NDArray[np.float32],
    cells_per_metre: float,
    cells: Mask,
) -> None:  # pragma: no cover
    """Set the cells above which a point of obstacle height was seen.

    Args:
        depth: (H, W) m.
        intrinsics: fx, fy, cx, cy.
        m: (3, 4) from the camera to the grid (m).
        base: x and y of the robot on the grid (m).
        limits: greatest depth, least and greatest height, and the radius of the robot itself (m).
        cells_per_metre: of the grid.
        cells: (R, C) bool, the grid.
    """
    fx, fy, cx, cy = intrinsics
    max_depth, low, high, own = limits
    rows, columns = cells.shape
    scale = np.float32(cells_per_metre)
    for v in range(depth.shape[0]):
        b = (np.float32(v) - cy) / fy
        for u in range(depth.shape[1]):
            z = depth[v, u]
            if z <= 0 or z > max_depth:
                continue
            a = (np.float32(u) - cx) / fx
            height = (m[2, 0] * a + m[2, 1] * b + m[2, 2]) * z + m[2, 3]
            if height < low or height > high:
                continue
            x = (m[0, 0] * a + m[0, 1] * b + m[0, 2]) * z + m[0, 3]
            y = (m[1, 0] * a + m[1, 1] * b + m[1, 2]) * z + m[1, 3]
            row, column = int(y * scale), int(x * scale)
            if x < 0 or y < 0 or row >= rows or column >= columns:
                continue
            dx, dy = x - base[0], y - base[1]
            if dx * dx + dy * dy >= own * own:
                cells[row, column] = True
