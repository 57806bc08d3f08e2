"""A home that is compiled, with what its episodes have in common."""

import numpy as np
from numpy.typing import NDArray

from uniteam.adapters.gymnasium.goals import distances_from
from uniteam.geometry import PinholeCamera, Point2
from uniteam.world.homes.home import Home
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.episode import Candidate


class OpenHome:
    """A home with the robot in it.

    Attributes:
        home: as it was given.
        simulator: of the home.
    """

    def __init__(self, home: Home, camera: PinholeCamera) -> None:
        """Compile the home, which takes about a second."""
        self.home = home
        self.simulator = Simulator(home, camera)
        self._floor = self.simulator.floor
        self._distances: dict[str, NDArray[np.float32]] = {}

    def distances(self, candidate: Candidate) -> NDArray[np.float32]:
        """Return the (R, C) lengths of the ways (m) to a candidate's view points over the floor as it is at first."""
        if candidate.name not in self._distances:
            self._distances[candidate.name] = distances_from(self._floor, candidate.view_points)
        return self._distances[candidate.name]

    def middle(self, name: str) -> Point2:
        """Return where an instance is on the floor (x, y) (m, world)."""
        instance = self.home.by_name[name]
        x, y, _ = self.simulator.object_pose(name)[:3, 3] if instance.movable else instance.position
        return float(x), float(y)
