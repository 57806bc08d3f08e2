"""How high above the surface, and with the wrist at which pitch, the gripper lets go."""

from dataclasses import dataclass

from uniteam.mind.manipulation.arm_clearance import Load
from uniteam.mind.manipulation.arm_reach import HANGING_WRIST, LEVEL_WRIST, Reach


@dataclass(frozen=True)
class FixedDrop:
    """The gripper hangs from the wrist and lets go at one height above the surface, whatever it holds.

    Attributes:
        height: of the grasp centre above the surface (m), where the lift gets so high.
    """

    height: float = 0.4
    wrist_pitch: float = HANGING_WRIST

    def height_above_surface(self, load: Load) -> float:
        """Return how high the grasp centre should be above the surface (m)."""
        return self.height


@dataclass(frozen=True)
class DropClear:
    """The gripper is level with the arm, which lifts it higher, and lets go where what hangs in it clears the surface.

    Attributes:
        clearance: between the surface and the lowest part of what is held (m).
    """

    clearance: float = 0.15
    wrist_pitch: float = LEVEL_WRIST

    def height_above_surface(self, load: Load) -> float:
        """Return how high the grasp centre should be above the surface (m)."""
        return load.below + self.clearance


ReleaseRule = FixedDrop | DropClear


def reach_of(rule: ReleaseRule) -> Reach:
    """Return the gripper's reach with the wrist as the rule wants it."""
    return Reach.of_wrist(rule.wrist_pitch)
