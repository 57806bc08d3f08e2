"""Placing points with room for what is held among the other things on a surface (`occupied_surface`)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.mind.manipulation.arm_clearance import Load
from uniteam.mind.skills.view import Points


@dataclass(frozen=True)
class RoomAmongOthers:
    """Asks for the load's own radius between a placing point and whatever stands beside it.

    Attributes:
        below: what is lower than the placing point by more is not on the surface (m).
        headroom: what is higher above the load than this is not in its way (m).
        gap: added to the load's radius (m).
    """

    below: float = 0.03
    headroom: float = 0.1
    gap: float = 0.02

    def __call__(self, samples: Points, others: Points, load: Load) -> NDArray[np.float64]:
        """Return (K,) by how much (m) other things are too near to each of (K, 3) samples; 0 where there is room.

        Args:
            samples: m, z up.
            others: (N, 3) points of everything that is not the receptacle, in the same frame.
            load: what is to be put down.
        """
        needed = max(load.along_base, load.along_arm) + self.gap
        return np.array([max(0.0, needed - self._room(sample, others, load)) for sample in samples], dtype=np.float64)

    def _room(self, sample: NDArray[np.float32], others: Points, load: Load) -> float:
        """Return how far (m) the nearest thing is that stands or hangs where the load would."""
        above = others[:, 2] - sample[2]
        beside = others[(above > -self.below) & (above < load.below + self.headroom), :2]
        return float(np.hypot(*(beside - sample[:2]).T).min(initial=np.inf))
