"""Reach a robot by its name: over the network, or here on the robot itself."""

from uniteam.errors import InvalidInputError
from uniteam.world.real.bridge_link import BridgeLink
from uniteam.world.real.channel import Channel
from uniteam.world.real.link import RobotLink
from uniteam.world.real.pace import Pace, Patience
from uniteam.world.real.safety import SafetyLimits
from uniteam.world.real.stretch_body_link import connect_stretch_body
from uniteam.world.real.system_clock import SystemClock
from uniteam.world.real.zmq_wire import ZmqWire

HERE = "here"
"""In place of a robot's name: this program runs on the robot, and reaches it through stretch_body."""


def connect(host: str, port: int, limits: SafetyLimits) -> RobotLink:
    """Return a link to a robot; nothing moves yet.

    Args:
        host: name or address of a robot that runs the bridge of stretch_ai, or `HERE`.
        port: the first of the bridge's four.
        limits: what the robot is to keep to.

    Raises:
        InvalidInputError: there are no four such ports.
        UniteamError: the robot cannot be reached.
    """
    if host == HERE:
        return connect_stretch_body(limits)
    if not 1 <= port <= 65_532:
        raise InvalidInputError(f"--port must be from 1 to 65532, for it is the first of four, got {port}")
    wire, pace, patience = ZmqWire(host, port), Pace(), Patience()
    try:
        return BridgeLink(Channel(wire, SystemClock(), limits.stale, pace, patience), limits, pace, patience)
    except BaseException:
        wire.close()
        raise
