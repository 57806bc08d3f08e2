"""Where a robot believes that it is: what its wheels told it, with their errors added up."""

import numpy as np

from uniteam.geometry import BasePose, wrap_angle


class Odometry:
    """Dead reckoning with errors that stay the same all the way, as those of worn or unequal wheels do.

    Attributes:
        pose: where the robot believes that it is; it begins at the origin.
    """

    def __init__(self, drift: float, rng: np.random.Generator) -> None:
        """Draw the errors.

        Args:
            drift: the largest error, as a share of distances and angles, and in rad per metre for a base that should
                go straight.
            rng: they are drawn from it, between `drift` and minus that.
        """
        self._distance, self._angle, self._veer = (float(share) for share in drift * rng.uniform(-1.0, 1.0, 3))
        self.pose = BasePose(0.0, 0.0, 0.0)

    def move(self, before: BasePose, after: BasePose) -> None:
        """Take in how the base has moved (any frame)."""
        step = before.inverse().compose(after)
        length = float(np.hypot(step.x, step.y))
        stretch = 1.0 + self._distance
        heading = wrap_angle(step.heading * (1.0 + self._angle) + self._veer * length)
        self.pose = self.pose.compose(BasePose(step.x * stretch, step.y * stretch, heading))
