"""The search of `distance_field`: cells wait in a bucket for each remainder of their cost, and leave it the last first.

A bucket for each remainder makes the queue of Dial, "Algorithm 360" (1969).
"""

import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.grid import Mask

HIGHEST_PRICE = 5
"""Of a cell: more would need more buckets."""
FAR = 1 << 30
"""The cost of a cell to which the search did not come."""

_BUCKETS = 64
_LAST_BUCKET = _BUCKETS - 1
_SHUT = -1
_RIM = 2
_PRICE, _TARGET = 7, 8  # of a cell's ground: a mask for the price, and a bit
_SIDES = ((0, 1), (1, 0), (0, -1), (-1, 0))
_CORNERS = ((1, 1), (1, -1), (-1, -1), (-1, 1))
_KNIGHTS = ((1, 2), (2, 1), (2, -1), (1, -2), (-1, -2), (-2, -1), (-2, 1), (-1, 2))
_STEPS = np.array((*_SIDES, *_CORNERS, *_KNIGHTS), dtype=np.int32)
_WEIGHTS = np.array([5] * 4 + [7] * 4 + [11] * 8, dtype=np.int32)


@njit(cache=True, nogil=True)
def spread(
    free: Mask, prices: NDArray[np.uint8], sources: Mask, targets: Mask
) -> tuple[NDArray[np.int32], int, int]:  # pragma: no cover
    """Spread from the sources over free cells until a target is settled; return costs and the target or (-1, -1).

    The grid has a rim that no step leads beyond, and cells are numbered row by row, so that a neighbour is an offset
    away. What is shut costs less than any way to it, so that one comparison leaves it and the settled cells out. Every
    cell is in at most one bucket, a doubly linked list through `after` and `before`.
    """
    rows, columns = free.shape
    width = columns + 2 * _RIM
    ground, costs = _rimmed(free, prices, targets)
    offsets, passed = _offsets(width)
    after = np.empty(costs.size, dtype=np.int32)
    before = np.empty(costs.size, dtype=np.int32)
    heads = np.full(_BUCKETS, -1, dtype=np.int32)
    waiting, cost, found = 0, 0, np.int64(-1)
    for row in range(rows):
        for column in range(columns):
            if sources[row, column]:
                cell = np.uint64((row + _RIM) * width + column + _RIM)
                costs[cell] = 0
                _put_in(cell, np.uint64(0), heads, after, before)
                waiting += 1
    while waiting > 0 and found < 0:
        bucket = np.uint64(cost & _LAST_BUCKET)
        while heads[bucket] >= 0:
            cell = np.uint64(heads[bucket])
            heads[bucket] = after[cell]
            if after[cell] >= 0:
                before[np.uint64(after[cell])] = -1
            waiting -= 1
            if ground[cell] & _TARGET:
                found = np.int64(cell)
                break
            for k in range(16):
                neighbour = cell + offsets[k]
                known = costs[neighbour]
                if cost + _WEIGHTS[k] >= known:
                    continue
                reached = cost + _WEIGHTS[k] * (ground[neighbour] & _PRICE)
                if reached >= known or not _may_pass(ground, cell + passed[k, 0], cell + passed[k, 1], k):
                    continue
                if known < FAR:
                    _take_out(neighbour, np.uint64(known & _LAST_BUCKET), heads, after, before)
                else:
                    waiting += 1
                costs[neighbour] = reached
                _put_in(neighbour, np.uint64(reached & _LAST_BUCKET), heads, after, before)
        cost += 1
    inside = _without_rim(costs, rows, columns)
    if found < 0:
        return inside, -1, -1
    return inside, found // width - _RIM, found % width - _RIM


