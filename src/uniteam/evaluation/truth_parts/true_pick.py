"""Picking by the truth: once an agent is at the object that the episode's certificate names, it is grasped as there."""

from collections.abc import Iterator

from uniteam.interface import Action
from uniteam.world.oracle.pilot import Pilot
from uniteam.world.task.environment import Environment

AT_THE_OBJECT = 1.5
"""An agent that begins to pick so near to the object (m) has come to it; from farther away it picks by itself."""


class TruePick:
    """Drives to the certified stand and grasps there.

    Attributes:
        state: of the agent in which this takes its place.
    """

    state = "PICK"

    def is_possible(self, environment: Environment) -> bool:
        """Return whether the certified object is near, and the gripper is empty."""
        certificate, simulator = environment.episode.certificate, environment.simulator
        if certificate is None or simulator.held is not None:
            return False
        x, y = simulator.object_pose(certificate.object)[:2, 3]
        return simulator.base.distance_to(float(x), float(y)) <= AT_THE_OBJECT

    def play(self, environment: Environment) -> Iterator[Action]:
        """Yield the actions; what the agent then does to pick finds the object in the gripper."""
        certificate = environment.episode.certificate
        assert certificate is not None
        pilot = Pilot(environment.simulator)
        yield from pilot.stand(certificate.grasp)
        yield from pilot.grasp(certificate.grasp_joints)
