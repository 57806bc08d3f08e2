"""Compiled simulators kept for the next episode of the same home."""

from uniteam.geometry import PinholeCamera
from uniteam.world.homes.home import Home
from uniteam.world.simulation.simulator import Simulator


class SimulatorPool:
    """Lends simulators out, one borrower each, and keeps the last few that came back."""

    def __init__(self, capacity: int) -> None:
        self._capacity = capacity
        self._idle: list[tuple[Home, PinholeCamera, Simulator]] = []

    def take(self, home: Home, camera: PinholeCamera) -> Simulator:
        """Return an idle simulator of this home and camera, or compile one."""
        for i in reversed(range(len(self._idle))):
            idle_home, idle_camera, simulator = self._idle[i]
            if idle_home.name == home.name and idle_camera == camera and idle_home == home:
                del self._idle[i]
                return simulator
        return Simulator(home, camera)

    def give_back(self, home: Home, camera: PinholeCamera, simulator: Simulator) -> None:
        """Keep a simulator for its next borrower and forget the one that has been idle longest."""
        self._idle.append((home, camera, simulator))
        del self._idle[: -self._capacity]
