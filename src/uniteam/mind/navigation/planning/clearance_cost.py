"""Paths that keep away from obstacles where that is no long way round (`clearance_cost`)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.mind.navigation.planning.bucket_queue import HIGHEST_PRICE
from uniteam.mind.navigation.planning.clearance import Clearance
from uniteam.stretch import BASE_RADIUS


@dataclass(frozen=True)
class ClearancePrice:
    """Makes cells dearer the nearer they are to an obstacle, so that a path keeps to the middle of a narrow way.

    Attributes:
        room: beyond the base's radius from which on a cell is as cheap as can be (m); at the radius it is dearest.
    """

    room: float = 0.2

    def __call__(self, clearance: Clearance) -> NDArray[np.uint8]:
        """Return the (H, W) prices of the cells."""
        missing = (BASE_RADIUS + self.room - clearance.metres) / self.room
        return np.clip(1 + np.ceil(missing * (HIGHEST_PRICE - 1) - 1e-4), 1, HIGHEST_PRICE).astype(np.uint8)
