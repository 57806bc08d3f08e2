"""HomeRobot's projection: blocks of pixels, each with its first pixel's depth and the mean of its labels.

Each block is one point. It is spread over the eight nearest voxels of a grid before the robot, by nearness; voxels are
rounded to whole points and summed over their height. The sums are turned and shifted onto the map, bilinearly both
times. A cell is an obstacle from half a point on, after a median over 3 x 3 cells, and of a class from one point on. A
block on the edge of two things marks what is behind where the thing before it stands.

The method is that of HomeRobot's semantic map (arXiv 2306.11565).
"""

import math

import cv2
import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.mind.mapping.projection import ROLE_COUNT, Channels, Limits, MappedFrame, Scratch

BLOCKS_ACROSS = 120
"""Of a frame: 4 x 4 pixels of one that is 480 wide."""
VIEW_CELLS = 100
"""How far the grid before the robot reaches, and how wide it is at least."""
LOWEST, LEVELS = -8, 80
"""Of the voxels: from 40 cm below the floor to 3.6 m above it, in voxels as high as a cell is long."""
OFF_AXIS = 1.15
"""See `map_config.OFF_AXIS`."""
CAMERA_CLEARANCE = 0.01
"""m; what is higher above the camera is no obstacle."""
OBSTACLE_FROM, CLASS_FROM = 0.5, 1.0 - 1e-6
"""Points in a cell."""
CHANNELS = 2 + ROLE_COUNT
"""Solid, seen, and one for each role."""

View = NDArray[np.float32]
"""(CHANNELS, rows, columns): what lies before the robot; it stands at row 0 in the middle, and looks along the rows."""


def averaged_blocks(
    frame: MappedFrame, limits: Limits, scratch: Scratch, channels: Channels
) -> tuple[int, int, int, int]:
    """Bring a frame into the map; return the first row and column and the last row and column that may have changed."""
    block = max(1, round(frame.depth.shape[1] / BLOCKS_ACROSS))
    view, scores = _splat(frame, limits, block, _size(limits))
    view[0] = cv2.medianBlur(view[0], 3)
    return _merge(_turn(view, frame), scores, frame, limits, channels)


def _size(limits: Limits) -> int:
    farthest = max(limits.max_depth, float(limits.class_depths.max()))
    return max(VIEW_CELLS, math.ceil(OFF_AXIS * farthest * limits.cells_per_metre))


@njit(cache=True, nogil=True)
def _splat(
    frame: MappedFrame, limits: Limits, block: int, size: int
) -> tuple[NDArray[np.float32], NDArray[np.float32]]:  # pragma: no cover
    """Return the (CHANNELS, size, size) view and the (ROLE_COUNT, size, size) best scores at its cells."""
    voxels = np.zeros((size, size, LEVELS, 1 + ROLE_COUNT), dtype=np.float32)
    lowest = np.full((size, size), LEVELS, dtype=np.int32)
    highest = np.full((size, size), -1, dtype=np.int32)
    best = np.zeros((ROLE_COUNT, size, size), dtype=np.float32)
    scores = np.zeros(ROLE_COUNT, dtype=np.float32)
    fx, fy, cx, cy = frame.intrinsics
    m = frame.camera_to_grid
    c, s = _ahead(m)
    features = np.zeros(1 + ROLE_COUNT, dtype=np.float32)
    share = np.float32(1.0) / np.float32(block * block)
    farthest = max(limits.max_depth, limits.class_depths.max())
    for v in range(0, frame.depth.shape[0] - block + 1, block):
        for u in range(0, frame.depth.shape[1] - block + 1, block):
            z = frame.depth[v, u]
            if z < limits.min_depth or z > farthest:
                continue
            features[:], scores[:] = 0, 0
            features[0] = 1.0 if z <= limits.max_depth else 0.0
            for dv in range(block):
                for du in range(block):
                    instance = frame.instances[v + dv, u + du]
                    if instance < 0:
                        continue
                    for role in range(ROLE_COUNT):
                        score = frame.scores[instance, role]
                        if score > 0 and z <= limits.class_depths[role]:
                            features[1 + role] += share
                            scores[role] = max(scores[role], score)
            a, b = (np.float32(u) - cx) / fx, (np.float32(v) - cy) / fy
            x = (m[0, 0] * a + m[0, 1] * b + m[0, 2]) * z
            y = (m[1, 0] * a + m[1, 1] * b + m[1, 2]) * z
            height = (m[2, 0] * a + m[2, 1] * b + m[2, 2]) * z + m[2, 3]
            row = (c * x + s * y) * limits.cells_per_metre
            column = (c * y - s * x) * limits.cells_per_metre + size // 2
            level = height * limits.cells_per_metre - LOWEST
            _spread_point(voxels, features, row, column, level)
            _widen(lowest, highest, row, column, level)
            if 0 <= row < size - 1 and 0 <= column < size - 1:
                r, k = round(row), round(column)
                for role in range(ROLE_COUNT):
                    best[role, r, k] = max(best[role, r, k], scores[role])
    return _sum_levels(voxels, lowest, highest, m[2, 3], limits), best


