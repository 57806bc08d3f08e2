"""What it is worth that the ground around a placing point is level (`flat_ground`)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.mind.manipulation.place.headroom import RISE
from uniteam.mind.skills.view import Points


@dataclass(frozen=True)
class FlatGround:
    """Adds to a point's worth by the share of the points around it at its height: all on a table, few on a slope.

    Attributes:
        worth: of level ground all around, in metres of distance from the edge: a flat point 5 cm nearer to the edge is
            as good, but a slope in the middle of a cushion does not beat a flat seat.
        radius: of the ground that is looked at (m), about that of a cup and the play of its fall.
    """

    worth: float = 0.05
    radius: float = 0.1

    def __call__(self, points: Points, samples: Points) -> NDArray[np.float64]:
        """Return (K,) what is added to the worth of each of (K, 3) samples of (N, 3) points (m)."""
        return self.worth * np.array([self._flatness(points, sample) for sample in samples])

    def _flatness(self, points: Points, sample: NDArray[np.float32]) -> float:
        near = points[np.abs(points[:, :2] - sample[:2]).max(axis=1) < self.radius, 2]
        return float(np.mean(np.abs(near - sample[2]) < RISE)) if len(near) else 0.0
