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
        self._rest = {name: physics.pose(name) for name in physics.names}
        self.restart()

    def restart(self) -> None:
        """Take note that every object is back where it was at first."""
        self.floor = self._at_first
        self._known = dict(self._rest)
        self._version = self._physics.version

    def update(self) -> None:
        """Bring the floor up to date where objects have moved and lie still again."""
        if self._physics.version == self._version or self._physics.is_moving:
            return
        self._version = self._physics.version
        poses = {name: self._physics.pose(name) for name in self._physics.names}
        moved = {name: pose for name, pose in poses.items() if np.abs(pose - self._known[name]).max() > _MOVED}
        if moved:
            self.floor = self.floor.with_moved(self._home, moved)
            self._known |= moved
