"""What a blocked forward motion leaves on the map."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.stretch import BASE_RADIUS

RIM = BASE_RADIUS + 0.05
"""m from the base's axis; what blocks a motion is no nearer, and a cell beyond the base it is not within it."""


@dataclass(frozen=True)
class BlockedMotion:
    """A forward motion that got less far than it should.

    Attributes:
        base: where it began (start frame).
        short_term_goal: (x, y) where it was to lead (m, start frame).
        in_a_row: how many motions in a row have been blocked, this one included.
    """

    base: BasePose
    short_term_goal: tuple[float, float]
    in_a_row: int


FeltAt = Callable[[BlockedMotion, float], NDArray[np.float64]]
"""From a blocked motion and the size of a cell (m) to the (K, 2) points (m, start frame) where an obstacle was felt."""


def at_short_term_goal(motion: BlockedMotion, cell_size: float) -> NDArray[np.float64]:
    """Return the point to which the motion was to lead, as the UniTeam report has it."""
    return np.array([motion.short_term_goal])


def before_the_rim(motion: BlockedMotion, cell_size: float) -> NDArray[np.float64]:
    """Return a patch where the motion led, but not within the base, wider when blocked again: `wide_collisions`."""
    length = max(RIM, motion.base.distance_to(*motion.short_term_goal))
    reach = round(length / cell_size)
    width = min(2 * motion.in_a_row + 1, 13)
    return _patch(motion.base, cell_size, np.arange(2 * reach, 2 * reach + 3) / 2, np.arange(1 - width, width) / 2)


@dataclass(frozen=True)
class CollisionMemory:
    """How collisions are remembered.

    Attributes:
        write: writes a blocked motion into the map; takes where an obstacle was felt.
        replan: called when a path is begun that there is only without the collision cells or with a smaller dilation.
    """

    write: Callable[[BirdsEyeMap, BlockedMotion, FeltAt], None]
    replan: Callable[[BirdsEyeMap], None]


def write_patch_ahead(bird_map: BirdsEyeMap, motion: BlockedMotion, felt_at: FeltAt) -> None:
    """Mark a small patch of collision cells 0.2 m ahead, wider when blocked again: HomeRobot's collision map."""
    half = min(motion.in_a_row, 2)
    nearest, length = (4, 2) if motion.in_a_row < 3 else (3, 4)
    ahead = np.arange(nearest, nearest + length)
    bird_map.mark_collision(_patch(motion.base, bird_map.cell_size, ahead, np.arange(-half, half + 1)))


def forget_collisions(bird_map: BirdsEyeMap) -> None:
    """Clear the collision cells, as HomeRobot does whenever it finds no path."""
    bird_map.clear_collisions()


def write_obstacle(bird_map: BirdsEyeMap, motion: BlockedMotion, felt_at: FeltAt) -> None:
    """Write an obstacle where it was felt: UniTeam's improvement.

    It stands in the obstacle map, so it is dilated as any obstacle, and stays until there is no path to anything.
    """
    points = felt_at(motion, bird_map.cell_size)
    bird_map.mark_felt(points)
    bird_map.mark_collision(points)


def keep_collisions(bird_map: BirdsEyeMap) -> None:
    """Leave every collision where it is."""


def forget_all(bird_map: BirdsEyeMap) -> None:
    """Forget all that collisions taught: they have shut the robot in."""
    bird_map.clear_collisions()
    bird_map.clear_felt()


PATCH_UNTIL_REPLAN = CollisionMemory(write_patch_ahead, forget_collisions)
"""The baseline's memory of collisions."""

COLLISION_MAPPING = CollisionMemory(write_obstacle, keep_collisions)
"""UniTeam's `collision_mapping`."""


def _patch(base: BasePose, cell: float, ahead: NDArray[np.number], sides: NDArray[np.number]) -> NDArray[np.float64]:
    """Return (K, 2) points (m, parent frame of the base) on a grid so many cells ahead of a base and to its left.

    A patch of cells that is turned against the grid has holes unless its points lie half a cell apart.
    """
    forward = np.array([math.cos(base.heading), math.sin(base.heading)])
    left = np.array([-forward[1], forward[0]])
    return np.array([(base.x, base.y) + cell * (a * forward + s * left) for a in ahead for s in sides])
