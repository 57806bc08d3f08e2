"""Paths over a home's navigable floor, for those who know it: the oracle and the certification.

A field of costs from a goal by Dijkstra's algorithm on every second cell of the floor's grid, 8 neighbours; cells near
obstacles cost more, so that paths keep to the middle where there is room. A path is the descent of that field, pulled
tight with swept moves of the base.
"""

import heapq
import math
from collections.abc import Iterable

import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.geometry import BasePose, Point2
from uniteam.stretch import BASE_RADIUS
from uniteam.world.physics.navigable_floor import CELL_SIZE, NavigableFloor

_STRIDE = 2
_COMFORTABLE_CLEARANCE = 0.5
_CROWDING_COST = 3.0
_KEPT_CLEARANCE = 0.42
_SHORTEST_LEG = 0.15


class PathField:
    """The way to one goal from everywhere on a floor."""

    def __init__(self, floor: NavigableFloor, goal: Point2) -> None:
        """Compute the field of a goal (x, y) (m, world), which must be free."""
        self._floor = floor
        self._goal = goal
        self._costs = _costs_to(floor.cells, *floor.to_cell(*goal), np.float32(BASE_RADIUS))

    @property
    def costs(self) -> NDArray[np.float32]:
        """(R, C) float32: of the ways from the floor's cells to the goal (m of comfortable driving).

        They are infinite where there is no way, and on the cells that lie between those of the search.
        """
        return self._costs

    def path_from(self, x: float, y: float) -> list[Point2]:
        """Return the points (m, world) to drive straight to, one after the other, the goal last; none without a way."""
        start = self._nearest_node(x, y)
        if start is None:
            return []
        points = [self._floor.to_point(*cell) for cell in self._descent(start)[:-1]]
        return self._pulled_tight((x, y), [*points, self._goal])

    def _nearest_node(self, x: float, y: float) -> tuple[int, int] | None:
        """Return the cheapest of the nodes that the base reaches straight from a point, if there is one."""
        row, column = self._floor.to_cell(x, y)
        reach = range(-3, 4)
        base = BasePose(x, y, 0.0)
        rows, columns = self._costs.shape
        nodes = [(row + i, column + j) for i in reach for j in reach]
        nodes = [(r, c) for r, c in nodes if 0 <= r < rows and 0 <= c < columns and np.isfinite(self._costs[r, c])]
        nodes.sort(key=lambda node: float(self._costs[node]))
        return next((node for node in nodes if self._floor.sweep(base, *self._floor.to_point(*node))), None)

    def _descent(self, node: tuple[int, int]) -> list[tuple[int, int]]:
        path = [node]
        while self._costs[node] > 0.0:
            steps = [(node[0] + i * _STRIDE, node[1] + j * _STRIDE) for i in (-1, 0, 1) for j in (-1, 0, 1)]
            node = min(steps, key=lambda step: float(self._costs[step]))
            if self._costs[node] >= self._costs[path[-1]]:
                break
            path.append(node)
        return path

    def _pulled_tight(self, start: Point2, points: list[Point2]) -> list[Point2]:
        tight: list[Point2] = []
        here, i = start, 0
        while i < len(points):
            farthest = i
            while farthest + 1 < len(points) and self._is_good_shortcut(here, points[i : farthest + 2]):
                farthest += 1
            here, i = points[farthest], farthest + 1
            tight.append(here)
        return tight

    def _is_good_shortcut(self, here: Point2, points: list[Point2]) -> bool:
        """Return whether the base may go straight to the last point: it comes no nearer to things, or moves little."""
        if not self._floor.sweep(BasePose(*here, 0.0), *points[-1]):
            return False
        if math.dist(here, points[-2]) < _SHORTEST_LEG:
            return True
        way = np.linspace(here, points[-1], 2 + int(math.dist(here, points[-1]) / CELL_SIZE))
        return self._least_clearance(way) >= min(_KEPT_CLEARANCE, self._least_clearance(points) - CELL_SIZE)

    def _least_clearance(self, points: Iterable[Iterable[float]]) -> float:
        rows, columns = np.array([self._floor.to_cell(*point) for point in points]).T
        return float(self._floor.cells[rows, columns].min())


@njit(cache=True, nogil=True)
def _costs_to(cells: NDArray[np.float32], goal_row: int, goal_column: int, radius: np.float32) -> NDArray[np.float32]:
    """Return the cost (m of comfortable driving) from every node; infinite where there is no way."""
    rows, columns = cells.shape
    costs = np.full(cells.shape, np.inf, np.float32)
    costs[goal_row, goal_column] = 0.0
    heap = [(np.float32(0.0), goal_row, goal_column)]
    while len(heap) > 0:
        cost, row, column = heapq.heappop(heap)
        if cost > costs[row, column]:
            continue
        for i in range(-1, 2):
            for j in range(-1, 2):
                r, c = row + i * _STRIDE, column + j * _STRIDE
                if r < 0 or c < 0 or r >= rows or c >= columns:
                    continue
                if cells[r, c] < radius or cells[row + i, column + j] < radius:
                    continue
                crowding = max(0.0, _COMFORTABLE_CLEARANCE - cells[r, c])
                step = 0.04 * np.sqrt(i * i + j * j) * (1.0 + _CROWDING_COST * crowding / _COMFORTABLE_CLEARANCE)
                reached = np.float32(cost + step)
                if reached < costs[r, c]:
                    costs[r, c] = reached
                    heapq.heappush(heap, (reached, r, c))
    return costs
