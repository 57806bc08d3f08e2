"""The time of a fake robot that lives in another thread: it passes only while somebody waits for it."""

import threading
import time

from uniteam.world.fake.fake_stretch import FakeStretch
from uniteam.world.real.robot_errors import SilentRobotError

CARRIAGE = 0.001
"""s that the machine is given to carry to their reader the messages of the moment that was waited for."""
PATIENCE = 60.0
"""s of the machine's time after which a robot that does not get there is given up."""


class AwaitedTime:
    """A clock on one side; on the other what holds the robot until it is waited for."""

    def __init__(self, robot: FakeStretch) -> None:
        """Take a robot whose every moment comes after `hold`."""
        self._robot, self._until, self._is_over = robot, robot.time, False
        self._changed = threading.Condition()

    def now(self) -> float:
        """Return the robot's time (s)."""
        return self._robot.time

    def sleep(self, seconds: float) -> None:
        """Wait until some of the robot's time has passed; raises SilentRobotError where it does not."""
        with self._changed:
            self._until = self._robot.time + seconds
            self._changed.notify_all()
            if not self._changed.wait_for(lambda: not self._is_awaited, PATIENCE):
                raise SilentRobotError(f"the fake robot did not live on in {PATIENCE:g} s; see why it has ended")
        time.sleep(CARRIAGE)

    def hold(self, robot_time: float) -> None:
        """Keep the robot from its next moment until that is waited for, or all is over."""
        with self._changed:
            self._changed.notify_all()
            self._changed.wait_for(lambda: self._is_awaited or self._is_over)

    def end(self) -> None:
        """Hold the robot no more."""
        with self._changed:
            self._is_over = True
            self._changed.notify_all()

    @property
    def _is_awaited(self) -> bool:
        return self._robot.time < self._until - 1e-9