@njit(cache=True, nogil=True)
def _ahead(camera_to_grid: NDArray[np.float32]) -> tuple[float, float]:  # pragma: no cover
    """Return the cosine and the sine of the camera's heading."""
    length = math.hypot(camera_to_grid[0, 2], camera_to_grid[1, 2])
    return camera_to_grid[0, 2] / length, camera_to_grid[1, 2] / length


@njit(cache=True, nogil=True)
def _spread_point(
    voxels: NDArray[np.float32], features: NDArray[np.float32], row: float, column: float, level: float
) -> None:  # pragma: no cover
    """Add a point's features to the eight voxels around it."""
    for dr in range(2):
        r = math.floor(row) + dr
        if r <= 0 or r >= voxels.shape[0]:
            continue
        for dc in range(2):
            k = math.floor(column) + dc
            if k <= 0 or k >= voxels.shape[1]:
                continue
            for dl in range(2):
                n = math.floor(level) + dl
                if n <= 0 or n >= LEVELS:
                    continue
                weight = (1 - abs(row - r)) * (1 - abs(column - k)) * (1 - abs(level - n))
                for i in range(1 + ROLE_COUNT):
                    voxels[r, k, n, i] += np.float32(weight) * features[i]


@njit(cache=True, nogil=True)
def _widen(
    lowest: NDArray[np.int32], highest: NDArray[np.int32], row: float, column: float, level: float
) -> None:  # pragma: no cover
    """Note between which levels the columns of voxels around a point are not empty."""
    first = max(0, math.floor(level))
    last = min(LEVELS - 1, math.floor(level) + 1)
    for r in range(max(0, math.floor(row)), min(lowest.shape[0], math.floor(row) + 2)):
        for k in range(max(0, math.floor(column)), min(lowest.shape[1], math.floor(column) + 2)):
            lowest[r, k] = min(lowest[r, k], first)
            highest[r, k] = max(highest[r, k], last)


@njit(cache=True, nogil=True)
def _sum_levels(
    voxels: NDArray[np.float32],
    lowest: NDArray[np.int32],
    highest: NDArray[np.int32],
    camera_height: float,
    limits: Limits,
) -> NDArray[np.float32]:  # pragma: no cover
    """Return the sums of whole points over the height, and over the obstacles' heights."""
    size = voxels.shape[0]
    view = np.zeros((CHANNELS, size, size), dtype=np.float32)
    low = round(limits.min_height * limits.cells_per_metre) - LOWEST
    high = math.floor((camera_height + CAMERA_CLEARANCE) * limits.cells_per_metre) - LOWEST
    for r in range(size):
        for k in range(size):
            for n in range(lowest[r, k], highest[r, k] + 1):
                points = np.round(voxels[r, k, n, 0])
                view[1, r, k] += points
                if low <= n < high:
                    view[0, r, k] += points
                for role in range(ROLE_COUNT):
                    view[2 + role, r, k] += np.round(voxels[r, k, n, 1 + role])
    return view


