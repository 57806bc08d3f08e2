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

Queue = tuple[NDArray[np.int32], NDArray[np.int64]]
"""(_BUCKETS, room) the cells that wait in each bucket, and (_BUCKETS,) how many do."""

_BUCKETS = 64
_LAST_BUCKET = _BUCKETS - 1
_ROOM = 1024
_SHUT = -1
_NOTHING = np.int64(-1)
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
    away. What is shut costs less than any way to it, so that one comparison leaves it and the settled cells out.
    """
    rows, columns = free.shape
    ground, costs = _rimmed(free, prices, targets)
    queue, sizes = _queue_of(sources, costs)
    cost, found, is_full = _settle(ground, costs, columns + 2 * _RIM, queue, sizes, 0)
    while is_full:
        queue = _roomier(queue)
        cost, found, is_full = _settle(ground, costs, columns + 2 * _RIM, queue, sizes, cost)
    inside = _without_rim(costs, rows, columns)
    if found < 0:
        return inside, -1, -1
    return inside, found // (columns + 2 * _RIM) - _RIM, found % (columns + 2 * _RIM) - _RIM


@njit(cache=True, nogil=True)
def _queue_of(sources: Mask, costs: NDArray[np.int32]) -> Queue:  # pragma: no cover
    """Return the queue in which the sources wait, and mark that they cost nothing."""
    rows, columns = sources.shape
    queue = np.empty((_BUCKETS, _ROOM + sources.sum()), dtype=np.int32)
    sizes = np.zeros(_BUCKETS, dtype=np.int64)
    for row in range(rows):
        for column in range(columns):
            if sources[row, column]:
                cell = (row + _RIM) * (columns + 2 * _RIM) + column + _RIM
                costs[cell] = 0
                queue[0, sizes[0]] = cell
                sizes[0] += 1
    return queue, sizes


@njit(cache=True, nogil=True)
def _roomier(queue: NDArray[np.int32]) -> NDArray[np.int32]:  # pragma: no cover
    """Return the queue with twice the room in each bucket."""
    larger = np.empty((_BUCKETS, 2 * queue.shape[1]), dtype=np.int32)
    larger[:, : queue.shape[1]] = queue
    return larger


@njit(cache=True, nogil=True)
def _settle(
    ground: NDArray[np.uint8],
    costs: NDArray[np.int32],
    width: int,
    queue: NDArray[np.int32],
    sizes: NDArray[np.int64],
    cost: int,
) -> tuple[int, np.int64, bool]:  # pragma: no cover
    """Settle the cells that wait from a cost on; return the cost, the target found or -1, and whether there is no room.

    A cell to which a cheaper way is found waits once more, and is passed over where its cost is not that of the bucket
    any more. Where a bucket is full, the cell at hand goes back into its own: to go on from there finds the same.
    """
    offsets, passed = _offsets(width)
    empty_in_a_row = 0
    while empty_in_a_row < _BUCKETS:
        bucket = np.uint64(cost & _LAST_BUCKET)
        empty_in_a_row = empty_in_a_row + 1 if sizes[bucket] == 0 else 0
        while sizes[bucket] > 0:
            sizes[bucket] -= 1
            cell = np.uint64(queue[bucket, sizes[bucket]])
            if costs[cell] != cost:
                continue
            if ground[cell] & _TARGET:
                return cost, np.int64(cell), False
            for k in range(16):
                neighbour = cell + offsets[k]
                known = costs[neighbour]
                if cost + _WEIGHTS[k] >= known:
                    continue
                reached = cost + _WEIGHTS[k] * (ground[neighbour] & _PRICE)
                if reached >= known or not _may_pass(ground, cell + passed[k, 0], cell + passed[k, 1], k):
                    continue
                later = np.uint64(reached & _LAST_BUCKET)
                if sizes[later] == queue.shape[1]:
                    sizes[bucket] += 1
                    return cost, _NOTHING, True
                costs[neighbour] = reached
                queue[later, sizes[later]] = neighbour
                sizes[later] += 1
        cost += 1
    return cost, _NOTHING, False


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
