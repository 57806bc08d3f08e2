"""What it is worth that the ground around a placing point is level (`flat_ground`)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.mind.manipulation.place.around_samples import share_as_high
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
        return self.worth * share_as_high(points, samples, np.float32(self.radius), np.float32(RISE))
