"""Where Stretch's gripper gets to: the joints that bring it over a point beside the base."""

import math
from dataclasses import dataclass, replace

from uniteam.interface import Joints
from uniteam.stretch import JOINT_LIMITS, gripper_to_base

HANGING_WRIST = -1.5
"""rad; the gripper points to the floor, as in the postures of navigation and manipulation."""
LEVEL_WRIST = 0.0
"""rad; the gripper points along the arm, which reaches farther and higher (`level_wrist`)."""


@dataclass(frozen=True)
class ArmReach:
    """How far and how high the gripper gets with the wrist at one pitch.

    Attributes:
        wrist_pitch: rad.
        side: x of the gripper in the base frame (m), whatever the lift and the arm.
        near: distance to the base's right at which the gripper is with the arm retracted (m).
        low: its height with the lift at the bottom (m).
    """

    wrist_pitch: float
    side: float
    near: float
    low: float

    @staticmethod
    def of_wrist(wrist_pitch: float) -> "ArmReach":
        """Return the reach with the wrist at this pitch (rad)."""
        x, y, z = gripper_to_base(Joints(lift=0.0, arm=0.0, wrist_pitch=wrist_pitch))[:3, 3]
        return ArmReach(wrist_pitch, float(x), -float(y), float(z))

    @property
    def far(self) -> float:
        """Distance to the base's right at which the gripper is with the arm fully extended (m)."""
        return self.near + JOINT_LIMITS[1].arm

    @property
    def high(self) -> float:
        """Height of the gripper with the lift at the top (m)."""
        return self.low + JOINT_LIMITS[1].lift

    def lift_for(self, height: float) -> float:
        """Return the lift (m) that brings the gripper nearest to `height` (m)."""
        return min(max(height - self.low, JOINT_LIMITS[0].lift), JOINT_LIMITS[1].lift)

    def arm_for(self, distance: float) -> float:
        """Return the extension (m) that brings the gripper nearest to `distance` (m) to the base's right."""
        return min(max(distance - self.near, JOINT_LIMITS[0].arm), JOINT_LIMITS[1].arm)

    def turn_to(self, x: float, y: float) -> float:
        """Return the turn (rad, left-positive) of the base after which the arm extends over (x, y) (m, base frame)."""
        distance = math.hypot(x, y)
        ahead = math.asin(min(max(self.side / max(distance, 1e-6), -1.0), 1.0))
        return math.remainder(math.atan2(y, x) + math.pi / 2.0 - ahead, 2.0 * math.pi)

    def distance_to(self, x: float, y: float) -> float:
        """Return how far (m) to the base's right (x, y) is once the base has turned by `turn_to`."""
        return math.sqrt(max(x * x + y * y - self.side * self.side, 0.0))

    def reaches(self, x: float, y: float) -> bool:
        """Return whether the gripper gets over (x, y) (m, base frame) once the base has turned by `turn_to`."""
        return self.near <= self.distance_to(x, y) <= self.far

    def over(self, joints: Joints, distance: float, height: float) -> Joints:
        """Return `joints` with lift, arm and wrist changed so that the gripper is there."""
        return replace(joints, lift=self.lift_for(height), arm=self.arm_for(distance), wrist_pitch=self.wrist_pitch)
