"""From a goal on the map to the next action along a path that is pulled straight (`string_pulled_path`).

As in HomeRobot's planner (`ring_planner`), obstacles are dilated, the short-term goal lies five cells ahead, and the
robot turns or drives towards it. Smaller dilations are tried within the step in which there is no path, not for good.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.grid import Cell, Mask
from uniteam.interface import ACTION_LIMITS, Action, BaseDisplacement, DiscreteAction
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal
from uniteam.mind.navigation.planning.clearance import Clearance
from uniteam.mind.navigation.planning.collision_mapping import (
    BlockedMotion,
)
from uniteam.mind.navigation.planning.distance_field import (
    SearchResult,
    nearest_target,
    path_length,
    straight_distance,
    trace_path,
)
from uniteam.mind.navigation.planning.plan import Plan
from uniteam.mind.navigation.planning.planner_config import PlannerConfig, Way
from uniteam.mind.navigation.planning.short_term_goal import find_short_term_goal
from uniteam.mind.navigation.planning.traversible import connected_to, traversible
from uniteam.mind.navigation.window import Window, window_around
from uniteam.stretch import BASE_RADIUS

_NEXT_CELLS = 5
BLOCKED_OFTEN = 3
"""Forward motions blocked one after the other; a way that three wider and wider marks on the map left open is none."""


@dataclass(frozen=True)
class _Route:
    """A search that found a place to stand: grids are the window's."""

    window: Window
    free: Mask
    clearance: Clearance
    prices: NDArray[np.uint8]
    reach: SearchResult
    reachable: bool
    is_daring: bool = False

    @property
    def cells(self) -> NDArray[np.int32]:
        """(P, 2) cells of the path, the robot's first."""
        return trace_path(self.free, self.prices, self.reach, self.reach.target)


@dataclass(frozen=True)
class _Motion:
    """The forward motion that the last plan asked for."""

    base: BasePose
    short_term_goal: tuple[float, float]
    length: float
    update_count: int


