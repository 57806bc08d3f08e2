"""Where on a receptacle a thing can be put: placing points chosen from the points that are seen of it.

All points are (N, 3) in the base frame or any other with z up (m).
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.mind.manipulation.arm_clearance import Load
from uniteam.mind.skills.view import Points

SLAB = (0.2, 0.2, 0.015)
"""m; how far the slab around a placing point that should be at its height reaches to either side: x, y, z."""


@dataclass(frozen=True)
class PlacingPoints:
    """Points on which a thing can be put.

    Attributes:
        points: (K, 3) m, K >= 0, in the frame of the points they were chosen from.
        worth: (K,) m: how far from the edge, or what is as good; the higher, the better.
    """

    points: NDArray[np.floating]
    worth: NDArray[np.float64]

    def best_first(self) -> NDArray[np.intp]:
        """Return the indices in the order of falling worth; the first of equals comes first."""
        return np.argsort(-self.worth, kind="stable")


NOWHERE = PlacingPoints(np.zeros((0, 3), dtype=np.float32), np.zeros(0))
"""No point at all."""

ChoosePoints = Callable[[Points, Points, Load, np.random.Generator], PlacingPoints]
"""From the points of a receptacle, those of all else and what is to be put there to the points on which it can be."""
Weigh = Callable[[Points, Points, Load], NDArray[np.float64]]
"""From (N, 3) points, (K, 3) samples of them and what is put there to their (K,) worth (m); -inf is no choice."""
Room = Callable[[Points, Points, Load], NDArray[np.float64]]
"""From (K, 3) samples, (N, 3) points of other things and what is put there to how much room each sample lacks (m)."""
Bonus = Callable[[Points, Points], NDArray[np.float64]]
"""From (N, 3) points and (K, 3) samples of them to what is added to the samples' (K,) worth (m)."""


def every_point(points: Points) -> Points:
    """Return all points: whatever is seen of a receptacle may be a place."""
    return points


def slab_density(points: Points, samples: Points, load: Load) -> NDArray[np.float64]:
    """Return the worth of samples by the number of points in the slab of equal height around each.

    The rule of HomeRobot's heuristic placing (arXiv 2306.11565). The fullest slab is worth half its side, so that worth
    is in metres from the edge here too.
    """
    half = np.array(SLAB, dtype=np.float32)
    counts = np.array([np.count_nonzero((np.abs(points - sample) <= half).all(axis=1)) for sample in samples])
    return counts / max(1, counts.max(initial=0)) * SLAB[0]


def ignore_others(samples: Points, others: Points, load: Load) -> NDArray[np.float64]:
    """Return that none lacks any room: the baseline looks at nothing but the receptacle."""
    return np.zeros(len(samples))


def no_bonus(points: Points, samples: Points) -> NDArray[np.float64]:
    """Return nothing to add, as in the baseline."""
    return np.zeros(len(samples))


@dataclass(frozen=True)
class PointRule:
    """Samples the points that may be places and weighs them; the defaults are the baseline's.

    Attributes:
        candidates: which of the points may be places.
        samples: how many of them are weighed.
        weigh: what each is worth.
        missing_room: how much room other things take; of the samples only those that lack least are offered.
        bonus: what is added to that.
    """

    candidates: Callable[[Points], Points] = every_point
    samples: int = 50
    weigh: Weigh = slab_density
    missing_room: Room = ignore_others
    bonus: Bonus = no_bonus

    def __call__(self, points: Points, others: Points, load: Load, generator: np.random.Generator) -> PlacingPoints:
        """Return the sampled points that are offered, with their worth."""
        candidates = self.candidates(points)
        chosen = generator.choice(len(candidates), size=min(self.samples, len(candidates)), replace=False)
        samples = candidates[chosen]
        worth = self.weigh(points, samples, load) + self.bonus(points, samples)
        missing = self.missing_room(samples, others, load)
        offered = worth > -np.inf
        offered &= missing <= missing[offered].min(initial=np.inf)
        return PlacingPoints(samples[offered], worth[offered])
