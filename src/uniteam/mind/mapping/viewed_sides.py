"""From which sides the receptacles have been looked at."""

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

SIDES = 4
"""East, north, west and south of a cell, a quarter of the circle each: bits 0 to 3 of a look."""


class Gaze(NamedTuple):
    """Where the robot stands and looks, in the frame of the points.

    Attributes:
        x, y, heading: the base (m, m, rad).
        range: what is farther (m) is not looked at.
        half_width: what is farther off the heading (rad) is not looked at.
        play: a look this near (rad) to the border between two sides counts for both.
    """

    x: float
    y: float
    heading: float
    range: float = 2.0
    half_width: float = math.radians(30.0)
    play: float = math.radians(20.0)


Pixels = Callable[[], NDArray[np.float64]]
"""Returns the (N, 3) pixels of a frame that show receptacles: x, y (m) and the resolution there (m a pixel)."""
LookBits = Callable[[NDArray[np.float64], Gaze, Pixels], NDArray[np.uint8]]
"""From (K, 2) points, a gaze at them and the pixels it sees to the (K,) sides of the points looked at."""


def look_bits(points: NDArray[np.float64], gaze: Gaze, pixels: Pixels) -> NDArray[np.uint8]:
    """Return (K,) the sides from which a gaze looks at (K, 2) points, whatever hides them; 0 for points outside of it.

    Near the border between two sides a look counts for both, so that standing a little off the place that was asked for
    does not leave a side open.
    """
    away = np.array([gaze.x, gaze.y]) - points
    bearing = np.arctan2(-away[:, 1], -away[:, 0]) - gaze.heading
    off = np.abs((bearing + math.pi) % (2 * math.pi) - math.pi)
    is_inside = (np.hypot(away[:, 0], away[:, 1]) <= gaze.range) & (off <= gaze.half_width)
    return np.where(is_inside, sides_towards(points, gaze), 0).astype(np.uint8)


def sides_towards(points: NDArray[np.float64], gaze: Gaze) -> NDArray[np.uint8]:
    """Return (K,) the sides of (K, 2) points that lie towards a gaze's stand, both where it is near their border."""
    away = np.array([gaze.x, gaze.y]) - points
    angle = np.arctan2(away[:, 1], away[:, 0])
    bits = side_bit(angle - gaze.play) | side_bit(angle) | side_bit(angle + gaze.play)
    return bits.astype(np.uint8)


def side_bit(angle: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Return the bit of the side that lies in a direction (rad, from the cell)."""
    quarter = np.floor((angle + math.pi / SIDES) / (2 * math.pi / SIDES)).astype(np.int64) % SIDES
    return (1 << quarter).astype(np.uint8)
