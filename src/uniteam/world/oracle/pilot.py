"""Moving the robot by the truth: driving to stands, grasping and releasing there, as actions.

What is yielded next depends on where the simulator has brought the robot, so each action must be done before the next
one is asked for.
"""

from collections.abc import Iterator
from dataclasses import replace

from uniteam.geometry import BasePose, Point2
from uniteam.interface import Action, DiscreteAction, JointDisplacement, Joints
from uniteam.stretch import NAVIGATION_POSTURE
from uniteam.world.oracle.base_driving import to_point, turn
from uniteam.world.oracle.base_stands import approach
from uniteam.world.oracle.true_paths import PathField
from uniteam.world.simulation.simulator import Simulator

_ARRIVED = 1e-3


class Pilot:
    """Knows where the robot of a simulator is, and what would bring it elsewhere."""

    def __init__(self, simulator: Simulator) -> None:
        """Take the simulator to act in."""
        self._simulator = simulator

    def drive(self, goal: Point2) -> Iterator[Action]:
        """Yield the actions that bring the base to a point (m, world); none where there is no way."""
        if self._simulator.base.distance_to(*goal) < _ARRIVED:
            return
        here = self._simulator.base
        for point in PathField(self._simulator.floor, goal).path_from(here.x, here.y):
            yield from to_point(self._simulator.base, point)

    def stand(self, pose: BasePose) -> Iterator[Action]:
        """Yield the actions that bring the base to a pose (world)."""
        yield from self.drive((pose.x, pose.y))
        yield from turn(pose.heading - self._simulator.base.heading)

    def face(self, point: Point2) -> Iterator[Action]:
        """Yield the actions that turn the base to a point (m, world)."""
        yield from turn(self._simulator.base.bearing_to(*point))

    def tilt_head(self, angle: float) -> Iterator[Action]:
        """Yield the action that tilts the head by an angle (rad) from where it is in navigation, up where positive."""
        joints = self._simulator.joints
        yield from self._pose(replace(joints, head_tilt=NAVIGATION_POSTURE.head_tilt + angle))

    def grasp(self, joints: Joints) -> Iterator[Action]:
        """Yield the actions that grasp, at a posture, what is in front of the robot."""
        yield DiscreteAction.MANIPULATION_MODE
        yield from self._pose(joints)
        yield DiscreteAction.SNAP_OBJECT
        yield DiscreteAction.NAVIGATION_MODE

    def release(self, joints: Joints, rise: float) -> Iterator[Action]:
        """Yield the actions that release what is held at a posture, in front of the robot, from `rise` (m) higher."""
        yield DiscreteAction.MANIPULATION_MODE
        for posture in approach(joints, rise):
            yield from self._pose(posture)
        yield DiscreteAction.DESNAP_OBJECT

    def _pose(self, joints: Joints) -> Iterator[Action]:
        if joints != self._simulator.joints:
            yield JointDisplacement(joints - self._simulator.joints)
