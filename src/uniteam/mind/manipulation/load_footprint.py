"""How much room the robot takes on the floor with something in its gripper (`load_footprint`)."""

import math
from dataclasses import dataclass

from uniteam.mind.manipulation.arm_clearance import Load
from uniteam.stretch import BASE_RADIUS, NAVIGATION_POSTURE, gripper_to_base


def base_alone(load: Load) -> float:
    """Return the base's radius (m), whatever it carries, as the baseline does."""
    return BASE_RADIUS


@dataclass(frozen=True)
class LoadFootprint:
    """Takes in what sticks out beyond the base while the robot drives or turns.

    Attributes:
        most: a wider load is carried as if it were so wide (m): no door would be wide enough.
    """

    most: float = BASE_RADIUS + 0.15

    def __call__(self, load: Load) -> float:
        """Return the radius (m) of the circle around the base's axis that holds the base and the load."""
        x, y, _ = gripper_to_base(NAVIGATION_POSTURE)[:3, 3]
        reach = math.hypot(abs(float(x)) + load.along_base, abs(float(y)) + load.along_arm)
        return min(max(BASE_RADIUS, reach), self.most)
