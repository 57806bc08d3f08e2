"""The two ways in which a body is joined to a fake robot: in a time that waits for it, and over real ports."""

import socket
import threading
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, suppress
from dataclasses import replace

from uniteam.errors import UnavailableError
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.fake.bridge_messages import TruthOf
from uniteam.world.fake.fake_stretch import TICK
from uniteam.world.fake.lockstep import Lockstep
from uniteam.world.fake.zmq_server import ZmqServer
from uniteam.world.real.bridge_link import BridgeLink
from uniteam.world.real.channel import Channel
from uniteam.world.real.pace import Pace, Patience
from uniteam.world.real.safety import SafetyLimits
from uniteam.world.real.stretch_robot import StretchRobot
from uniteam.world.real.system_clock import SystemClock
from uniteam.world.real.zmq_wire import ZmqWire

Join = Callable[[FakeBridge, TruthOf], AbstractContextManager[StretchRobot]]
"""From a fake robot's bridge, and what of the truth its pictures carry, to the body that acts through it."""

WIDE_FENCE = 100.0
"""m: a simulated home needs none."""
UNHURRIED = Patience(obey=5.0)
"""In real time on a machine that may have other things to do."""
LENIENT = 2.0
"""s for which such a machine may be silent."""
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

    Raises:
        UnavailableError: pyzmq is not installed, or no four ports in a row are free.
    """
    agility = bridge.robot.dials.agility
    limits, pace = replace(limits_at(agility), stale=LENIENT), replace(pace_at(agility), poll=TICK)
    with served(bridge, truth_of) as first_port:
        channel = Channel(ZmqWire(LOOPBACK, first_port), SystemClock(), limits.stale, pace, UNHURRIED)
        try:
            yield StretchRobot(BridgeLink(channel, limits, pace, UNHURRIED), limits)
        finally:
            channel.close()


@contextmanager
def served(bridge: FakeBridge, truth_of: TruthOf) -> Iterator[int]:
    """Let a robot live behind four ports of this machine, in a thread, and give the first of them.

    Raises:
        UnavailableError: pyzmq is not installed, or no four ports in a row are free.
    """
    server, first_port = _bound(bridge, truth_of)
    is_over = threading.Event()
    thread = threading.Thread(target=server.serve, args=(lambda: not is_over.is_set(),))
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
