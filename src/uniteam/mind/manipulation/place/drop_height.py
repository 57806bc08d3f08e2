"""How high above the surface, and with the wrist at which pitch, the gripper lets go (`drop_height`, `low_drop`)."""

from collections.abc import Callable
from dataclasses import dataclass

from uniteam.mind.manipulation.arm_clearance import Load
from uniteam.mind.manipulation.arm_reach import HANGING_WRIST, ArmReach

LIFT_ABOVE_SURFACE = 0.40
"""m; HomeRobot sets the joint of the lift so much higher than the surface. The hanging gripper is lower than that."""
BASELINE_HEIGHT = LIFT_ABOVE_SURFACE + ArmReach.of_wrist(HANGING_WRIST).low
"""m; of the grasp centre above the surface."""
LOW_DROP = 0.15
"""m; from here a thing falls without tipping over, and a noisy surface is not touched."""


def whatever_its_size(load: Load) -> float:
    """Return the same height for whatever is held, as in the baseline."""
    return 0.0


@dataclass(frozen=True)
class ClearSurface:
    """Keeps the lowest part of what is held above the surface, however far it hangs down.

    Attributes:
        clearance: between the surface and the lowest part of what is held (m).
    """

    clearance: float = 0.15

    def __call__(self, load: Load) -> float:
        """Return how high the grasp centre must be above the surface (m)."""
        return load.below + self.clearance


@dataclass(frozen=True)
class Release:
    """How the gripper lets go; the defaults are those of HomeRobot's heuristic baseline (arXiv 2306.11565).

    Attributes:
        wrist_pitch: rad.
        least_height: of the grasp centre above the surface (m), where the lift gets so high.
        height_for: how high it must be at least for what is held (m).
    """

    wrist_pitch: float = HANGING_WRIST
    least_height: float = BASELINE_HEIGHT
    height_for: Callable[[Load], float] = whatever_its_size

    def height_above_surface(self, load: Load) -> float:
        """Return how high the grasp centre should be above the surface (m)."""
        return max(self.least_height, self.height_for(load))

    @property
    def reach(self) -> ArmReach:
        """The gripper's reach with the wrist at this pitch."""
        return ArmReach.of_wrist(self.wrist_pitch)
