"""The two ways in which a body is joined to a fake robot whose time waits for it: directly, and over real ports."""

import socket
import threading
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, ExitStack, contextmanager, suppress
from dataclasses import replace

from uniteam.errors import UnavailableError
from uniteam.world.fake.awaited_time import AwaitedTime
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.fake.bridge_messages import TruthOf
from uniteam.world.fake.lockstep import Lockstep
from uniteam.world.fake.zmq_server import Wait, ZmqServer
from uniteam.world.real.bridge_link import BridgeLink
from uniteam.world.real.channel import Channel
from uniteam.world.real.pace import Pace, Patience
from uniteam.world.real.safety import SafetyLimits
from uniteam.world.real.stretch_robot import StretchRobot
from uniteam.world.real.zmq_wire import ZmqWire

Join = Callable[[FakeBridge, TruthOf], AbstractContextManager[StretchRobot]]
"""From a fake robot's bridge, and what of the truth its pictures carry, to the body that acts through it."""

WIDE_FENCE = 100.0
"""m: a simulated home needs none."""
UNHURRIED = Patience(connect=100.0)
"""Of sockets that need some time of the machine's to be connected, while the robot's passes faster."""
LENIENT = 2.0
"""s of the robot's time that a busy machine may take to carry a message."""
LOOPBACK = "127.0.0.1"
_TRIES, _LAST_FIRST_PORT = 20, 65_532


@contextmanager
def in_lockstep(bridge: FakeBridge, truth_of: TruthOf) -> Iterator[StretchRobot]:
    """Give the body of a fake robot whose time passes only while it is waited for, at limits that suit its motors."""
    agility, camera = bridge.robot.dials.agility, bridge.robot.simulator.camera
    line, limits, pace = Lockstep(bridge, camera, truth_of), limits_at(agility), pace_at(agility)
    channel = Channel(line, line, limits.stale, pace, Patience())
    yield StretchRobot(BridgeLink(channel, limits, pace, Patience()), limits)


@contextmanager
def over_sockets(bridge: FakeBridge, truth_of: TruthOf) -> Iterator[StretchRobot]:
    """Give the body of a fake robot that is served on four ports of this machine, and end it afterwards.

    Time passes only while it is waited for here too, so that a busy machine makes no worse a robot. What is left to
    chance is whether a message arrives in the moment in which it was sent or in the next.

    Raises:
        UnavailableError: pyzmq is not installed, or no four ports in a row are free.
    """
    agility = bridge.robot.dials.agility
    limits, pace = replace(limits_at(agility), stale=LENIENT), pace_at(agility)
    clock = AwaitedTime(bridge.robot)
    with served(bridge, truth_of, clock.hold) as first_port, ExitStack() as at_last:
        at_last.callback(clock.end)
        wire = ZmqWire(LOOPBACK, first_port)
        at_last.callback(wire.close)
        channel = Channel(wire, clock, limits.stale, pace, UNHURRIED)
        yield StretchRobot(BridgeLink(channel, limits, pace, UNHURRIED), limits)


@contextmanager
def served(bridge: FakeBridge, truth_of: TruthOf, wait: Wait) -> Iterator[int]:
    """Let a robot live behind four ports of this machine, in a thread, and give the first of them.

    Args:
        bridge: the robot's.
        truth_of: what of the truth its pictures carry.
        wait: is called before each of its moments.

    Raises:
        UnavailableError: pyzmq is not installed, or no four ports in a row are free.
    """
    server, first_port = _bound(bridge, truth_of)
    is_over = threading.Event()
    thread = threading.Thread(target=server.serve, args=(lambda: not is_over.is_set(), wait))
    thread.start()
    try:
        yield first_port
    finally:
        is_over.set()
        thread.join()


def _bound(bridge: FakeBridge, truth_of: TruthOf) -> tuple[ZmqServer, int]:
    """Return a server and the first of its ports; of those that are free another program may be quicker to take one."""
    for _ in range(_TRIES - 1):
        with suppress(UnavailableError):
            return _bound_once(bridge, truth_of)
    return _bound_once(bridge, truth_of)


def _bound_once(bridge: FakeBridge, truth_of: TruthOf) -> tuple[ZmqServer, int]:
    with socket.socket() as free:
        free.bind((LOOPBACK, 0))
        first_port = min(int(free.getsockname()[1]), _LAST_FIRST_PORT)
    return ZmqServer(bridge, bridge.robot.simulator.camera, truth_of, (LOOPBACK, first_port)), first_port


def limits_at(agility: float) -> SafetyLimits:
    """Return the usual limits for motors that are some times as quick as a Stretch's, without a fence."""
    usual = SafetyLimits()
    return replace(usual, speed=usual.speed * agility, turn_speed=usual.turn_speed * agility, fence=WIDE_FENCE)


def pace_at(agility: float) -> Pace:
    """Return the usual pace for such motors."""
    usual = Pace()
    return replace(
        usual,
        command=usual.command / agility,
        gain=usual.gain * agility,
        rest=usual.rest / agility,
        settle=usual.settle / agility,
    )
