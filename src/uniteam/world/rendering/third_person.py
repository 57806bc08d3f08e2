"""Where to watch the robot from: above and beside it, on a side where no wall stands in between."""

import math

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose, wrap_angle
from uniteam.world.homes.fixed_mesh import wall_lines
from uniteam.world.homes.home import Stage

HEIGHT = 3.6
"""Of the camera above the floor (m)."""
REACH = 2.3
"""From the robot to the point below the camera (m)."""
TARGET_HEIGHT = 0.7
"""Of the point on the robot that the camera looks at (m)."""
CLEAR = 1.7
"""A wall nearer to the robot than this (m) would hide it, as walls are about 2.5 m high."""

_WALL_HEIGHT = 1.5
"""What a stage's mesh has at this height counts as walls (m)."""

_FIRST = math.radians(-145.0)
_SIDES = tuple(wrap_angle(_FIRST + k * math.pi / 6.0) for k in range(12))


class Watcher:
    """Follows the robot, and changes sides only when a wall comes in between."""

    def __init__(self, stage: Stage) -> None:
        lines = wall_lines(stage, _WALL_HEIGHT)
        self._starts, self._ends = lines[:, 0], lines[:, 1]
        self._side = _SIDES[0]

    def pose(self, base: BasePose) -> NDArray[np.float64]:
        """Return the (4, 4) pose (world) of a camera that looks down on the robot; its image's upper edge is far."""
        if self._free(base, self._side) < CLEAR:
            self._side = max(_SIDES, key=lambda side: (self._free(base, side), -abs(wrap_angle(side - self._side))))
        position = np.array([base.x + REACH * math.cos(self._side), base.y + REACH * math.sin(self._side), HEIGHT])
        forward = np.array([base.x, base.y, TARGET_HEIGHT]) - position
        forward /= np.linalg.norm(forward)
        right = np.cross(forward, [0.0, 0.0, 1.0])
        right /= np.linalg.norm(right)
        pose = np.eye(4)
        pose[:3, :3] = np.column_stack([right, np.cross(forward, right), forward])
        pose[:3, 3] = position
        return pose

    def _free(self, base: BasePose, side: float) -> float:
        """Return the distance (m) from the robot to the first wall in a direction, `REACH` at most."""
        direction = np.array([math.cos(side), math.sin(side)])
        along = self._ends - self._starts
        to_start = self._starts - (base.x, base.y)
        turn = direction[0] * along[:, 1] - direction[1] * along[:, 0]
        safe = np.where(np.abs(turn) < 1e-9, np.inf, turn)
        distance = (to_start[:, 0] * along[:, 1] - to_start[:, 1] * along[:, 0]) / safe
        share = (to_start[:, 0] * direction[1] - to_start[:, 1] * direction[0]) / safe
        met = (distance > 0.0) & (share >= 0.0) & (share <= 1.0) & np.isfinite(safe)
        return min(float(distance[met].min(initial=REACH)), REACH)
