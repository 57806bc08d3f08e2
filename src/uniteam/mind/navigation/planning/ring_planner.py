"""HomeRobot's discrete planner: down the distance field, by the best cell of a ring of five cells.

Where no cell of the ring is nearer to the goal than the robot, there is "no path": the collision cells are cleared, and
obstacles are dilated by one cell less for the rest of the episode (arXiv 2306.11565). The distances are those of
`distance_field`, within 1 % of the fast marching that HomeRobot uses.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.grid import Cell, Mask, grown
from uniteam.interface import DiscreteAction
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal
from uniteam.mind.navigation.planning.distance_field import (
    COST_PER_CELL,
    SearchResult,
    alike,
    costs_to,
    costs_to_metres,
    nearer_than,
    trace_path,
)
from uniteam.mind.navigation.planning.plan import Plan
from uniteam.mind.navigation.planning.planner import Planner
from uniteam.mind.navigation.planning.planner_config import PlannerConfig, turn_in_steps
from uniteam.mind.navigation.window import Window, window_around

STEEPEST = 1.5
"""A cell whose distance is less by more than so many times its own distance lies behind a wall."""


@dataclass(frozen=True)
class _Field:
    """The costs of the ways to some places, exact as far as they are no more than those of the robot's.

    Attributes:
        free, places: (H, W) bool, see `costs_to`.
        robot: the (row, column) up to which it was searched.
        costs: (H, W), see `costs_to`.
    """

    free: Mask
    places: Mask
    robot: Cell
    costs: NDArray[np.int32]

    def of(self, free: Mask, places: Mask, robot: Cell) -> "_Field":
        """Return the field of a search; this one where it holds all that the robot asks of it: it is often blocked."""
        is_same = np.array_equal(self.free, free) and np.array_equal(self.places, places)
        if is_same and self.costs[robot] <= self.costs[self.robot]:
            return self
        return _Field(free, places, robot, costs_to(free, places, robot))


class RingPlanner(Planner):
    """Plans as HomeRobot does; beside the last motion it remembers how often there was no path."""

    def __init__(self, config: PlannerConfig | None = None) -> None:
        """Begin without a past."""
        super().__init__(config)
        self._shrunk = 0
        self._gave_way_at = -1
        nothing = np.zeros((1, 1), dtype=np.bool_)
        self._last = _Field(nothing, nothing, (0, 0), nothing.astype(np.int32))

    @property
    def dilation(self) -> int:
        """By how many cells obstacles grow now."""
        return self.config.dilations[min(self._shrunk, len(self.config.dilations) - 1)]

    def plan(self, bird_map: BirdsEyeMap, base: BasePose, goal: Goal) -> Plan:
        """Return the next step towards a goal; nothing is changed by asking. Takes what `Planner.plan` does."""
        window = window_around(bird_map, base, goal.cells)
        robot = window.inside(bird_map.to_cell(base.x, base.y))
        free = self._passable(bird_map, window, robot)
        places = self._places(free, window.cut(goal.cells), goal, bird_map.cell_size)
        if goal.shunned is not None:
            places &= ~window.cut(goal.shunned)
        self._last = self._last.of(free, places, robot)
        costs = self._last.costs
        distance = float(costs_to_metres(costs[robot][None], bird_map.cell_size)[0])
        is_there = distance <= self.config.tolerance
        step, descends = best_on_ring(costs, robot, self.config.step_cells)
        action, ahead = None, None
        if is_there and goal.face is not None:
            action = self.turn_to_face(bird_map, base, goal)
        else:
            ahead = _point(base, step, bird_map.cell_size)
            action = turn_in_steps(base.bearing_to(*ahead)) or DiscreteAction.MOVE_FORWARD
        cells = _path(free, costs, robot) if np.isfinite(distance) else np.array([robot])
        path = bird_map.to_points(window.outside(cells))
        is_reachable = is_there or descends
        length = distance if np.isfinite(distance) else 0.0
        points = bird_map.points_of(goal.cells)
        return Plan(action, action is None, is_reachable, False, length, ahead, path, points, bool(places.any()))

    def begin(self, plan: Plan, bird_map: BirdsEyeMap, base: BasePose) -> None:
        """Take a plan for the one that is carried out; where it has no path, this is taken note of."""
        if not plan.reachable:
            self.give_way(bird_map)
        super().begin(plan, bird_map, base)

    def give_way(self, bird_map: BirdsEyeMap) -> None:
        """Dilate obstacles by less from now on; once on a map, however often it is said."""
        if self._gave_way_at != bird_map.update_count:
            self._gave_way_at = bird_map.update_count
            self._shrunk += 1
            super().give_way(bird_map)

    def _passable(self, bird_map: BirdsEyeMap, window: Window, robot: Cell) -> Mask:
        """Return the window's free cells: neither near an obstacle nor a collision, or visited, or under the robot."""
        blocked = grown(window.cut(bird_map.obstacle), self.dilation)
        felt = grown(window.cut(bird_map.felt), self.dilation)
        free = ~(blocked | window.cut(bird_map.collision)) | window.cut(bird_map.visited) & ~felt
        own = self.config.own_cells
        row, column = robot
        free[max(0, row - own) : row + own + 1, max(0, column - own) : column + own + 1] = True
        return free

    def _places(self, free: Mask, cells: Mask, goal: Goal, cell_size: float) -> Mask:
        """Return the free cells near to the goal's but not on them; those on it where nothing else is asked for."""
        if goal.distance == 0.0:
            return free & cells
        beside = free & ~cells
        places = beside & nearer_than(goal.distance, cells, cell_size)
        if not places.any():
            farthest = goal.distance + max(self.config.patience, default=0.0)
            places = beside & nearer_than(farthest, cells, cell_size)
        return places


