"""The point a few cells ahead that the robot can drive to in a straight line."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from uniteam.grid import Cell, Mask

_SIGHT_STEPS = 12


class ShortTermGoal(NamedTuple):
    """Where to drive in a straight line.

    Attributes:
        cell: (row, column), at most so many cells ahead as was asked for.
        straight: how many cells the way goes on in the same line, that far included.
    """

    cell: Cell
    straight: float


def find_short_term_goal(free: Mask, path: NDArray[np.int32], step_cells: int) -> ShortTermGoal:
    """Return the cell `step_cells` ahead towards the farthest point of the path that can be seen over free cells.

    Looking along the path before taking the step takes out the kinks that a path over a grid has. Where the path bends
    sooner than that, it is the path's own cell that far away: a nearer one would have the robot overshoot the bend.

    Args:
        free: (H, W) bool.
        path: (P, 2) cells (row, column), the robot's first.
        step_cells: how far ahead, in cells.
    """
    robot = path[0]
    away = np.hypot(*(path - robot).T)
    next_on_path = int(np.argmax(away >= step_cells - 0.5)) or len(path) - 1
    seen = path[next_on_path]
    for cell in path[_looks(next_on_path, len(path) - 1, step_cells)]:
        if not line_is_free(free, robot, cell):
            break
        seen = cell
    along = seen - robot
    length = float(np.hypot(*along))
    if length > step_cells:
        along = np.rint(along * (step_cells / length)).astype(np.int32)
    return ShortTermGoal((int(robot[0] + along[0]), int(robot[1] + along[1])), length)


def line_is_free(free: Mask, start: NDArray[np.integer], end: NDArray[np.integer]) -> bool:
    """Return whether all cells on the straight line between two cells are free; the first one need not be."""
    count = 2 * int(np.abs(end - start).max()) + 1
    shares = np.linspace(0.0, 1.0, count)[:, None]
    cells = np.rint(start + shares * (end - start)).astype(np.int32)
    return bool(free[cells[1:, 0], cells[1:, 1]].all())


def _looks(first: int, last: int, step_cells: int) -> NDArray[np.int64]:
    """Return the indices of the path's cells to look at, a step apart, the last one included if it is not too far."""
    end = min(last, first + _SIGHT_STEPS * step_cells)
    return np.append(np.arange(first, end, step_cells), end)