class Planner:
    """Plans one step at a time; it remembers only the last forward motion, to notice when it was blocked.

    In each step update the map, let the planner `notice` what became of its last motion, `plan` to as many goals as
    need be, and `begin` the plan that is carried out. Call `interrupt` when something else moves the robot in between.
    """

    def __init__(self, config: PlannerConfig | None = None) -> None:
        """Begin without a past."""
        self.config = config or PlannerConfig()
        self._motion: _Motion | None = None
        self._blocked_in_a_row = 0
        self._radius = BASE_RADIUS

    @property
    def blocked_in_a_row(self) -> int:
        """How many forward motions in a row have been blocked."""
        return self._blocked_in_a_row

    @property
    def is_blocked_often(self) -> bool:
        """Whether so many were blocked that the next will be blocked too."""
        return self._blocked_in_a_row >= BLOCKED_OFTEN

    def leads_on(self, plan: Plan) -> bool:
        """Return whether a plan gets the robot to its goal, or at least nearer."""
        return plan.reachable or (plan.action is not None and not self.is_blocked_often)

    def interrupt(self) -> None:
        """Forget the last motion: what the robot does next is not the planner's."""
        self._motion = None
        self._blocked_in_a_row = 0

    def carry(self, radius: float) -> None:
        """Keep so far (m) from obstacles from now on where there is a way that wide."""
        self._radius = radius

    def plan(self, bird_map: BirdsEyeMap, base: BasePose, goal: Goal) -> Plan:
        """Return the next step towards a goal; nothing is changed by asking.

        Args:
            bird_map: the map, updated with the present observation.
            base: the robot (start frame).
            goal: where to, made for the map's present shape.
        """
        route = self._find_route(bird_map, base, goal)
        cells = route.cells
        distance = path_length(cells, bird_map.cell_size)
        if distance > self.config.tolerance:
            ahead = find_short_term_goal(_in_sight(route, cells), cells, self.config.step_cells)
            short_term_goal = bird_map.to_point(*route.window.outside(np.array(ahead.cell)))
            straight = ahead.straight * bird_map.cell_size
            way = Way(short_term_goal, straight, route.clearance, bird_map, self._blocked_in_a_row)
            action: Action | None = self.config.stride(base, way) or self.config.move(base, way)
        else:
            short_term_goal = None
            action = self.turn_to_face(bird_map, base, goal)
        path = bird_map.to_points(route.window.outside(cells))
        goal_points = bird_map.points_of(goal.cells)
        return Plan(
            action, action is None, route.reachable, route.is_daring, distance, short_term_goal, path, goal_points
        )

    def begin(self, plan: Plan, bird_map: BirdsEyeMap, base: BasePose) -> None:
        """Take a plan, made on this map and from this base, for the one that is carried out."""
        if plan.is_daring:
            self.config.collisions.replan(bird_map)
        self._motion = None
        length = _length_of(plan.action)
        if length > 0 and plan.short_term_goal is not None:
            self._motion = _Motion(base, plan.short_term_goal, length, bird_map.update_count)

    def notice(self, bird_map: BirdsEyeMap, base: BasePose) -> None:
        """Write the motion that was begun in the last step into the map if it was blocked; a second call does nothing.

        Args:
            bird_map: the map, updated with the present observation.
            base: the robot (start frame).
        """
        motion = self._motion
        if motion is None or bird_map.update_count != motion.update_count + 1:
            return
        self._motion = None
        if motion.base.distance_to(base.x, base.y) >= self.config.blocked_below * motion.length:
            self._blocked_in_a_row = 0
            return
        self._blocked_in_a_row += 1
        if motion.length > ACTION_LIMITS.forward_step:  # nobody knows where on the way it was blocked
            return
        blocked = BlockedMotion(motion.base, motion.short_term_goal, self._blocked_in_a_row)
        if not self.config.spares(bird_map, blocked):
            self.config.collisions.write(bird_map, blocked, self.config.felt_at)

    def give_way(self, bird_map: BirdsEyeMap) -> None:
        """Take note that there is no path on a map."""
        self.config.collisions.replan(bird_map)

    def _find_route(self, bird_map: BirdsEyeMap, base: BasePose, goal: Goal) -> _Route:
        window = window_around(bird_map, base, goal.cells)
        robot = window.inside(bird_map.to_cell(base.x, base.y))
        to_goal = straight_distance(window.cut(goal.cells), bird_map.cell_size, max(self._distances(goal)))
        clearance = Clearance.of(bird_map, window)
        prices = self.config.price(clearance)
        shunned = np.zeros_like(to_goal, dtype=np.bool_) if goal.shunned is None else window.cut(goal.shunned)
        dilations = self._dilations(bird_map.cell_size)
        careful = self._free(bird_map, window, robot, dilations[0]) & ~window.cut(bird_map.collision)
        careful[robot] = True
        targets = self._targets(careful, robot, to_goal, shunned, goal)
        if targets is not None:
            return _Route(window, careful, clearance, prices, nearest_target(careful, prices, robot, targets), True)
        for dilation in dilations:
            free = self._free(bird_map, window, robot, dilation)
            targets = self._targets(free, robot, to_goal, shunned, goal)
            if targets is not None:
                reach = nearest_target(free, prices, robot, targets)
                return _Route(window, free, clearance, prices, reach, True, is_daring=True)
        to_goal = straight_distance(window.cut(goal.cells), bird_map.cell_size)
        nearest = np.where(connected_to(robot, careful), to_goal, np.inf)
        targets = nearest == nearest.min() if np.isfinite(nearest[robot]) else nearest < 0
        targets[robot] |= not targets.any()
        return _Route(window, careful, clearance, prices, nearest_target(careful, prices, robot, targets), False)

    def _free(self, bird_map: BirdsEyeMap, window: Window, robot: Cell, dilation: int) -> Mask:
        return traversible(bird_map, window, robot, dilation, self.config.own_cells)

    def _dilations(self, cell_size: float) -> tuple[int, ...]:
        """Return by how many cells obstacles grow, tried in this order: first by what the load sticks out more."""
        more = math.ceil((self._radius - BASE_RADIUS) / cell_size - 1e-6)
        first = self.config.dilations[0]
        return (*((first + more,) if more > 0 else ()), *self.config.dilations)

    def _targets(self, free: Mask, robot: Cell, to_goal: NDArray[np.float32], shunned: Mask, goal: Goal) -> Mask | None:
        """Return the free cells near enough to the goal to which there is a path, or None."""
        known = connected_to(robot, free) & ~shunned
        for distance in self._distances(goal):
            targets = (to_goal <= distance) & known
            if targets.any():
                return targets
        return None

    def _distances(self, goal: Goal) -> tuple[float, ...]:
        """Return how near to the goal is near enough, the asked for first."""
        more = (0.0, *self.config.patience) if goal.distance > 0 else (0.0,)
        return tuple(goal.distance + added for added in more)

    def turn_to_face(self, bird_map: BirdsEyeMap, base: BasePose, goal: Goal) -> Action | None:
        """Return the turn that is missing to face the goal's nearest cell, or None."""
        if goal.face is None or not goal.face.any():
            return None
        points = bird_map.points_of(goal.face)
        nearest = points[np.argmin(np.hypot(points[:, 0] - base.x, points[:, 1] - base.y))]
        return self.config.face(base.bearing_to(*nearest))


def plan_string_pulled(config: PlannerConfig) -> Planner:
    """Return a new planner whose paths are pulled straight."""
    return Planner(config)


def _in_sight(route: _Route, cells: NDArray[np.int32]) -> Mask:
    """Return what a straight line may cut across: free cells that cost no more than the path's next ones."""
    ahead = cells[: 2 * _NEXT_CELLS]
    return route.free & (route.prices <= route.prices[ahead[:, 0], ahead[:, 1]].max())


def _length_of(action: Action | None) -> float:
    """Return how far forward an action drives (m)."""
    if isinstance(action, BaseDisplacement):
        return max(action.x, 0.0)
    return ACTION_LIMITS.forward_step if action is DiscreteAction.MOVE_FORWARD else 0.0