def plan_by_ring(config: PlannerConfig) -> Planner:
    """Return a new planner of HomeRobot's kind."""
    return RingPlanner(config)


def best_on_ring(costs: NDArray[np.int32], robot: Cell, radius: int) -> tuple[Cell, bool]:
    """Return the step (rows, columns) to the cell of least cost on a ring around the robot, and whether it is less."""
    best, least = (0, 0), np.inf
    for row, column, steepest in _ring(radius):
        r, k = robot[0] + row, robot[1] + column
        if 0 <= r < costs.shape[0] and 0 <= k < costs.shape[1]:
            rise = float(costs[r, k]) - float(costs[robot])
            if -steepest <= rise < least:
                best, least = (row, column), rise
    return best, least < 0.0


@lru_cache(maxsize=8)
def _ring(radius: int) -> tuple[tuple[int, int, float], ...]:
    """Return the ring's cells (rows, columns from the robot) and the robot's own, row by row: the first of equals wins.

    With each goes by how much its cost may be less at most. The ring is half a cell off, as HomeRobot's is.
    """
    cells = []
    for row in range(-radius, radius + 1):
        for column in range(-radius, radius + 1):
            away = float(np.hypot(row + 0.5, column + 0.5))
            if radius - 1 < away <= radius or (row, column) == (0, 0):
                cells.append((row, column, STEEPEST * max(5.0, away) * COST_PER_CELL))
    return tuple(cells)


def _point(base: BasePose, step: Cell, cell_size: float) -> tuple[float, float]:
    """Return the point (m, start frame) of a step in cells; the start frame's x axis where the step leads nowhere."""
    row, column = step if step != (0, 0) else (0, 1)
    return base.x + column * cell_size, base.y + row * cell_size


def _path(free: Mask, costs: NDArray[np.int32], robot: Cell) -> NDArray[np.int32]:
    """Return the (P, 2) cells from the robot down to the nearest place."""
    return trace_path(free, alike(free), SearchResult(costs, robot), robot)[::-1]
