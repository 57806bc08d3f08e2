"""Taking back what the map holds where the floor is seen again and again, and nothing above it (`clearing`)."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.grid import Grid, Mask
from uniteam.mind.mapping.low_obstacles import LOWEST_OBSTACLE
from uniteam.mind.mapping.projection import ROLE_COUNT, Channels, MappedFrame

_FLOOR, _THING = 1, 2


class MapCells(NamedTuple):
    """What may be taken back.

    Attributes:
        channels: the map's.
        felt: (H, W) bool, obstacles that nothing was seen of, and that no look takes back.
        grid: where the cells lie in the start frame.
    """

    channels: Channels
    felt: Mask
    grid: Grid


Clear = Callable[[MappedFrame, MapCells], None]
"""Takes cells back by what a frame shows."""


def nothing_is_cleared(frame: MappedFrame, cells: MapCells) -> None:
    """Leave every cell as it is: nothing clears an obstacle of HomeRobot's."""


def never_clear() -> Clear:
    """Begin an episode as HomeRobot does."""
    return nothing_is_cleared


@dataclass(frozen=True)
class ClearSeenThrough:
    """Begins an episode in which cells are taken back.

    Attributes:
        frames: in so many the floor must have been seen since anything was seen there last.
        max_depth: what is farther is not looked at (m).
        floor: what is lower is the floor (m).
    """

    frames: int = 8
    max_depth: float = 3.0
    floor: float = LOWEST_OBSTACLE

    def __call__(self) -> Clear:
        """Return what takes cells back, with nothing counted yet."""
        return _SeenThrough(self)


class _SeenThrough:
    """Counts for each cell the frames that showed the floor and nothing above it."""

    def __init__(self, rule: ClearSeenThrough) -> None:
        self._rule = rule
        self._counts = np.zeros((0, 0), dtype=np.uint8)
        self._seen = np.zeros((0, 0), dtype=np.uint8)
        self._grid = Grid((0.0, 0.0), 1.0)

    def __call__(self, frame: MappedFrame, cells: MapCells) -> None:
        shape = cells.channels.obstacle.shape
        if self._counts.shape != shape:
            self._counts = self._moved(shape, cells.grid)
            self._seen = np.zeros(shape, dtype=np.uint8)
            self._grid = cells.grid
        heights = np.array([self._rule.max_depth, self._rule.floor], dtype=np.float32)
        _mark_seen(frame, heights, 1.0 / cells.grid.cell_size, self._seen)
        reach = round(1.2 * self._rule.max_depth / cells.grid.cell_size)
        row, column = int(frame.base[1] / cells.grid.cell_size), int(frame.base[0] / cells.grid.cell_size)
        box = (max(0, row - reach), min(shape[0], row + reach), max(0, column - reach), min(shape[1], column + reach))
        _take_back(self._seen, self._counts, cells.felt, cells.channels, box, self._rule.frames)

    def _moved(self, shape: tuple[int, ...], grid: Grid) -> NDArray[np.uint8]:
        """Return the counts on a map that has grown."""
        counts = np.zeros(shape, dtype=np.uint8)
        if self._counts.size:
            left = round((self._grid.origin[0] - grid.origin[0]) / grid.cell_size)
            top = round((self._grid.origin[1] - grid.origin[1]) / grid.cell_size)
            rows, columns = self._counts.shape
            counts[top : top + rows, left : left + columns] = self._counts
        return counts


@njit(cache=True, nogil=True, fastmath=True)
def _mark_seen(
    frame: MappedFrame, heights: NDArray[np.float32], cells_per_metre: float, seen: NDArray[np.uint8]
) -> None:  # pragma: no cover
    """Note for each cell of the grid whether a frame shows its floor and whether it shows anything above it."""
    fx, fy, cx, cy = frame.intrinsics
    m = frame.camera_to_grid
    rows, columns = seen.shape
    max_depth, floor = heights
    for v in range(frame.depth.shape[0]):
        b = (np.float32(v) - cy) / fy
        for u in range(frame.depth.shape[1]):
            z = frame.depth[v, u]
            if z <= 0 or z > max_depth:
                continue
            a = (np.float32(u) - cx) / fx
            x = (m[0, 0] * a + m[0, 1] * b + m[0, 2]) * z + m[0, 3]
            y = (m[1, 0] * a + m[1, 1] * b + m[1, 2]) * z + m[1, 3]
            row, column = int(y * cells_per_metre), int(x * cells_per_metre)
            if x < 0 or y < 0 or row >= rows or column >= columns:
                continue
            height = (m[2, 0] * a + m[2, 1] * b + m[2, 2]) * z + m[2, 3]
            seen[row, column] |= _FLOOR if height < floor else _THING


@njit(cache=True, nogil=True)
def _take_back(
    seen: NDArray[np.uint8],
    counts: NDArray[np.uint8],
    felt: Mask,
    channels: Channels,
    box: tuple[int, int, int, int],
    frames: int,
) -> None:  # pragma: no cover
    """Count what was seen within a box of rows and columns, take back what was seen through, and leave `seen` zero."""
    for row in range(box[0], box[1]):
        for column in range(box[2], box[3]):
            shown = seen[row, column]
            if shown == 0:
                continue
            seen[row, column] = 0
            if shown != _FLOOR:
                counts[row, column] = 0
                continue
            counts[row, column] = min(counts[row, column] + 1, 255)
            if counts[row, column] < frames:
                continue
            if not felt[row, column]:
                channels.obstacle[row, column] = False
            for role in range(ROLE_COUNT):
                channels.class_cells[role, row, column] = False
                channels.class_probability[role, row, column] = 0.0
