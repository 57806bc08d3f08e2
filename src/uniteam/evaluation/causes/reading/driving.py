"""Where the base went, where it did not get away, and how wide the way was that it did not take."""

from collections.abc import Mapping, Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.causes.story import Standstill
from uniteam.evaluation.recording.recording import Recording
from uniteam.geometry import Point2
from uniteam.stretch import BASE_RADIUS
from uniteam.world.homes.home import Home
from uniteam.world.physics.navigable_floor import CELL_SIZE, NavigableFloor

Pose = NDArray[np.float64]

AWAY = 1.0
"""A base that is farther than this (m) has got away."""
ENDS = BASE_RADIUS
"""A way begins and ends somewhere so near to its ends (m): nothing is between, since a base has room at both."""

_WIDEST, _FINEST = 1.2, 0.01


def bases_of(recording: Recording) -> NDArray[np.float64]:
    """Return where the base was at each moment, (M, 2) (m, world)."""
    poses = (recording.base_to_world(moment) for moment in range(len(recording.steps) + 1))
    return np.array([(pose.x, pose.y) for pose in poses])


def read_standstill(bases: NDArray[np.float64], blocked: Sequence[bool]) -> Standstill | None:
    """Return the longest time for which the base stayed within `AWAY` of where it was at the beginning of it.

    Args:
        bases: (M, 2) where the base was at each moment (m, world).
        blocked: of each step, whether something was in the base's way; one fewer.
    """
    best: tuple[int, int] | None = None
    for first in range(len(blocked)):
        away = np.flatnonzero(np.hypot(*(bases[first:] - bases[first]).T) > AWAY)
        last = first + int(away[0]) - 1 if len(away) else len(bases) - 1
        if best is None or last - first > best[1] - best[0]:
            best = first, last
    if best is None:
        return None
    first, last = best[0], min(best[1], len(blocked) - 1)
    x, y = bases[first]
    return Standstill(first, last, (float(x), float(y)), sum(blocked[first : last + 1]))


def width_of_way(home: Home, poses: Mapping[str, Pose], start: Point2, ends: Sequence[Point2]) -> float:
    """Return the width (m) of the widest way from a point to any of some others (m, world).

    How much room there is at its two ends is left out. It is 0 where there is no way at all, and 2.4 where it is as
    wide or wider.

    Args:
        home: with its furniture.
        poses: (4, 4) where its objects are (world), by name; of one that is not named, where it was at first.
        start: where the way begins.
        ends: where it may end.
    """
    floor = NavigableFloor(home).with_moved(home, poses)
    beginning, end = _around(floor, [start]), _around(floor, ends)
    low, high = 0.0, _WIDEST
    while high - low > _FINEST:
        middle = (low + high) / 2
        _, labels = cv2.connectedComponents((floor.cells >= middle).astype(np.uint8), connectivity=4)
        is_joined = bool(set(labels[beginning]) & set(labels[end]) - {0})
        low, high = (middle, high) if is_joined else (low, middle)
    return round(2 * low, 2)


def _around(floor: NavigableFloor, points: Sequence[Point2]) -> NDArray[np.bool_]:
    """Return the cells (R, C) within `ENDS` of any of some points, to which a base could move from there."""
    others = np.ones(floor.cells.shape, np.uint8)
    cells = np.array([floor.to_cell(*point) for point in points])
    inside = cells[np.all((cells >= 0) & (cells < others.shape), axis=1)]
    others[inside[:, 0], inside[:, 1]] = 0
    return np.asarray(cv2.distanceTransform(others, cv2.DIST_L2, cv2.DIST_MASK_PRECISE) * CELL_SIZE <= ENDS)
