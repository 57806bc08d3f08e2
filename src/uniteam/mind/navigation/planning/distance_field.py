"""Distances over a grid with obstacles: a bucket queue with integer weights over sixteen neighbours.

A step to a side costs 5, to a corner 7, a knight's move 11 (the chamfer weights of Borgefors, "Distance transformations
in digital images", 1986); a bucket for each remainder of the cost makes the queue (Dial, "Algorithm 360", 1969). A
corner step needs one of the two cells beside it free, a knight's move both of the cells it passes: no path slips
through a wall that is one cell thick. A cell may have a price, by which the steps into it are multiplied.
"""

from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.grid import Cell, Mask

COST_PER_CELL = 5.025
"""Cost of one cell's length: a little over 5 weighs the errors in the open, where most directions come out too long,
against those behind corners. Distances are then 1 % off in the mean."""

HIGHEST_PRICE = 5
"""Of a cell: more would need more buckets."""

_BUCKETS = 64
_FAR = 1 << 30
_SIDES = ((0, 1), (1, 0), (0, -1), (-1, 0))
_CORNERS = ((1, 1), (1, -1), (-1, -1), (-1, 1))
_KNIGHTS = ((1, 2), (2, 1), (2, -1), (1, -2), (-1, -2), (-2, -1), (-2, 1), (-1, 2))
_STEPS = np.array((*_SIDES, *_CORNERS, *_KNIGHTS), dtype=np.int32)
_WEIGHTS = np.array([5] * 4 + [7] * 4 + [11] * 8, dtype=np.int32)


class SearchResult(NamedTuple):
    """What a search found.

    Attributes:
        costs: (H, W) int32, in units of `cell_size / COST_PER_CELL`; `1 << 30` where it did not come.
        target: (row, column) of the nearest target, or (-1, -1).
    """

    costs: NDArray[np.int32]
    target: Cell


@njit(cache=True, nogil=True)
def _spread(
    free: Mask, prices: NDArray[np.uint8], sources: Mask, targets: Mask
) -> tuple[NDArray[np.int32], int, int]:  # pragma: no cover
    """Spread from the sources over free cells until a target is settled; return costs and the target or (-1, -1).

    Every cell is in at most one bucket, a doubly linked list through `after` and `before`.
    """
    rows, columns = free.shape
    costs = np.full((rows, columns), _FAR, dtype=np.int32)
    after = np.empty(rows * columns, dtype=np.int32)
    before = np.empty(rows * columns, dtype=np.int32)
    heads = np.full(_BUCKETS, -1, dtype=np.int32)
    waiting = 0
    for cell in range(rows * columns):
        row, column = cell // columns, cell % columns
        if sources[row, column]:
            costs[row, column] = 0
            before[cell], after[cell] = -1, heads[0]
            if heads[0] >= 0:
                before[heads[0]] = cell
            heads[0] = cell
            waiting += 1
    cost = 0
    while waiting > 0:
        bucket = cost % _BUCKETS
        while heads[bucket] >= 0:
            cell = heads[bucket]
            heads[bucket] = after[cell]
            if after[cell] >= 0:
                before[after[cell]] = -1
            waiting -= 1
            row, column = cell // columns, cell % columns
            if targets[row, column]:
                return costs, row, column
            for k in range(16):
                r, c = row + _STEPS[k, 0], column + _STEPS[k, 1]
                if r < 0 or c < 0 or r >= rows or c >= columns or not free[r, c]:
                    continue
                reached = cost + _WEIGHTS[k] * prices[r, c]
                known = costs[r, c]
                if reached >= known or not _may_step(free, row, column, k):
                    continue
                neighbour = r * columns + c
                if known < _FAR:
                    if before[neighbour] >= 0:
                        after[before[neighbour]] = after[neighbour]
                    else:
                        heads[known % _BUCKETS] = after[neighbour]
                    if after[neighbour] >= 0:
                        before[after[neighbour]] = before[neighbour]
                else:
                    waiting += 1
                costs[r, c] = reached
                head = heads[reached % _BUCKETS]
                before[neighbour], after[neighbour] = -1, head
                if head >= 0:
                    before[head] = neighbour
                heads[reached % _BUCKETS] = neighbour
        cost += 1
    return costs, -1, -1