@njit(cache=True, nogil=True)
def _rimmed(
    free: Mask, prices: NDArray[np.uint8], targets: Mask
) -> tuple[NDArray[np.uint8], NDArray[np.int32]]:  # pragma: no cover
    """Return the cells with a rim, flat: their prices with `_TARGET`, 0 what is shut; and the costs of a search."""
    rows, columns = free.shape
    width = columns + 2 * _RIM
    ground = np.zeros((rows + 2 * _RIM) * width, dtype=np.uint8)
    costs = np.full(ground.size, _SHUT, dtype=np.int32)
    for row in range(rows):
        start = (row + _RIM) * width + _RIM
        for column in range(columns):
            if free[row, column]:
                ground[start + column] = prices[row, column]
                costs[start + column] = FAR
            if targets[row, column]:
                ground[start + column] |= _TARGET
    return ground, costs


@njit(cache=True, nogil=True)
def _without_rim(costs: NDArray[np.int32], rows: int, columns: int) -> NDArray[np.int32]:  # pragma: no cover
    """Return the (H, W) costs of the cells; what is shut is far."""
    width = columns + 2 * _RIM
    inside = np.empty((rows, columns), dtype=np.int32)
    for row in range(rows):
        start = (row + _RIM) * width + _RIM
        for column in range(columns):
            cost = costs[start + column]
            inside[row, column] = FAR if cost == _SHUT else cost
    return inside


@njit(cache=True, nogil=True)
def _offsets(width: int) -> tuple[NDArray[np.uint64], NDArray[np.uint64]]:  # pragma: no cover
    """Return how far away the neighbours are, (16,), and the two cells that each step passes, (16, 2)."""
    offsets, passed = np.zeros(16, dtype=np.uint64), np.zeros((16, 2), dtype=np.uint64)
    for k in range(16):
        dr, dc = np.int64(_STEPS[k, 0]), np.int64(_STEPS[k, 1])
        if abs(dr) == 2:
            first, second = dr // 2 * width, dr // 2 * width + dc
        elif abs(dc) == 2:
            first, second = dc // 2, dr * width + dc // 2
        else:
            first, second = dr * width, dc
        offsets[k], passed[k, 0], passed[k, 1] = np.uint64(dr * width + dc), np.uint64(first), np.uint64(second)
    return offsets, passed


@njit(cache=True, nogil=True)
def _may_pass(ground: NDArray[np.uint8], cell: np.uint64, other: np.uint64, k: int) -> bool:  # pragma: no cover
    """Return whether the k-th step leads between obstacles, by the two cells that it passes."""
    is_free, other_is_free = ground[cell] & _PRICE > 0, ground[other] & _PRICE > 0
    return k < 4 or (is_free or other_is_free if k < 8 else is_free and other_is_free)


@njit(cache=True, nogil=True)
def _put_in(
    cell: np.uint64, bucket: np.uint64, heads: NDArray[np.int32], after: NDArray[np.int32], before: NDArray[np.int32]
) -> None:  # pragma: no cover
    """Put a cell first in a bucket."""
    head = heads[bucket]
    before[cell], after[cell] = -1, head
    if head >= 0:
        before[np.uint64(head)] = cell
    heads[bucket] = cell


@njit(cache=True, nogil=True)
def _take_out(
    cell: np.uint64, bucket: np.uint64, heads: NDArray[np.int32], after: NDArray[np.int32], before: NDArray[np.int32]
) -> None:  # pragma: no cover
    """Take a cell out of its bucket."""
    one_before, one_after = before[cell], after[cell]
    if one_before >= 0:
        after[np.uint64(one_before)] = one_after
    else:
        heads[bucket] = one_after
    if one_after >= 0:
        before[np.uint64(one_after)] = one_before


@njit(cache=True, nogil=True)
def _may_step(free: Mask, row: int, column: int, k: int) -> bool:  # pragma: no cover
    """Return whether the k-th step from a cell to a free cell of the grid passes between obstacles."""
    dr, dc = _STEPS[k, 0], _STEPS[k, 1]
    if k < 4:
        return True
    if k < 8:
        return free[row + dr, column] or free[row, column + dc]
    if abs(dr) == 2:
        return free[row + dr // 2, column] and free[row + dr // 2, column + dc]
    return free[row, column + dc // 2] and free[row + dr, column + dc // 2]


@njit(cache=True, nogil=True)
def descend(
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