@njit(cache=True, nogil=True)
def _sample(picture: View, row: float, column: float, values: NDArray[np.float32]) -> bool:  # pragma: no cover
    """Fill in the values of all channels between four pixels; return whether any is not 0. What is outside is 0."""
    top, left = math.floor(row), math.floor(column)
    values[:] = 0
    found = 0
    for r in range(max(0, top), min(picture.shape[1], top + 2)):
        for k in range(max(0, left), min(picture.shape[2], left + 2)):
            weight = np.float32((1 - abs(row - r)) * (1 - abs(column - k)))
            for channel in range(CHANNELS):
                if picture[channel, r, k] > 0 and weight > 0:
                    values[channel] += weight * picture[channel, r, k]
                    found += 1
    return found > 0


@njit(cache=True, nogil=True)
def _turn(view: View, frame: MappedFrame) -> View:  # pragma: no cover
    """Return the view turned by the robot's heading, with the robot in the middle: rows along y, columns along x."""
    size = view.shape[1]
    c, s = _ahead(frame.camera_to_grid)
    turned = np.zeros((CHANNELS, 2 * size + 1, 2 * size + 1), dtype=np.float32)
    values = np.zeros(CHANNELS, dtype=np.float32)
    for r in range(2 * size + 1):
        for k in range(2 * size + 1):
            x, y = k - size, r - size
            row, column = c * x + s * y, c * y - s * x + size // 2
            inside = -1 < row < size and -1 < column < size
            if inside and _sample(view, row, column, values):
                turned[:, r, k] = values
    return turned


@njit(cache=True, nogil=True)
def _merge(
    turned: View, scores: NDArray[np.float32], frame: MappedFrame, limits: Limits, channels: Channels
) -> tuple[int, int, int, int]:  # pragma: no cover
    """Write the turned view into the map, shifted to where the robot stands; return the part that changed."""
    rows, columns = channels.obstacle.shape
    size = turned.shape[1] // 2
    y, x = frame.base[1] * limits.cells_per_metre, frame.base[0] * limits.cells_per_metre
    c, s = _ahead(frame.camera_to_grid)
    values = np.zeros(CHANNELS, dtype=np.float32)
    first_row, first_column, last_row, last_column = rows, columns, -1, -1
    for row in range(max(0, math.floor(y) - size), min(rows, math.floor(y) + size + 2)):
        for column in range(max(0, math.floor(x) - size), min(columns, math.floor(x) + size + 2)):
            if not _sample(turned, row - y + size, column - x + size, values):
                continue
            first_row, last_row = min(first_row, row), max(last_row, row)
            first_column, last_column = min(first_column, column), max(last_column, column)
            seen = values[1] > 0
            if seen:
                channels.explored[row, column] = True
            if values[0] > OBSTACLE_FROM:
                channels.obstacle[row, column] = True
            for role in range(ROLE_COUNT):
                probability = channels.class_probability[role, row, column]
                if values[2 + role] >= CLASS_FROM:
                    along, across = column - x, row - y
                    ahead, left = c * along + s * across, c * across - s * along + size // 2
                    score = _best_near(scores[role], round(ahead), round(left))
                    gain = limits.gain if probability > 0 else np.float32(1.0)
                    channels.class_probability[role, row, column] = probability + gain * (score - probability)
                    channels.class_cells[role, row, column] = True
                elif seen and probability > 0:
                    channels.class_probability[role, row, column] = probability * (np.float32(1.0) - limits.decay)
    return first_row, first_column, last_row, last_column


@njit(cache=True, nogil=True)
def _best_near(scores: NDArray[np.float32], row: int, column: int) -> np.float32:  # pragma: no cover
    """Return the best score within two cells, as far as the values of a cell come from."""
    best = np.float32(0.0)
    for r in range(max(0, row - 2), min(scores.shape[0], row + 3)):
        for k in range(max(0, column - 2), min(scores.shape[1], column + 3)):
            best = max(best, scores[r, k])
    return best
