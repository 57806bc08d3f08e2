"""Distances over a grid with obstacles: a bucket queue with integer weights over sixteen neighbours.

A step to a side costs 5, to a corner 7, a knight's move 11 (the chamfer weights of Borgefors, "Distance transformations
in digital images", 1986); a bucket for each remainder of the cost makes the queue (Dial, "Algorithm 360", 1969). A
corner step needs one of the two cells beside it free, a knight's move both of the cells it passes: no path slips
through a wall that is one cell thick. A cell may have a price, by which the steps into it are multiplied.
"""

import math
from functools import lru_cache
from typing import NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.grid import Cell, Mask, grown_by_rows
from uniteam.mind.navigation.planning.bucket_queue import FAR, descend, spread

COST_PER_CELL = 5.025
"""Cost of one cell's length: a little over 5 weighs the errors in the open, where most directions come out too long,
against those behind corners. Distances are then 1 % off in the mean."""


class SearchResult(NamedTuple):
    """What a search found.

    Attributes:
        costs: (H, W) int32, in units of `cell_size / COST_PER_CELL`; `FAR` where it did not come.
        target: (row, column) of the nearest target, or (-1, -1).
    """

    costs: NDArray[np.int32]
    target: Cell


def distance_field(free: Mask, sources: Mask, cell_size: float) -> NDArray[np.float32]:
    """Return the (H, W) length (m) of the shortest path over free cells from the nearest source; inf if there is none.

    Args:
        free: (H, W) bool, cells that may be passed. A source may stand on a blocked cell.
        sources: (H, W) bool.
        cell_size: m.
    """
    costs, _, _ = spread(free, alike(free), sources, np.zeros_like(free))
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
    costs, row, column = spread(free, prices, sources, targets)
    return SearchResult(costs, (row, column))


def costs_to(free: Mask, sources: Mask, cell: Cell) -> NDArray[np.int32]:
    """Return the (H, W) costs (`SearchResult`) of the ways to the nearest source, where they are less than a cell's."""
    until = np.zeros_like(free)
    until[cell] = True
    return spread(free, alike(free), sources, until)[0]


def trace_path(free: Mask, prices: NDArray[np.uint8], reach: SearchResult, cell: Cell) -> NDArray[np.int32]:
    """Return the (P, 2) cells (row, column) of the path from a search's start to a cell that it reached, inclusive."""
    return descend(free, prices, reach.costs, cell[0], cell[1])


def path_length(path: NDArray[np.int32], cell_size: float) -> float:
    """Return the length (m) of a path of (P, 2) cells, whatever the prices on it."""
    steps = np.sort(np.abs(np.diff(path, axis=0)), axis=1)
    weights = np.where(steps[:, 0] == 0, 5, np.where(steps[:, 1] == 1, 7, 11))
    return float(costs_to_metres(weights.sum(keepdims=True, dtype=np.int32), cell_size)[0])


def costs_to_metres(costs: NDArray[np.int32], cell_size: float) -> NDArray[np.float32]:
    """Return integer costs as metres; inf where the search did not come."""
    metres = costs * np.float32(cell_size / COST_PER_CELL)
    return np.where(costs >= FAR, np.float32(np.inf), metres).astype(np.float32)


def alike(free: Mask) -> NDArray[np.uint8]:
    """Return the same price, 1, for all (H, W) cells."""
    return np.ones(free.shape, dtype=np.uint8)


def straight_distance(cells: Mask, cell_size: float, farthest: float = math.inf) -> NDArray[np.float32]:
    """Return each cell's distance (m) to the nearest of some cells, through everything; inf where there is none.

    It may also be inf where it is more than `farthest` (m): far from the cells it is not looked for.
    """
    distances = np.full(cells.shape, np.inf, dtype=np.float32)
    x, y, width, height = cv2.boundingRect(cells.view(np.uint8))
    if width == 0:
        return distances
    more = math.ceil(min(farthest / cell_size, max(cells.shape))) + 1
    box = slice(max(0, y - more), y + height + more), slice(max(0, x - more), x + width + more)
    in_cells = cv2.distanceTransform((~cells[box]).view(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_5)
    np.multiply(in_cells, np.float32(cell_size), out=distances[box])
    return distances


def nearer_than(distance: float, cells: Mask, cell_size: float) -> Mask:
    """Return the (H, W) cells whose `straight_distance` to some cells is less than a distance (m)."""
    return grown_by_rows(cells, _half_widths(distance, cell_size))


@lru_cache(maxsize=16)
def _half_widths(distance: float, cell_size: float) -> tuple[int, ...]:
    """Return how far what is nearer than a distance reaches in the rows of one cell, its own row first."""
    reach = math.ceil(distance / cell_size) + 1
    one = np.zeros((2 * reach + 1, 2 * reach + 1), dtype=np.bool_)
    one[reach, reach] = True
    rows = (straight_distance(one, cell_size) < distance)[reach:].sum(axis=1)
    return tuple(int(cells) // 2 for cells in rows if cells > 0)
