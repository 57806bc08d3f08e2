"""From a goal on the map to the next action: the discrete planner.

It follows HomeRobot's: obstacles dilated by three cells, a dilation that shrinks while no path is found, a short-term
goal five cells ahead, a turn or a forward motion towards it, a stop within 0.5 m of the goal, and a turn to face it.
"""

from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.grid import Cell, Mask
from uniteam.interface import ACTION_LIMITS, Action, DiscreteAction
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal
from uniteam.mind.navigation.planning.collision_mapping import PATCH_UNTIL_REPLAN, BlockedMotion, CollisionMemory
from uniteam.mind.navigation.planning.distance_field import SearchResult, costs_to_metres, nearest_target, trace_path
from uniteam.mind.navigation.planning.short_term_goal import find_short_term_goal
from uniteam.mind.navigation.planning.traversible import connected_to, traversible
from uniteam.mind.navigation.window import Window, window_around

TURN = ACTION_LIMITS.turn_step
BLOCKED_OFTEN = 3
"""Forward motions blocked one after the other; a way that three wider and wider marks on the map left open is none."""


def turn_in_steps(bearing: float) -> Action | None:
    """Return a turn of 30 degrees towards a bearing (rad), or None within 15 degrees of it."""
    if abs(bearing) <= TURN / 2 + 1e-6:
        return None
    return DiscreteAction.TURN_LEFT if bearing > 0 else DiscreteAction.TURN_RIGHT


@dataclass(frozen=True)
class PlannerConfig:
    """How the planner plans; the defaults are those that HomeRobot ships for this task.

    Attributes:
        dilations: cells by which obstacles grow, tried in this order until there is a path.
        step_cells: how far ahead the short-term goal lies.
        blocked_below: a forward motion that gets less far was blocked (m).
        tolerance: the goal is reached this far (m, along the path) before the place that was asked for.
        patience: what may be added to the goal's distance (m) before the dilation shrinks.
        collisions: how blocked motions are remembered.
        face: how the robot turns towards the goal once it is there.
    """

    dilations: tuple[int, ...] = (3, 2, 1)
    step_cells: int = 5
    blocked_below: float = 0.20
    tolerance: float = 0.10
    patience: float = 0.25
    collisions: CollisionMemory = PATCH_UNTIL_REPLAN
    face: Callable[[float], Action | None] = turn_in_steps


@dataclass(frozen=True)
class Plan:
    """What the planner makes of a goal. Points are in the start frame (m).

    Attributes:
        action: what to do next; None when the goal is reached (or nothing can be done).
        reached: the robot stands as near as it can or as was asked for, and faces the goal.
        reachable: whether a path leads as near to the goal as was asked for; else the plan leads to the nearest place.
        is_daring: whether the path leads through collision cells, or nearer to obstacles than it should.
        distance: length of the path (m).
        short_term_goal: (x, y) the robot heads for now, or None when it has arrived.
        path: (P, 2) from the robot to where it will stand.
        goal_points: (K, 2) the goal's cells; K may be 0.
    """

    action: Action | None
    reached: bool
    reachable: bool
    is_daring: bool
    distance: float
    short_term_goal: tuple[float, float] | None
    path: NDArray[np.float64]
    goal_points: NDArray[np.float64]


@dataclass(frozen=True)
class _Route:
    """A search that found a place to stand: grids are the window's."""

    window: Window
    free: Mask
    reach: SearchResult
    reachable: bool
    is_daring: bool = False


