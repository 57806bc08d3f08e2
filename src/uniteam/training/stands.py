"""Where a camera stands to see a home as a robot does: facing its things, in either posture, or anywhere."""

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.interface import Joints
from uniteam.stretch import MANIPULATION_POSTURE, NAVIGATION_POSTURE
from uniteam.world.homes.home import Home
from uniteam.world.physics.navigable_floor import NavigableFloor

FACING = 2 / 3
"""Share of the stands that face a thing; the others look anywhere."""
MANIPULATING = 1 / 3
"""Share of those in the posture in which the arm points at the thing."""
NEAREST, FARTHEST = 0.5, 3.0
"""m, to what is faced."""
REACH = 1.3
"""m, to what is faced with the arm."""
OF_OBJECTS = 0.75
"""Share of the faced things that are small objects; the others are receptacles and decor."""


@dataclass(frozen=True)
class Stand:
    """A pose of the robot: its base (world) and its joints."""

    base: BasePose
    joints: Joints


class Stands:
    """Draws stands in a home."""

    def __init__(self, home: Home, rng: Generator) -> None:
        """Find where the robot gets to."""
        floor = NavigableFloor(home)
        cells = np.argwhere(floor.largest_component)
        self._free = np.array([floor.to_point(int(row), int(column)) for row, column in cells])
        self._rng = rng
        points = [(instance.movable, instance.position[:2]) for instance in home.instances]
        self._objects = np.array([point for movable, point in points if movable]).reshape(-1, 2)
        self._furniture = np.array([point for movable, point in points if not movable]).reshape(-1, 2)

    def draw(self) -> Stand:
        """Return another one."""
        rng = self._rng
        if rng.random() >= FACING:
            return Stand(
                BasePose(*self._anywhere(), rng.uniform(-math.pi, math.pi)), self._jittered(NAVIGATION_POSTURE)
            )
        targets = self._objects if rng.random() < OF_OBJECTS and len(self._objects) else self._furniture
        target = targets[rng.integers(len(targets))]
        manipulates = rng.random() < MANIPULATING
        x, y = self._near(target, REACH if manipulates else FARTHEST)
        bearing = math.atan2(target[1] - y, target[0] - x) + rng.normal(0.0, math.radians(8.0))
        if manipulates:
            return Stand(BasePose(x, y, bearing + math.pi / 2.0), self._jittered(MANIPULATION_POSTURE))
        return Stand(BasePose(x, y, bearing), self._jittered(NAVIGATION_POSTURE))

    def _anywhere(self) -> tuple[float, float]:
        x, y = self._free[self._rng.integers(len(self._free))]
        return float(x), float(y)

    def _near(self, target: NDArray[np.float64], farthest: float) -> tuple[float, float]:
        """Return a free point at a distance that is drawn evenly, or the nearest to it that there is."""
        wanted = self._rng.uniform(NEAREST, farthest)
        off = np.abs(np.linalg.norm(self._free - target, axis=1) - wanted)
        good = np.flatnonzero(off <= max(0.05, float(off.min())))
        x, y = self._free[good[self._rng.integers(len(good))]]
        return float(x), float(y)

    def _jittered(self, posture: Joints) -> Joints:
        rng = self._rng
        return replace(
            posture,
            head_tilt=posture.head_tilt + rng.normal(0.0, math.radians(7.0)),
            head_pan=posture.head_pan + rng.normal(0.0, math.radians(2.0)),
            lift=rng.uniform(0.3, 1.05),
        )