@njit(cache=True, nogil=True)
def _may_step(free: Mask, row: int, column: int, k: int) -> bool:  # pragma: no cover
    """Whether the k-th step from a cell to a free cell of the grid passes between obstacles."""
    dr, dc = _STEPS[k, 0], _STEPS[k, 1]
    if k < 4:
        return True
    if k < 8:
        return free[row + dr, column] or free[row, column + dc]
    if abs(dr) == 2:
        return free[row + dr // 2, column] and free[row + dr // 2, column + dc]
    return free[row, column + dc // 2] and free[row + dr, column + dc // 2]


@njit(cache=True, nogil=True)
def _descend(
    free: Mask, prices: NDArray[np.uint8], costs: NDArray[np.int32], row: int, column: int
) -> NDArray[np.int32]:  # pragma: no cover
    """Follow the costs from a cell down to a source; return the (P, 2) cells passed, the source first."""
    path = np.empty((costs[row, column] // 5 + 1, 2), dtype=np.int32)
    length = 0
    while True:
        path[length, 0], path[length, 1] = row, column
        length += 1
        if costs[row, column] == 0:
            return path[:length][::-1].copy()
        price = prices[row, column]
        for k in range(15, -1, -1):
            r, c = row + _STEPS[k, 0], column + _STEPS[k, 1]
            inside = r >= 0 and c >= 0 and r < costs.shape[0] and c < costs.shape[1]
            if inside and costs[r, c] + _WEIGHTS[k] * price == costs[row, column] and _may_step(free, row, column, k):
                row, column = r, c
                break


def distance_field(free: Mask, sources: Mask, cell_size: float) -> NDArray[np.float32]:
    """Return the (H, W) length (m) of the shortest path over free cells from the nearest source; inf if there is none.

    Args:
        free: (H, W) bool, cells that may be passed. A source may stand on a blocked cell.
        sources: (H, W) bool.
        cell_size: m.
    """
    costs, _, _ = _spread(free, _alike(free), sources, np.zeros_like(free))
    return costs_to_metres(costs, cell_size)


def nearest_target(free: Mask, prices: NDArray[np.uint8], start: Cell, targets: Mask) -> SearchResult:
    """Search from a cell until the first target is reached; cells beyond it stay unsearched.

    Args:
        free: (H, W) bool, cells that may be passed.
        prices: (H, W), from 1 to `HIGHEST_PRICE`, by which the steps into a cell are multiplied.
        start: (row, column) on the grid; may itself be blocked.
        targets: (H, W) bool; blocked ones are never reached.
    """
    sources = np.zeros_like(free)
    sources[start] = True
    costs, row, column = _spread(free, prices, sources, targets)
    return SearchResult(costs, (row, column))


def costs_to(free: Mask, sources: Mask, cell: Cell) -> NDArray[np.int32]:
    """Return the (H, W) costs (`SearchResult`) of the ways to the nearest source, where they are less than a cell's."""
    until = np.zeros_like(free)
    until[cell] = True
    return _spread(free, _alike(free), sources, until)[0]


def trace_path(free: Mask, prices: NDArray[np.uint8], reach: SearchResult, cell: Cell) -> NDArray[np.int32]:
    """Return the (P, 2) cells (row, column) of the path from a search's start to a cell that it reached, inclusive."""
    return _descend(free, prices, reach.costs, cell[0], cell[1])


def path_length(path: NDArray[np.int32], cell_size: float) -> float:
    """Return the length (m) of a path of (P, 2) cells, whatever the prices on it."""
    steps = np.sort(np.abs(np.diff(path, axis=0)), axis=1)
    weights = np.where(steps[:, 0] == 0, 5, np.where(steps[:, 1] == 1, 7, 11))
    return float(costs_to_metres(weights.sum(keepdims=True, dtype=np.int32), cell_size)[0])


def costs_to_metres(costs: NDArray[np.int32], cell_size: float) -> NDArray[np.float32]:
    """Return integer costs as metres; inf where the search did not come."""
    metres = costs * np.float32(cell_size / COST_PER_CELL)
    return np.where(costs >= _FAR, np.float32(np.inf), metres).astype(np.float32)


def _alike(free: Mask) -> NDArray[np.uint8]:
    return np.ones(free.shape, dtype=np.uint8)
