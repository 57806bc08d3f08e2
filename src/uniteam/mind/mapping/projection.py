"""One pass over the pixels of a frame: depth and segmentation become counts on the floor's grid, then the map's cells.

The kernel bins every point by the cell above which it lies, remembers which cells it touched, and merges those cells
into the map: the cost is that of the pixels, whatever the size of the map.
"""

from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

ROLE_COUNT = 3
TOUCHED, SEEN, SOLID, FIRST_CLASS = 0, 1, 2, 3  # columns of `Scratch.counts`
_COUNT_COLUMNS = FIRST_CLASS + ROLE_COUNT

Box = tuple[int, int, int, int]
"""First row, first column, last row, last column of a part of the map; the last are less where there is nothing."""


class MappedFrame(NamedTuple):
    """A frame as the kernel takes it.

    Attributes:
        depth: (H, W) float32, metres along the optical axis.
        instances: (H, W) int16, index into `scores`, -1 for none.
        scores: (D, 3) float32, score of each detection for each `ClassRole`; 0 for none.
        intrinsics: (4,) float32, fx, fy, cx, cy.
        camera_to_grid: (3, 4) float32; metres, x and y relative to the corner of cell [0, 0], z above the floor.
        base: (2,) float32, the robot's x and y in the grid frame.
    """

    depth: NDArray[np.float32]
    instances: NDArray[np.int16]
    scores: NDArray[np.float32]
    intrinsics: NDArray[np.float32]
    camera_to_grid: NDArray[np.float32]
    base: NDArray[np.float32]


class Limits(NamedTuple):
    """What counts: metres, except for the numbers of points and the two rates."""

    cells_per_metre: float
    min_depth: float
    max_depth: float
    class_depths: NDArray[np.float32]
    min_height: float
    max_height: float
    own_radius: float
    min_solid_points: int
    min_class_points: int
    gain: float
    decay: float


class Channels(NamedTuple):
    """The map's cells: (H, W) bool; the class channels (3, H, W) bool, float32, float32."""

    obstacle: NDArray[np.bool_]
    explored: NDArray[np.bool_]
    class_cells: NDArray[np.bool_]
    class_probability: NDArray[np.float32]
    class_height: NDArray[np.float32]


class Scratch(NamedTuple):
    """What one frame put where; all zero between frames.

    Attributes:
        counts: (H * W, 6) int32: points binned, seen within the mapped depth, at obstacle height, of each class.
        scores: (H * W, 3) float32: best score of each class.
        heights: (H * W, 3) float32: greatest height of each class.
        touched: (H * W,) int32: indices of the cells that are not zero; its first entries are in use.
    """

    counts: NDArray[np.int32]
    scores: NDArray[np.float32]
    heights: NDArray[np.float32]
    touched: NDArray[np.int32]


@njit(cache=True, nogil=True, fastmath=True)
def _count_points(
    frame: MappedFrame, limits: Limits, scratch: Scratch, shape: tuple[int, int]
) -> int:  # pragma: no cover
    """Count the points of a frame by cell; return how many cells were touched."""
    fx, fy, cx, cy = frame.intrinsics
    m = frame.camera_to_grid
    rows, columns = shape
    own_radius_squared = limits.own_radius * limits.own_radius
    cells_per_metre = np.float32(limits.cells_per_metre)
    farthest = max(limits.max_depth, limits.class_depths.max())
    touched = 0
    for v in range(frame.depth.shape[0]):
        b = (np.float32(v) - cy) / fy
        for u in range(frame.depth.shape[1]):
            z = frame.depth[v, u]
            instance = frame.instances[v, u]
            if z < limits.min_depth or z > farthest or (instance < 0 and z > limits.max_depth):
                continue
            a = (np.float32(u) - cx) / fx
            x = (m[0, 0] * a + m[0, 1] * b + m[0, 2]) * z + m[0, 3]
            y = (m[1, 0] * a + m[1, 1] * b + m[1, 2]) * z + m[1, 3]
            row, column = int(y * cells_per_metre), int(x * cells_per_metre)
            if x < 0 or y < 0 or row >= rows or column >= columns:
                continue
            dx, dy = x - frame.base[0], y - frame.base[1]
            if dx * dx + dy * dy < own_radius_squared:
                continue
            height = (m[2, 0] * a + m[2, 1] * b + m[2, 2]) * z + m[2, 3]
            cell = row * columns + column
            if scratch.counts[cell, TOUCHED] == 0:
                scratch.touched[touched] = cell
                touched += 1
            scratch.counts[cell, TOUCHED] += 1
            if z <= limits.max_depth:
                scratch.counts[cell, SEEN] += 1
                if limits.min_height < height < limits.max_height:
                    scratch.counts[cell, SOLID] += 1
            if instance >= 0:
                for role in range(ROLE_COUNT):
                    score = frame.scores[instance, role]
                    if score > 0 and z <= limits.class_depths[role]:
                        scratch.counts[cell, FIRST_CLASS + role] += 1
                        scratch.scores[cell, role] = max(scratch.scores[cell, role], score)
                        scratch.heights[cell, role] = max(scratch.heights[cell, role], height)
    return touched


