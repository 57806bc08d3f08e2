"""A robot that is looked at and not moved: for those who want to see first what would be done."""

from collections.abc import Iterator

from uniteam.interface import Joints
from uniteam.world.real.link import RobotLink, RobotState, View


class DryRunLink:
    """Passes pictures on, and sends the robot nothing whatever."""

    def __init__(self, link: RobotLink) -> None:
        """Take a robot that has been connected to."""
        self._link = link

    def glance(self) -> View:
        """Return the next picture."""
        return self._link.glance()

    def look(self) -> View:
        """Return the next picture; nothing was asked for, so none need be waited for."""
        return self._link.glance()

    def turn(self, angle: float) -> Iterator[RobotState]:
        """Do not turn."""
        return iter(())

    def translate(self, distance: float) -> Iterator[RobotState]:
        """Do not drive."""
        return iter(())

    def move_joints(self, joints: Joints) -> Iterator[RobotState]:
        """Do not move the joints."""
        return iter(())

    def grip(self, closed: bool) -> Iterator[RobotState]:
        """Do not move the gripper."""
        return iter(())

    def recover(self) -> None:
        """Wait for a robot that fell silent."""
        self._link.recover()

    def halt(self) -> None:
        """Do nothing: nothing was begun."""

    def close(self) -> None:
        """Let go of the robot."""
        self._link.close()
