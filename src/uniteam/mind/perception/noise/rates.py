"""How much a detector errs: what the dial's level 1 means, and what lies between it and none."""

import math
from dataclasses import dataclass

from uniteam.mind.perception.noise.places import Sighting

FULL_PIXELS = 76_800
"""Of a frame of 240 x 320, to which pixel counts refer."""


@dataclass(frozen=True)
class Rates:
    """What goes wrong at level 1; at a lower level as much less of each.

    How often are shares in [0, 1]. A score s is given as its logit, ln(s / (1 - s)).

    Attributes:
        missed: how often what is near and large is missed.
        missed_small: how much more often what covers few pixels is.
        half_small: pixels (of a frame of 240 x 320) at which half of that applies.
        missed_far: how much more often what is far is.
        half_far: distance (m) at which half of that applies.
        lasting: which share of a miss's variance is the thing's own and stays from wherever it is seen.
        confused: how often a thing is taken for one that looks like it.
        floor: which share of the floor is taken for a receptacle.
        ragged: how far (pixels of a frame 240 wide) a mask's edge is off.
        right_logit: mean logit of the score of what is rightly named.
        wrong_logit: mean logit of the score of what is not.
        spread: standard deviation of a logit from place to place.
        bias: standard deviation of a logit from name to name: the scores' miscalibration.
    """

    missed: float = 0.3
    missed_small: float = 0.65
    half_small: float = 350.0
    missed_far: float = 0.35
    half_far: float = 3.0
    lasting: float = 0.6
    confused: float = 0.28
    floor: float = 0.02
    ragged: float = 3.0
    right_logit: float = 1.2
    wrong_logit: float = 0.4
    spread: float = 0.8
    bias: float = 0.7

    def miss(self, sighting: Sighting, frame_pixels: int) -> float:
        """Return how often a thing is missed at level 1, by the pixels that show it and its distance."""
        pixels = sighting.pixels * FULL_PIXELS / frame_pixels
        seen = (1.0 - self.missed) * (1.0 - self.missed_small * self.half_small / (self.half_small + pixels))
        return 1.0 - seen * (1.0 - self.missed_far * _rising(sighting.distance, self.half_far))


DETECTOR = Rates()
"""Level 1: set so that the baseline loses by it about what HomeRobot's lost by Detic; docs/dial.md says how nearly."""


def _rising(value: float, half: float) -> float:
    """Return 0 at 0, 0.5 at `half`, and 1 far above it."""
    return value**4 / (value**4 + half**4)


def score_of_logit(logit: float, level: float) -> float:
    """Return a score in [0, 1]: the logistic of the logit at level 1, and 1 at level 0."""
    return 1.0 - level / (1.0 + math.exp(logit))
