"""Whatever a peer sends while the base drives: no code runs, the base is told to stop, one sentence says why."""

import os
import pickle
import threading
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from worlds.fake_robot import LIMITS, body, served
from worlds.go_between import GoBetween, Spoil, between

from uniteam.interface import DiscreteAction
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.real.restricted_pickle import MOST_BYTES
from uniteam.world.real.robot_errors import RobotError, RunStopError, SilentRobotError, StrangeMessageError
from uniteam.world.real.stretch_robot import StretchRobot
from uniteam.world.real.system_clock import SystemClock
from uniteam.world.real.zmq_wire import ZmqWire

pytest.importorskip("zmq", reason="the extra 'robot' is not installed")


PATIENT = replace(LIMITS, stale=1.5)
"""These tests are about what happens, also where the machine is busy; `test_watchdog` is about when."""


@pytest.fixture
def peer(side: FakeBridge) -> Iterator[GoBetween]:
    with served(side) as ports, between(ports.first) as go_between:
        yield go_between


@pytest.fixture
def robot(peer: GoBetween) -> Iterator[StretchRobot]:
    driver = body(ZmqWire("127.0.0.1", peer.first), SystemClock(), PATIENT)
    yield driver
    driver.close()


def changed(port: str, **changes: Any) -> Spoil:
    """Return what changes fields of the messages of a port."""

    def spoil(name: str, message: bytes) -> list[list[bytes]]:
        fields = pickle.loads(message)
        return [[pickle.dumps({**fields, **changes} if name == port else fields)]]

    return spoil


class Payload:
    """What runs a command where it is unpickled."""

    def __init__(self, command: str) -> None:
        self.command = command

    def __reduce__(self) -> tuple[Any, ...]:
        return os.system, (self.command,)


def driven_into(peer: GoBetween, robot: StretchRobot, spoil: Spoil) -> RobotError:
    """Drive ahead, have the peer begin to spoil what it sends meanwhile, and return what that was answered with."""
    robot.reset()
    peer.spoil_once_driving = spoil
    with pytest.raises(RobotError) as raised:
        robot.step(DiscreteAction.MOVE_FORWARD)
    return raised.value


def check_stopped(peer: GoBetween, side: FakeBridge) -> None:
    """Check that the base was told to stop, and does not move."""
    time.sleep(0.15)
    assert peer.last_velocity() == {"v": 0.0, "w": 0.0}
    stands = side.robot.base
    time.sleep(0.15)
    assert side.robot.base == stands


def test_a_payload_is_not_run(peer: GoBetween, robot: StretchRobot, side: FakeBridge, tmp_path: Path) -> None:
    marker = tmp_path / "it_ran"
    error = driven_into(peer, robot, lambda name, message: [[pickle.dumps(Payload(f"touch {marker}"))]])
    assert isinstance(error, StrangeMessageError)
    assert "nothing of it run: it asks for posix.system" in str(error)
    check_stopped(peer, side)
    assert not marker.exists()


def test_a_payload_in_an_array_of_objects_is_not_run(
    peer: GoBetween, robot: StretchRobot, side: FakeBridge, tmp_path: Path
) -> None:
    marker = tmp_path / "it_ran"
    hidden = np.array([Payload(f"touch {marker}"), 0], object)
    error = driven_into(peer, robot, changed("state", joint_positions=hidden))
    assert isinstance(error, StrangeMessageError)
    check_stopped(peer, side)
    assert not marker.exists()


@pytest.mark.parametrize(
    ("spoil", "sentence"),
    [
        (changed("state", base_pose=np.zeros(2)), "'base_pose' of a state message must be numbers of shape (3,)"),
        (changed("state", joint_positions=np.zeros(10)), "'joint_positions' of a state message must be numbers"),
        (changed("observation", camera_pose=np.zeros((4, 4))), "'camera_pose' of an observation message must be"),
        (changed("observation", gps=None), "'gps' of an observation message must be numbers of shape (2,)"),
        (changed("state", is_runstopped=0), "'is_runstopped' of a state message must be True or False"),
    ],
)
def test_wrong_shapes_stop_the_base(
    peer: GoBetween, robot: StretchRobot, side: FakeBridge, spoil: Spoil, sentence: str
) -> None:
    error = driven_into(peer, robot, spoil)
    assert isinstance(error, StrangeMessageError)
    assert sentence in str(error).replace("a observation", "an observation")
    check_stopped(peer, side)


@pytest.mark.parametrize(
    "spoil",
    [
        changed("state", base_pose=np.array([0.0, np.nan, 0.0])),
        changed("state", base_pose=np.array([np.inf, 0.0, 0.0])),
        changed("observation", camera_pose=np.full((4, 4), np.nan)),
    ],
)
def test_numbers_that_are_none_stop_the_base(
    peer: GoBetween, robot: StretchRobot, side: FakeBridge, spoil: Spoil
) -> None:
    error = driven_into(peer, robot, spoil)
    assert isinstance(error, StrangeMessageError)
    assert "is not finite" in str(error)
    check_stopped(peer, side)


