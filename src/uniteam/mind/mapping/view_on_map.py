"""Bringing what lies before the robot onto the map: turned by its heading, then shifted to where it stands.

Both times a cell takes its values bilinearly from the four around its place, as HomeRobot's semantic map does
(arXiv 2306.11565). Most cells have nothing near to them, and are passed over.
"""

import math

import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.mind.mapping.projection import ROLE_COUNT, Box, Channels, Limits, MappedFrame

OBSTACLE_FROM, CLASS_FROM = 0.5, 1.0 - 1e-6
"""Points in a cell."""
CHANNELS = 2 + ROLE_COUNT
"""Solid, seen, and one for each role."""

View = NDArray[np.float32]
"""(rows, columns, CHANNELS): what lies before the robot; it stands at row 0 in the middle, and looks along the rows."""


@njit(cache=True, nogil=True)
def ahead(camera_to_grid: NDArray[np.float32]) -> tuple[float, float]:  # pragma: no cover
    """Return the cosine and the sine of the camera's heading."""
    length = math.hypot(camera_to_grid[0, 2], camera_to_grid[1, 2])
    return camera_to_grid[0, 2] / length, camera_to_grid[1, 2] / length


@njit(cache=True, nogil=True)
def bring_onto_map(
    view: View, scores: NDArray[np.float32], frame: MappedFrame, limits: Limits, channels: Channels
) -> Box:  # pragma: no cover
    """Write a view into the map; return the part that changed.

    Args:
        view: nowhere less than 0.
        scores: (ROLE_COUNT, rows, columns), the best ones at the view's cells.
        frame: where the robot stands and looks.
        limits: of the map.
        channels: of the map, which are changed.
    """
    turned, box = _turn(view, frame)
    return _merge(turned, box, scores, frame, limits, channels)


@njit(cache=True, nogil=True)
def _turn(view: View, frame: MappedFrame) -> tuple[View, Box]:  # pragma: no cover
    """Return the view turned by the robot's heading, with the robot in the middle, and the part that is not 0.

    Rows are along y, columns along x.
    """
    size = view.shape[1]
    c, s = ahead(frame.camera_to_grid)
    is_filled = _filled(view, (0, 0, size - 1, size - 1))
    box = _turned_box(is_filled, c, s)
    turned = np.zeros((2 * size + 1, 2 * size + 1, CHANNELS), dtype=np.float32)
    values = np.zeros(CHANNELS, dtype=np.float32)
    first_row, first_column, last_row, last_column = 2 * size + 1, 2 * size + 1, -1, -1
    for r in range(box[0], box[2] + 1):
        for k in range(box[1], box[3] + 1):
            x, y = k - size, r - size
            row, column = c * x + s * y, c * y - s * x + size // 2
            inside = -1 < row < size and -1 < column < size
            if inside and _sample(view, is_filled, row, column, values):
                for channel in range(CHANNELS):
                    turned[r, k, channel] = values[channel]
                first_row, last_row = min(first_row, r), max(last_row, r)
                first_column, last_column = min(first_column, k), max(last_column, k)
    return turned, (first_row, first_column, last_row, last_column)


