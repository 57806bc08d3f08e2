"""What has been looked at: what was in the picture, near enough to be recognised, and hidden by nothing."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.mind.mapping.viewed_sides import Gaze, Pixels, sides_towards

_MOST_CELLS = 1 << 20


@dataclass(frozen=True)
class ResolvedLook:
    """Counts a cell as looked at only where pixels show it at a sufficient resolution (`resolved_look`).

    Attributes:
        coarsest: of the resolutions at which a thing on it would be recognised (m a pixel): a pen has 50 pixels.
        farthest: from farther off (m, over the floor) nothing counts: the rim of a basin hides what lies behind it.
        cell_size: pixels so near to a cell's centre show it (m).
    """

    coarsest: float = 0.004
    farthest: float = math.inf
    cell_size: float = 0.05

    def __call__(self, points: NDArray[np.float64], gaze: Gaze, pixels: Pixels) -> NDArray[np.uint8]:
        """Return (K,) the sides from which (K, 2) points have been seen; 0 for those that were not.

        Args:
            points: centres of cells (m).
            gaze: from where.
            pixels: returns those of the receptacles.
        """
        if len(points) == 0:
            return np.zeros(0, dtype=np.uint8)
        seen = pixels()
        away = np.hypot(points[:, 0] - gaze.x, points[:, 1] - gaze.y)
        shown = (away <= self.farthest) & np.isin(self._keys(points), self._keys(seen[seen[:, 2] <= self.coarsest, :2]))
        return np.where(shown, sides_towards(points, gaze), 0).astype(np.uint8)

    def _keys(self, points: NDArray[np.float64]) -> NDArray[np.int64]:
        """Return a number for each cell, the same for all points in it."""
        cells = np.floor(points / self.cell_size).astype(np.int64)
        return cells[:, 0] * _MOST_CELLS + cells[:, 1]