def test_messages_of_before_stop_the_base(peer: GoBetween, robot: StretchRobot, side: FakeBridge) -> None:
    first: dict[str, bytes] = {}
    error = driven_into(peer, robot, lambda name, message: [[first.setdefault(name, message)]])
    assert isinstance(error, SilentRobotError)
    assert "has taken no velocity" in str(error) or "did not acknowledge" in str(error)
    check_stopped(peer, side)


def test_silence_stops_the_base(peer: GoBetween, robot: StretchRobot, side: FakeBridge) -> None:
    error = driven_into(peer, robot, lambda name, message: [])
    assert isinstance(error, SilentRobotError)
    assert "was not heard again" in str(error)
    check_stopped(peer, side)


def test_pictures_that_stay_away_stop_the_base(peer: GoBetween, robot: StretchRobot, side: FakeBridge) -> None:
    error = driven_into(peer, robot, lambda name, message: [] if name == "observation" else [[message]])
    assert isinstance(error, SilentRobotError)
    assert "no picture (port 4401) came" in str(error)
    check_stopped(peer, side)


def test_a_flood_of_messages_changes_nothing(peer: GoBetween, robot: StretchRobot, side: FakeBridge) -> None:
    robot.reset()
    peer.spoil_once_driving = lambda name, message: [[message]] * 50
    seen = robot.step(DiscreteAction.MOVE_FORWARD)
    assert peer.spoils_from < float("inf")
    assert seen.base_to_start.x == pytest.approx(0.25, abs=0.02)


def test_a_flood_of_huge_messages_is_not_received(peer: GoBetween, robot: StretchRobot, side: FakeBridge) -> None:
    huge = bytes(MOST_BYTES + 1)
    error = driven_into(peer, robot, lambda name, message: [[huge]])
    assert isinstance(error, SilentRobotError)
    check_stopped(peer, side)


def test_half_messages_stop_the_base(peer: GoBetween, robot: StretchRobot, side: FakeBridge) -> None:
    error = driven_into(peer, robot, lambda name, message: [[message[: len(message) // 2]]])
    assert isinstance(error, StrangeMessageError)
    assert "is no whole pickle" in str(error)
    check_stopped(peer, side)


def test_messages_in_two_parts_stop_the_base(peer: GoBetween, robot: StretchRobot, side: FakeBridge) -> None:
    error = driven_into(peer, robot, lambda name, message: [[message[:100], message[100:]]])
    assert isinstance(error, RobotError)
    check_stopped(peer, side)


def test_half_a_picture_stops_the_run(peer: GoBetween, robot: StretchRobot, side: FakeBridge) -> None:
    def halved(name: str, message: bytes) -> list[list[bytes]]:
        fields = pickle.loads(message)
        if name == "observation":
            fields["rgb"] = fields["rgb"][: len(fields["rgb"]) // 2]
        return [[pickle.dumps(fields)]]

    error = driven_into(peer, robot, halved)
    assert isinstance(error, StrangeMessageError)
    assert "is cut short" in str(error)
    check_stopped(peer, side)


def test_the_run_stop_ends_the_run(peer: GoBetween, robot: StretchRobot, side: FakeBridge) -> None:
    def press(name: str, message: bytes) -> list[list[bytes]]:
        side.robot.press_run_stop()
        return [[message]]

    error = driven_into(peer, robot, press)
    assert isinstance(error, RunStopError)
    assert "run-stop is engaged" in str(error)
    check_stopped(peer, side)
    with pytest.raises(RunStopError):
        robot.step(DiscreteAction.MOVE_FORWARD)


def test_another_program_that_drives_ends_the_run(peer: GoBetween, robot: StretchRobot, side: FakeBridge) -> None:
    error = driven_into(peer, robot, changed("state", step=10_000))
    assert "obeys another program as well" in str(error)
    check_stopped(peer, side)


def test_an_exception_of_our_own_stops_the_base(peer: GoBetween, side: FakeBridge) -> None:
    class CtrlC(KeyboardInterrupt):
        pass

    driving = threading.Event()

    def watch(state: object) -> None:
        if driving.is_set() and peer.actions[-1][1].get("base_velocity", {}).get("v", 0.0) > 0.0:
            raise CtrlC

    driver = body(ZmqWire("127.0.0.1", peer.first), SystemClock(), PATIENT, watchers=(watch,))
    driver.reset()
    driving.set()
    with pytest.raises(CtrlC):
        driver.step(DiscreteAction.MOVE_FORWARD)
    check_stopped(peer, side)
    driver.close()