@dataclass(frozen=True)
class _Motion:
    """The forward motion that the last plan asked for."""

    base: BasePose
    short_term_goal: tuple[float, float]
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

    def plan(self, bird_map: BirdsEyeMap, base: BasePose, goal: Goal) -> Plan:
        """Return the next step towards a goal; nothing is changed by asking.

        Args:
            bird_map: the map, updated with the present observation.
            base: the robot (start frame).
            goal: where to, made for the map's present shape.
        """
        route = self._find_route(bird_map, base, goal)
        distance, path = _path_points(bird_map, route)
        if distance > self.config.tolerance:
            ahead = find_short_term_goal(route.free, _cells_in(route), self.config.step_cells)
            short_term_goal = bird_map.to_point(*route.window.outside(np.array(ahead)))
            action: Action | None = turn_in_steps(base.bearing_to(*short_term_goal)) or DiscreteAction.MOVE_FORWARD
        else:
            short_term_goal = None
            action = self.turn_to_face(bird_map, base, goal)
        goal_points = bird_map.points_of(goal.cells)
        return Plan(
            action, action is None, route.reachable, route.is_daring, distance, short_term_goal, path, goal_points
        )

    def begin(self, plan: Plan, bird_map: BirdsEyeMap, base: BasePose) -> None:
        """Take a plan, made on this map and from this base, for the one that is carried out."""
        if plan.is_daring:
            self.config.collisions.replan(bird_map)
        self._motion = None
        if plan.action is DiscreteAction.MOVE_FORWARD and plan.short_term_goal is not None:
            self._motion = _Motion(base, plan.short_term_goal, bird_map.update_count)

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
        if motion.base.distance_to(base.x, base.y) >= self.config.blocked_below:
            self._blocked_in_a_row = 0
            return
        self._blocked_in_a_row += 1
        blocked = BlockedMotion(motion.base, motion.short_term_goal, self._blocked_in_a_row)
        self.config.collisions.write(bird_map, blocked)

    def _find_route(self, bird_map: BirdsEyeMap, base: BasePose, goal: Goal) -> _Route:
        window = window_around(bird_map, base, goal.cells)
        robot = window.inside(bird_map.to_cell(base.x, base.y))
        to_goal = _straight_distance(window.cut(goal.cells), bird_map.cell_size)
        careful = traversible(bird_map, window, robot, self.config.dilations[0]) & ~window.cut(bird_map.collision)
        careful[robot] = True
        reach = self._search(careful, robot, to_goal, goal)
        if reach is not None:
            return _Route(window, careful, reach, True)
        for dilation in self.config.dilations:
            free = traversible(bird_map, window, robot, dilation)
            reach = self._search(free, robot, to_goal, goal)
            if reach is not None:
                return _Route(window, free, reach, True, is_daring=True)
        nearest = np.where(connected_to(robot, careful), to_goal, np.inf)
        targets = nearest == nearest.min() if np.isfinite(nearest[robot]) else nearest < 0
        targets[robot] |= not targets.any()
        return _Route(window, careful, nearest_target(careful, robot, targets), False)

    def _search(self, free: Mask, robot: Cell, to_goal: NDArray[np.float32], goal: Goal) -> SearchResult | None:
        """Return the search that found the nearest place to stand, or None."""
        known = connected_to(robot, free)
        for distance in self._distances(goal):
            targets = (to_goal <= distance) & known
            if targets.any():
                return nearest_target(free, robot, targets)
        return None

    def _distances(self, goal: Goal) -> tuple[float, ...]:
        """Return how near to the goal is near enough, the asked for first."""
        return (goal.distance, goal.distance + self.config.patience) if goal.distance > 0 else (0.0,)

    def turn_to_face(self, bird_map: BirdsEyeMap, base: BasePose, goal: Goal) -> Action | None:
        """Return the turn that is missing to face the goal's nearest cell, or None."""
        if goal.face is None or not goal.face.any():
            return None
        points = bird_map.points_of(goal.face)
        nearest = points[np.argmin(np.hypot(points[:, 0] - base.x, points[:, 1] - base.y))]
        return self.config.face(base.bearing_to(*nearest))


def _straight_distance(cells: Mask, cell_size: float) -> NDArray[np.float32]:
    """Return each cell's distance (m) to the nearest of some cells, through everything; inf where there is none."""
    if not cells.any():
        return np.full(cells.shape, np.inf, dtype=np.float32)
    return cv2.distanceTransform((~cells).view(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_5) * np.float32(cell_size)


def _cells_in(route: _Route) -> NDArray[np.int32]:
    return trace_path(route.free, route.reach, route.reach.target)


def _path_points(bird_map: BirdsEyeMap, route: _Route) -> tuple[float, NDArray[np.float64]]:
    """Return the length of the path (m) and its (P, 2) points in the start frame."""
    distance = float(costs_to_metres(route.reach.costs[route.reach.target][None], bird_map.cell_size)[0])
    return distance, bird_map.to_points(route.window.outside(_cells_in(route)))
