"""How far the nearest mapped obstacle is."""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.grid import Grid, Mask
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.planning.distance_field import straight_distance
from uniteam.mind.navigation.window import Window

_SHARES = tuple(np.linspace(0.0, 1.0, 9).tolist())
"""Of a way, where it is looked at."""


@dataclass(frozen=True)
class Clearance:
    """The distances of a part of the map to the nearest obstacle; measured once they are asked for.

    Attributes:
        obstacle: (H, W) bool.
        grid: where its cells lie in the start frame.
    """

    obstacle: Mask
    grid: Grid

    @staticmethod
    def of(bird_map: BirdsEyeMap, window: Window) -> "Clearance":
        """Return the clearance in a window of the map as it is now."""
        x, y = bird_map.origin
        corner = x + window.low[1] * bird_map.cell_size, y + window.low[0] * bird_map.cell_size
        return Clearance(window.cut(bird_map.obstacle), Grid(corner, bird_map.cell_size))

    @cached_property
    def metres(self) -> NDArray[np.float32]:
        """(H, W) distance (m) from each cell's centre to the centre of the nearest obstacle's."""
        return straight_distance(self.obstacle, self.grid.cell_size)

    def ahead(self, base: BasePose, length: float) -> float:
        """Return the least distance (m) to an obstacle on the way straight ahead of a base (start frame)."""
        rows, columns = self.obstacle.shape
        least = math.inf
        along, across = math.cos(base.heading), math.sin(base.heading)
        for share in _SHARES:
            x = base.x + share * length * along
            y = base.y + share * length * across
            row, column = self.grid.to_cell(x, y)
            if 0 <= row < rows and 0 <= column < columns:
                least = min(least, float(self.metres[row, column]))
        return least
