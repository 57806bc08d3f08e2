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


@dataclass(frozen=True)
class CollisionMemory:
    """How collisions are remembered.

    Attributes:
        write: writes a blocked motion into the map.
        replan: called when a path is begun that there is only without the collision cells or with a smaller dilation.
        no_path: called when there is no path to anything.
    """

    write: Callable[[BirdsEyeMap, BlockedMotion], None]
    replan: Callable[[BirdsEyeMap], None]
    no_path: Callable[[BirdsEyeMap], None]


def write_patch_ahead(bird_map: BirdsEyeMap, motion: BlockedMotion) -> None:
    """Mark a small patch of collision cells 0.2 m ahead, wider when blocked again: HomeRobot's collision map."""
    cell = bird_map.cell_size
    width = min(2 * motion.in_a_row - 1, 5)
    nearest, length = (4, 2) if motion.in_a_row < 3 else (3, 4)
    bird_map.mark_collision(_patch(motion.base, cell, range(nearest, nearest + length), width))


def forget_collisions(bird_map: BirdsEyeMap) -> None:
    """Clear the collision cells, as HomeRobot does when it finds no path; here only when that brings a path about."""
    bird_map.clear_collisions()


def write_short_term_goal(bird_map: BirdsEyeMap, motion: BlockedMotion) -> None:
    """Write an obstacle where the motion led, before the base's rim, wider when blocked again: UniTeam's improvement.

    It stands in the obstacle map, so it is dilated as any obstacle, and stays until there is no path to anything.
    """
    length = max(RIM, motion.base.distance_to(*motion.short_term_goal))
    reach = round(length / bird_map.cell_size)
    width = min(2 * motion.in_a_row + 1, 13)
    points = _patch(motion.base, bird_map.cell_size, range(reach, reach + 2), width)
    bird_map.mark_felt(points)
    bird_map.mark_collision(points)


def keep_collisions(bird_map: BirdsEyeMap) -> None:
    """Leave every collision where it is."""


def forget_all(bird_map: BirdsEyeMap) -> None:
    """Forget all that collisions taught: they have shut the robot in."""
    bird_map.clear_collisions()
    bird_map.clear_felt()


PATCH_UNTIL_REPLAN = CollisionMemory(write_patch_ahead, forget_collisions, forget_all)
"""The baseline's memory of collisions."""

COLLISION_MAPPING = CollisionMemory(write_short_term_goal, keep_collisions, forget_all)
"""UniTeam's `collision_mapping`."""


def _patch(base: BasePose, cell: float, ahead: range, width: int) -> NDArray[np.float64]:
    """Return (K, 2) points (m, parent frame of the base) on a grid ahead of a base, centred on its axis.

    The points lie half a cell apart: a patch of cells that is turned against the grid must have no holes.
    """
    forward = np.array([math.cos(base.heading), math.sin(base.heading)])
    left = np.array([-forward[1], forward[0]])
    lengths = np.arange(2 * ahead.start, 2 * ahead.stop - 1) / 2
    sides = np.arange(-(width - 1), width) / 2
    return np.array([(base.x, base.y) + cell * (a * forward + s * left) for a in lengths for s in sides])