@njit(cache=True, nogil=True, fastmath=True)
def _merge(
    scratch: Scratch, touched: int, channels: Channels, limits: Limits
) -> tuple[int, int, int, int]:  # pragma: no cover
    """Write the touched cells into the map and leave the scratch zero; return the first and last row and column."""
    rows, columns = channels.obstacle.shape
    first_row, first_column, last_row, last_column = rows, columns, -1, -1
    for k in range(touched):
        cell = scratch.touched[k]
        row, column = cell // columns, cell % columns
        first_row, last_row = min(first_row, row), max(last_row, row)
        first_column, last_column = min(first_column, column), max(last_column, column)
        seen = scratch.counts[cell, SEEN] > 0
        if seen:
            channels.explored[row, column] = True
        if scratch.counts[cell, SOLID] >= limits.min_solid_points:
            channels.obstacle[row, column] = True
        for role in range(ROLE_COUNT):
            probability = channels.class_probability[role, row, column]
            if scratch.counts[cell, FIRST_CLASS + role] >= limits.min_class_points:
                score = scratch.scores[cell, role]
                gain = limits.gain if probability > 0 else np.float32(1.0)
                channels.class_probability[role, row, column] = probability + gain * (score - probability)
                channels.class_cells[role, row, column] = True
                channels.class_height[role, row, column] = scratch.heights[cell, role]
            elif seen and probability > 0:
                channels.class_probability[role, row, column] = probability * (np.float32(1.0) - limits.decay)
            scratch.scores[cell, role] = 0
            scratch.heights[cell, role] = 0
        scratch.counts[cell, :] = 0
    return first_row, first_column, last_row, last_column


class ExactPixels:
    """Brings frames into the map pixel by pixel, each by its own depth and label."""

    def __init__(self) -> None:
        """Begin without counts; the first frame says for how many cells they are needed."""
        self._scratch = _make_scratch(0)

    def __call__(self, frame: MappedFrame, limits: Limits, channels: Channels) -> Box:
        """Bring a frame into the map: what it shows is explored, solid, of a class, or no longer of one."""
        if len(self._scratch.touched) != channels.obstacle.size:
            self._scratch = _make_scratch(channels.obstacle.size)
        return _project(frame, limits, self._scratch, channels)


def exact_pixels() -> ExactPixels:
    """Begin an episode with a map by the pixel: `exact_labels`."""
    return ExactPixels()


def _make_scratch(size: int) -> Scratch:
    return Scratch(
        np.zeros((size, _COUNT_COLUMNS), dtype=np.int32),
        np.zeros((size, ROLE_COUNT), dtype=np.float32),
        np.zeros((size, ROLE_COUNT), dtype=np.float32),
        np.zeros(size, dtype=np.int32),
    )


@njit(cache=True, nogil=True, fastmath=True)
def _project(frame: MappedFrame, limits: Limits, scratch: Scratch, channels: Channels) -> Box:  # pragma: no cover
    """Bring a frame into the map; return the part that it touched."""
    touched = _count_points(frame, limits, scratch, channels.obstacle.shape)
    return _merge(scratch, touched, channels, limits)
