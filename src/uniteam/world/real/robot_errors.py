"""What ends a run on a robot; the base has been told to stop before any of them reaches whoever called."""

from uniteam.errors import UniteamError


class RobotError(UniteamError):
    """The robot cannot go on."""


class SilentRobotError(RobotError):
    """The robot sends nothing, nothing new, or does not take what is sent to it."""


class StrangeMessageError(RobotError):
    """What came from the other side is not a message of a Stretch; nothing of it was run or used."""


class RunStopError(RobotError):
    """Somebody stopped the run: by the robot's button, or by a key."""


class UnsafeMotionError(RobotError):
    """The robot went where, or did what, it was not to."""
