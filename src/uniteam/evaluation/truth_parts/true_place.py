"""Placing by the truth: once an agent is at the certified receptacle, the object is put down as certified."""

from collections.abc import Iterator

import numpy as np

from uniteam.interface import Action, DiscreteAction
from uniteam.world.oracle.oracle import MOST_WAITING
from uniteam.world.oracle.pilot import Pilot
from uniteam.world.task.environment import Environment
from uniteam.world.task.footprint import distance_to_footprint

AT_THE_RECEPTACLE = 1.0
"""An agent that begins to place so near to the receptacle (m) has come to it; from farther away it places by itself."""


class TruePlace:
    """Drives to the certified stand, releases there, waits until the object lies, and ends the episode.

    Attributes:
        state: of the agent in which this takes its place.
    """

    state = "PLACE"

    def is_possible(self, environment: Environment) -> bool:
        """Return whether the certified object is in the gripper, and the certified receptacle near."""
        certificate, simulator = environment.episode.certificate, environment.simulator
        if certificate is None or simulator.held != certificate.object:
            return False
        receptacle, here = environment.home.by_name[certificate.receptacle], (simulator.base.x, simulator.base.y)
        return bool(distance_to_footprint(environment.home, receptacle, np.array(here)) <= AT_THE_RECEPTACLE)

    def play(self, environment: Environment) -> Iterator[Action]:
        """Yield the actions; where the object did not come to lie on the goal, the agent goes on by itself."""
        certificate = environment.episode.certificate
        assert certificate is not None
        pilot = Pilot(environment.simulator)
        yield from pilot.stand(certificate.release)
        yield from pilot.release(certificate.release_joints, certificate.release_rise)
        for _ in range(MOST_WAITING):
            if environment.measures.place_success:
                yield DiscreteAction.STOP
            yield DiscreteAction.EMPTY_ACTION
        yield DiscreteAction.NAVIGATION_MODE
