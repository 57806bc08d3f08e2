"""From a goal on the map to the next action along a path that is pulled straight (`string_pulled_path`).

As in HomeRobot's planner (`ring_planner`), obstacles are dilated, the short-term goal lies five cells ahead, and the
robot turns or drives towards it. Smaller dilations are tried within the step in which there is no path, not for good.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.grid import Cell, Mask
from uniteam.interface import ACTION_LIMITS, Action, BaseDisplacement, DiscreteAction
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal
from uniteam.mind.navigation.planning.clearance import Clearance
from uniteam.mind.navigation.planning.collision_mapping import (
    PATCH_UNTIL_REPLAN,
    BlockedMotion,
    CollisionMemory,
    FeltAt,
    at_short_term_goal,
    forget_all,
)
from uniteam.mind.navigation.planning.distance_field import SearchResult, alike, nearest_target, path_length, trace_path
from uniteam.mind.navigation.planning.short_term_goal import find_short_term_goal
from uniteam.mind.navigation.planning.traversible import connected_to, traversible
from uniteam.mind.navigation.window import Window, window_around
from uniteam.stretch import BASE_RADIUS

TURN = ACTION_LIMITS.turn_step
_NEXT_CELLS = 5
BLOCKED_OFTEN = 3
"""Forward motions blocked one after the other; a way that three wider and wider marks on the map left open is none."""


def turn_roughly(bearing: float) -> Action | None:
    """Return a turn of 30 degrees towards a bearing (rad), or None within 20 degrees of it, as HomeRobot does."""
    return None if abs(bearing) <= TURN * 2 / 3 else turn_in_steps(bearing)


def turn_in_steps(bearing: float) -> Action | None:
    """Return a turn of 30 degrees towards a bearing (rad), or None within 15 degrees of it: `straight_face`."""
    if abs(bearing) <= TURN / 2 + 1e-6:
        return None
    return DiscreteAction.TURN_LEFT if bearing > 0 else DiscreteAction.TURN_RIGHT


@dataclass(frozen=True)
class Way:
    """What lies straight ahead on a path.

    Attributes:
        goal: (x, y) of the short-term goal (m, start frame).
        straight: how far the path can be followed in the line to it (m).
        clearance: how far obstacles are.
        bird_map: the map.
        blocked_in_a_row: how many of the last forward motions were blocked.
    """

    goal: tuple[float, float]
    straight: float
    clearance: Clearance
    bird_map: BirdsEyeMap
    blocked_in_a_row: int


Move = Callable[[BasePose, Way], Action]
"""From the robot (start frame) and the way ahead to the action that leads along it."""
Price = Callable[[Clearance], NDArray[np.uint8]]
"""From (H, W) clearances to the (H, W) prices of the cells (`nearest_target`)."""


def move_in_steps(base: BasePose, way: Way) -> Action:
    """Turn by 30 degrees or drive 0.25 m, as the challenge's discrete actions do."""
    return turn_in_steps(base.bearing_to(*way.goal)) or DiscreteAction.MOVE_FORWARD


Stride = Callable[[BasePose, Way], Action | None]
"""From the robot (start frame) and the way ahead to a longer motion along it; None where `Move` is to be asked."""


def no_stride(base: BasePose, way: Way) -> Action | None:
    """Return None: whatever the way, move as the discrete actions do."""
    return None


def write_every_motion(bird_map: BirdsEyeMap, motion: BlockedMotion) -> bool:
    """Return False: each blocked motion is written into the map."""
    return False


def one_price(clearance: Clearance) -> NDArray[np.uint8]:
    """Return the same price for all cells: the shortest path wins, however near to obstacles."""
    return alike(clearance.obstacle)


@dataclass(frozen=True)
class PlannerConfig:
    """How the planner plans; the defaults are those that HomeRobot ships for this task.

    Attributes:
        dilations: cells by which obstacles grow, tried in this order until there is a path.
        step_cells: how far ahead the short-term goal lies.
        blocked_below: a forward motion that gets less far was blocked (share of what was asked for).
        tolerance: the goal is reached this far (m, along the path) before the place that was asked for.
        patience: what may be added to the goal's distance (m) before the dilation shrinks. HomeRobot has neither of the
            two, `near_enough` both.
        own_cells: radius (cells) of the disc around the robot that is free because it stands there; `own_disc` has a
            larger one.
        collisions: how blocked motions are remembered.
        felt_at: where an obstacle was that blocked a motion.
        face: how the robot turns towards the goal once it is there.
        price: what a path costs more near to obstacles.
        move: how the robot moves towards the short-term goal.
        stride: how far it moves at once where the way is straight for longer.
        spares: whether a blocked motion is not written into the map.
        no_path: called when there is no path to anything.
    """

    dilations: tuple[int, ...] = (3, 2, 1)
    step_cells: int = 5
    blocked_below: float = 0.8
    tolerance: float = 0.0
    patience: float = 0.0
    own_cells: int = 1
    collisions: CollisionMemory = PATCH_UNTIL_REPLAN
    felt_at: FeltAt = at_short_term_goal
    face: Callable[[float], Action | None] = turn_roughly
    price: Price = one_price
    move: Move = move_in_steps
    stride: Stride = no_stride
    spares: Callable[[BirdsEyeMap, BlockedMotion], bool] = write_every_motion
    no_path: Callable[[BirdsEyeMap], None] = forget_all


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
        has_place: whether anywhere near enough to the goal is free, be there a path or not.
    """

    action: Action | None
    reached: bool
    reachable: bool
    is_daring: bool
    distance: float
    short_term_goal: tuple[float, float] | None
    path: NDArray[np.float64]
    goal_points: NDArray[np.float64]
    has_place: bool = True


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
        to_goal = straight_distance(window.cut(goal.cells), bird_map.cell_size)
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
        return (goal.distance, goal.distance + self.config.patience) if goal.distance > 0 else (0.0,)

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


def straight_distance(cells: Mask, cell_size: float) -> NDArray[np.float32]:
    """Return each cell's distance (m) to the nearest of some cells, through everything; inf where there is none."""
    if not cells.any():
        return np.full(cells.shape, np.inf, dtype=np.float32)
    return cv2.distanceTransform((~cells).view(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_5) * np.float32(cell_size)


def _in_sight(route: _Route, cells: NDArray[np.int32]) -> Mask:
    """Return what a straight line may cut across: free cells that cost no more than the path's next ones."""
    ahead = cells[: 2 * _NEXT_CELLS]
    return route.free & (route.prices <= route.prices[ahead[:, 0], ahead[:, 1]].max())


def _length_of(action: Action | None) -> float:
    """Return how far forward an action drives (m)."""
    if isinstance(action, BaseDisplacement):
        return max(action.x, 0.0)
    return ACTION_LIMITS.forward_step if action is DiscreteAction.MOVE_FORWARD else 0.0
