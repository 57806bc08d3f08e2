"""A fake Stretch in a room of boxes, in lockstep or behind real ports on loopback, and a body that is quick with it."""

import random
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from worlds import judged_scene

from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Action, Observation
from uniteam.world.fake import joined
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.fake.bridge_messages import TruthOf, no_truth
from uniteam.world.fake.dials import Dials
from uniteam.world.fake.fake_stretch import FakeStretch
from uniteam.world.fake.lockstep import Lockstep
from uniteam.world.fake.zmq_server import RealTime
from uniteam.world.real.bridge_link import BridgeLink
from uniteam.world.real.channel import Channel, Wire
from uniteam.world.real.link import Clock
from uniteam.world.real.pace import Pace, Patience
from uniteam.world.real.safety import SafetyLimits
from uniteam.world.real.stretch_robot import StretchRobot, Watcher
from uniteam.world.real.system_clock import SystemClock
from uniteam.world.simulation.simulator import Simulator

SMALL_CAMERA = PinholeCamera.from_horizontal_fov(96, 128, np.radians(42.0))
EPISODE = replace(judged_scene.EPISODE, start=BasePose(3.0, 3.0, np.pi))
"""With 2.5 m of free floor ahead."""
AGILITY = 4.0
QUICK = Dials(agility=AGILITY, image_hz=30.0)
LIMITS = SafetyLimits(speed=0.6, turn_speed=1.6)
PACE = Pace(poll=0.01, command=0.03, gain=6.0, rest=0.1, settle=0.02)
HASTY = Patience(connect=3.0, acknowledge=2.0, obey=1.0, mode=3.0, motion=8.0, stall=0.6, picture=2.0, recover=0.6)
UNHURRIED = replace(HASTY, connect=20.0, acknowledge=10.0, obey=3.0, mode=10.0, stall=2.0, picture=10.0, recover=3.0)
"""For real time, on a machine that has little of it."""


def simulator(folder: Path) -> Simulator:
    """Return a room of boxes, compiled."""
    return Simulator(judged_scene.judged_home(folder), SMALL_CAMERA)


def bridge(world: Simulator, dials: Dials = QUICK) -> FakeBridge:
    """Return a fake robot's bridge at the start of its episode."""
    return FakeBridge(FakeStretch(world, EPISODE, dials))


def body(wire: Wire, clock: Clock, limits: SafetyLimits = LIMITS, watchers: tuple[Watcher, ...] = ()) -> StretchRobot:
    """Return a body that has been connected."""
    patience = UNHURRIED if isinstance(clock, SystemClock) else HASTY
    channel = Channel(wire, clock, limits.stale, PACE, patience)
    return StretchRobot(BridgeLink(channel, limits, PACE, patience), limits, watchers)


def lockstep_body(side: FakeBridge, limits: SafetyLimits = LIMITS, truth_of: TruthOf = no_truth) -> StretchRobot:
    """Return a body whose robot lives only while it is waited for."""
    line = Lockstep(side, side.robot.simulator.camera, truth_of)
    return body(line, line, limits)


@dataclass(frozen=True)
class Ports:
    """Where a robot is served: the first of four ports in a row."""

    first: int


@contextmanager
def served(side: FakeBridge, truth_of: TruthOf = no_truth) -> Iterator[Ports]:
    """Serve a fake robot on loopback, in a thread and in real time."""
    with joined.served(side, truth_of, RealTime()) as first:
        yield Ports(first)


def free_ports() -> int:
    """Return the first of four ports in a row that are most likely free."""
    return random.randrange(20_000, 32_000, 4)


def with_fence(radius: float) -> SafetyLimits:
    """Return the limits with another fence (m)."""
    return replace(LIMITS, fence=radius)


class Rewound:
    """A body whose robot is put back to where it began; nobody does that to a real one."""

    def __init__(self, fresh: Callable[[], StretchRobot]) -> None:
        """Take what returns the body of a robot that has not moved yet."""
        self._fresh = fresh

    def reset(self) -> Observation:
        """Begin again."""
        self._body = self._fresh()
        return self._body.reset()

    def step(self, action: Action) -> Observation:
        """Do an action."""
        return self._body.step(action)
