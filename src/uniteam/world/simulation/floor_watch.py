"""Keeps the navigable floor true while objects are taken from it and fall onto it."""

import numpy as np

from uniteam.world.homes.home import Home
from uniteam.world.physics.navigable_floor import NavigableFloor
from uniteam.world.physics.physics import Physics

_MOVED = 0.01
"""What has moved less (m), at any of its axes' ends, is where it was."""


class FloorWatch:
    """Watches a home's objects.

    Attributes:
        floor: where the base can stand, with every object where it lay when nothing moved last.
    """

    def __init__(self, home: Home, physics: Physics) -> None:
        """Take the objects as they are now: they have come to rest."""
        self._home, self._physics = home, physics
        self._at_first = NavigableFloor(home)
        self._rest = physics.poses()
        self.restart()

    def restart(self) -> None:
        """Take note that every object is back where it was at first."""
        self.floor = self._at_first
        self._known = self._rest.copy()
        self._version = self._physics.version

    def update(self) -> None:
        """Bring the floor up to date where objects have moved and lie still again."""
        if self._physics.version == self._version or self._physics.is_moving:
            return
        self._version = self._physics.version
        poses = self._physics.poses()
        moved = np.flatnonzero((np.abs(poses - self._known) > _MOVED).any(axis=(1, 2)))
        if len(moved):
            names = self._physics.names
            self.floor = self.floor.with_moved(self._home, {names[k]: poses[k] for k in moved})
            self._known[moved] = poses[moved]
