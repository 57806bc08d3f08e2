"""How far the base is from what it is to look at: the length of the way to the nearest view point, and the turn."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose, Point2
from uniteam.mind.navigation.planning.distance_field import distance_field
from uniteam.world.physics.navigable_floor import CELL_SIZE, NavigableFloor

_WINDOW = 2
"""Cells on each side of the base's own in which its way may begin: its own may be too near to something."""


@dataclass(frozen=True)
class Nearest:
    """The goal that is nearest by the length of the way.

    Attributes:
        index: which of the goals.
        distance: length of the way to its nearest view point (m); infinite where there is none.
        angle: how far the base must turn to face its middle (rad, not negative).
    """

    index: int
    distance: float
    angle: float


class Goals:
    """Some goals on a floor."""

    def __init__(
        self, floor: NavigableFloor, distances: Sequence[NDArray[np.float32]], middles: Sequence[Point2]
    ) -> None:
        """Take the (R, C) distances to each goal's view points (m) and each goal's (x, y) (m, world)."""
        self._floor, self._distances, self._middles = floor, distances, middles

    def nearest(self, base: BasePose) -> Nearest:
        """Return the goal nearest to a pose of the base (world)."""
        row, column = self._floor.to_cell(base.x, base.y)
        rows = slice(max(row - _WINDOW, 0), row + _WINDOW + 1)
        columns = slice(max(column - _WINDOW, 0), column + _WINDOW + 1)
        first_x, first_y = self._floor.to_point(rows.start, columns.start)
        around = np.stack([distances[rows, columns] for distances in self._distances])
        y = first_y + CELL_SIZE * np.arange(around.shape[1]) - base.y
        x = first_x + CELL_SIZE * np.arange(around.shape[2]) - base.x
        ways = (around + np.hypot(y[:, None], x)).min(axis=(1, 2))
        index = int(np.argmin(ways))
        return Nearest(index, float(ways[index]), abs(base.bearing_to(*self._middles[index])))


def distances_from(floor: NavigableFloor, points: Sequence[Point2]) -> NDArray[np.float32]:
    """Return the (R, C) length (m) of the shortest way from each cell of a floor to one of some points (m, world)."""
    sources = np.zeros_like(floor.free)
    for x, y in points:
        sources[floor.to_cell(x, y)] = True
    return distance_field(floor.free, sources, CELL_SIZE)