@njit(cache=True, nogil=True)
def _turned_box(is_filled: NDArray[np.bool_], c: float, s: float) -> Box:  # pragma: no cover
    """Return the part of the turned view in which anything may lie: two cells around what is filled, turned."""
    size = is_filled.shape[1]
    first_row, first_column, last_row, last_column = 2 * size, 2 * size, 0, 0
    for r in range(size):
        for k in range(size):
            if is_filled[r, k]:
                x, y = c * r - s * (k - size // 2) + size, s * r + c * (k - size // 2) + size
                first_row, last_row = min(first_row, math.floor(y) - 2), max(last_row, math.floor(y) + 3)
                first_column, last_column = min(first_column, math.floor(x) - 2), max(last_column, math.floor(x) + 3)
    return max(first_row, 0), max(first_column, 0), min(last_row, 2 * size), min(last_column, 2 * size)


@njit(cache=True, nogil=True)
def _filled(picture: View, box: Box) -> NDArray[np.bool_]:  # pragma: no cover
    """Return the (rows, columns) cells of which any channel is more than 0; there are none outside of a box."""
    is_filled = np.zeros(picture.shape[:2], dtype=np.bool_)
    for r in range(box[0], box[2] + 1):
        for k in range(box[1], box[3] + 1):
            for channel in range(CHANNELS):
                is_filled[r, k] |= picture[r, k, channel] > 0
    return is_filled


@njit(cache=True, nogil=True, inline="always")
def _sample(
    picture: View, is_filled: NDArray[np.bool_], row: float, column: float, values: NDArray[np.float32]
) -> bool:  # pragma: no cover
    """Fill in the values of all channels between four pixels; return whether any is not 0. What is outside is 0."""
    top, left = math.floor(row), math.floor(column)
    found = False
    for r in range(max(0, top), min(picture.shape[0], top + 2)):
        for k in range(max(0, left), min(picture.shape[1], left + 2)):
            weight = np.float32((1 - abs(row - r)) * (1 - abs(column - k)))
            if is_filled[np.uint64(r), np.uint64(k)] and weight > 0:
                for channel in range(CHANNELS):
                    before = values[channel] if found else np.float32(0.0)
                    values[channel] = before + weight * picture[np.uint64(r), np.uint64(k), channel]
                found = True
    return found


@njit(cache=True, nogil=True)
def _merge(
    turned: View, box: Box, scores: NDArray[np.float32], frame: MappedFrame, limits: Limits, channels: Channels
) -> Box:  # pragma: no cover
    """Write the turned view, which is not 0 in a box, into the map, shifted to where the robot stands."""
    rows, columns = channels.obstacle.shape
    size = turned.shape[1] // 2
    y, x = frame.base[1] * limits.cells_per_metre, frame.base[0] * limits.cells_per_metre
    is_filled = _filled(turned, box)
    values = np.zeros(CHANNELS, dtype=np.float32)
    first_row, first_column, last_row, last_column = rows, columns, -1, -1
    top, left = math.floor(y) - size, math.floor(x) - size
    for row in range(max(0, top + box[0] - 1), min(rows, top + box[2] + 3)):
        for column in range(max(0, left + box[1] - 1), min(columns, left + box[3] + 3)):
            if _sample(turned, is_filled, row - y + size, column - x + size, values):
                first_row, last_row = min(first_row, row), max(last_row, row)
                first_column, last_column = min(first_column, column), max(last_column, column)
                _write(row, column, values, scores, column - x, row - y, frame, limits, channels)
    return first_row, first_column, last_row, last_column


@njit(cache=True, nogil=True, inline="always")
def _write(
    row: int,
    column: int,
    values: NDArray[np.float32],
    scores: NDArray[np.float32],
    along: float,
    across: float,
    frame: MappedFrame,
    limits: Limits,
    channels: Channels,
) -> None:  # pragma: no cover
    """Write what was seen into a cell of the map, which lies so many cells along x and y from the robot."""
    seen = values[1] > 0
    if seen:
        channels.explored[row, column] = True
    if values[0] > OBSTACLE_FROM:
        channels.obstacle[row, column] = True
    for role in range(ROLE_COUNT):
        probability = channels.class_probability[role, row, column]
        if values[2 + role] >= CLASS_FROM:
            c, s = ahead(frame.camera_to_grid)
            before, left = c * along + s * across, c * across - s * along + scores.shape[1] // 2
            score = _best_near(scores[role], round(before), round(left))
            gain = limits.gain if probability > 0 else np.float32(1.0)
            channels.class_probability[role, row, column] = probability + gain * (score - probability)
            channels.class_cells[role, row, column] = True
        elif seen and probability > 0:
            channels.class_probability[role, row, column] = probability * (np.float32(1.0) - limits.decay)


@njit(cache=True, nogil=True)
def _best_near(scores: NDArray[np.float32], row: int, column: int) -> np.float32:  # pragma: no cover
    """Return the best score within two cells, as far as the values of a cell come from."""
    best = np.float32(0.0)
    for r in range(max(0, row - 2), min(scores.shape[0], row + 3)):
        for k in range(max(0, column - 2), min(scores.shape[1], column + 3)):
            best = max(best, scores[r, k])
    return best
