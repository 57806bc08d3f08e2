"""How a planner plans: the values and strategies that improvements put their own in the place of."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.interface import ACTION_LIMITS, Action, DiscreteAction
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.planning.clearance import Clearance
from uniteam.mind.navigation.planning.collision_mapping import (
    PATCH_UNTIL_REPLAN,
    BlockedMotion,
    CollisionMemory,
    FeltAt,
    at_short_term_goal,
    forget_all,
)
from uniteam.mind.navigation.planning.distance_field import alike

TURN = ACTION_LIMITS.turn_step


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
        patience: what may be added to the goal's distance (m) before the dilation shrinks, tried in this order.
            HomeRobot has neither of the two, `near_enough` both.
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
    patience: tuple[float, ...] = ()
    own_cells: int = 1
    collisions: CollisionMemory = PATCH_UNTIL_REPLAN
    felt_at: FeltAt = at_short_term_goal
    face: Callable[[float], Action | None] = turn_roughly
    price: Price = one_price
    move: Move = move_in_steps
    stride: Stride = no_stride
    spares: Callable[[BirdsEyeMap, BlockedMotion], bool] = write_every_motion
    no_path: Callable[[BirdsEyeMap], None] = forget_all
