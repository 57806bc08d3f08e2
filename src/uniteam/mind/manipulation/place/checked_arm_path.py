"""Reaching out only where the arm touches nothing that is seen, over what stands in its way (`checked_arm_path`)."""

import math
from dataclasses import dataclass, field

import numpy as np

from uniteam.mind.manipulation.arm_clearance import SweepConfig
from uniteam.mind.manipulation.arm_path import is_path_free, path_to
from uniteam.mind.manipulation.arm_reach import ArmReach
from uniteam.mind.manipulation.place.place import Aim, PlaceContext, Stand
from uniteam.mind.skills.view import Points

TIGHTEST_GAP = 0.02
"""m; between a surface and the lowest part of what is held over it."""
HEIGHT_PRICE = 0.1
"""What a metre of fall costs in worth, which is in metres from the edge: over a lamp half a metre high to a point 5 cm
farther from the edge, but not for less."""
ELBOW_ROOM = 0.4
"""m beyond the arm's reach; what is farther is out of its way."""
RAISED_WRIST = 0.5
"""rad; the gripper points up along the arm, which gets over what the lift alone does not."""


@dataclass(frozen=True)
class CheckedArmPath:
    """Aims at the best of the points that the arm reaches without touching anything seen.

    Attributes:
        extra_heights: how much higher than the release asks for the arm may go over what stands in its way, or how much
            lower under what is above it (m).
        wrist_pitches: others (rad) for where the arm gets to no point with the wrist as the release has it.
        sweep: the room the arm takes.
    """

    extra_heights: tuple[float, ...] = (0.0, 0.1, 0.2, 0.3, 0.4, 0.5, -0.06, -0.12)
    wrist_pitches: tuple[float, ...] = (RAISED_WRIST,)
    sweep: SweepConfig = field(default_factory=SweepConfig)

    def __call__(self, stand: Stand, context: PlaceContext) -> Aim | None:
        """Return the turn and the path to the best point and height that the arm reaches freely; None if none."""
        reaches = (context.release.reach, *(ArmReach.of_wrist(pitch) for pitch in self.wrist_pitches))
        aims = (self._aim(stand, context, reach) for reach in reaches)
        return next((aim for aim in aims if aim is not None), None)

    def _aim(self, stand: Stand, context: PlaceContext, reach: ArmReach) -> Aim | None:
        release, now = context.release, stand.view.observation.joints
        surroundings = stand.surroundings
        near = surroundings[np.hypot(surroundings[:, 0], surroundings[:, 1]) < reach.far + ELBOW_ROOM]
        worth = stand.candidates.worth[:, None] - HEIGHT_PRICE * np.abs(self.extra_heights)
        for flat in np.argsort(-worth, axis=None, kind="stable"):
            index, extra = divmod(int(flat), len(self.extra_heights))
            x, y, z = (float(value) for value in stand.candidates.points[index])
            angle = stand.line_up(reach.turn_to(x, y))
            lowest = z + context.load.below + TIGHTEST_GAP
            height = z + release.height_above_surface(context.load) + self.extra_heights[extra]
            if angle is None or not reach.reaches(x, y) or lowest > min(height, reach.high):
                continue
            path = path_to(now, reach.over(now, reach.distance_to(x, y), min(height, reach.high)))
            if is_path_free(path, _turned(near, angle), context.load, self.sweep):
                return Aim(stand.view, angle, path)
        return None


def _turned(points: Points, angle: float) -> Points:
    """Return the points in the frame of the base after it has turned by `angle` (rad)."""
    c, s = math.cos(angle), math.sin(angle)
    x, y, z = points.T
    return np.stack([c * x + s * y, -s * x + c * y, z], axis=-1)
