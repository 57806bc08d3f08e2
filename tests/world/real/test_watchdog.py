"""When a base is stopped: to the hundredth of a second, for the robot's time passes only while it is waited for."""

import math
import pickle
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from worlds.fake_robot import LIMITS, body

from uniteam.interface import BaseDisplacement, Joints
from uniteam.stretch import NAVIGATION_POSTURE
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.fake.bridge_messages import no_truth
from uniteam.world.fake.lockstep import Lockstep
from uniteam.world.real.robot_errors import RobotError, SilentRobotError, StrangeMessageError

Spoil = Callable[[bytes], bytes | None]


class Spoiled(Lockstep):
    """A wire on which messages are spoiled, once the base is driven.

    Attributes:
        driven_at: since when that is (s).
        stopped_at: when the base was told to stop after that.
    """

    def __init__(self, side: FakeBridge, state: Spoil, observation: Spoil) -> None:
        super().__init__(side, side.robot.simulator.camera, no_truth)
        self._state, self._observation = state, observation
        self.driven_at = self.stopped_at = math.inf

    def newest_state(self) -> bytes | None:
        message = super().newest_state()
        return self._state(message) if message is not None and self.driven_at < math.inf else message

    def newest_observation(self) -> bytes | None:
        message = super().newest_observation()
        return self._observation(message) if message is not None and self.driven_at < math.inf else message

    def send(self, action: bytes) -> None:
        velocity = pickle.loads(action).get("base_velocity", {"v": 0.0})
        if velocity["v"] > 0.0:
            self.driven_at = min(self.driven_at, self.now())
        elif self.driven_at < math.inf:
            self.stopped_at = min(self.stopped_at, self.now())
        super().send(action)


def driven(side: FakeBridge, state: Spoil, observation: Spoil) -> tuple[RobotError, float]:
    """Drive, and return what that was answered with and how long the base was driven (s)."""
    line = Spoiled(side, state, observation)
    robot = body(line, line)
    robot.reset()
    with pytest.raises(RobotError) as raised:
        robot.step(BaseDisplacement(x=1.0))
    assert side.robot.motors._wanted == (0.0, 0.0)
    return raised.value, line.stopped_at - line.driven_at


def kept(message: bytes) -> bytes:
    return message


def silence(message: bytes) -> None:
    return None


def with_field(key: str, value: Any) -> Spoil:
    return lambda message: pickle.dumps({**pickle.loads(message), key: value})


def test_without_states_it_waits_after_a_quarter_of_a_second_and_ends_after_half(side: FakeBridge) -> None:
    error, seconds = driven(side, silence, kept)
    assert isinstance(error, SilentRobotError)
    assert seconds == pytest.approx(LIMITS.stale / 2, abs=0.05)


def test_without_pictures_the_base_is_stopped_after_half_a_second(side: FakeBridge) -> None:
    error, seconds = driven(side, kept, silence)
    assert isinstance(error, SilentRobotError)
    assert seconds == pytest.approx(LIMITS.stale, abs=0.05)


@pytest.mark.parametrize(
    ("state", "observation"),
    [
        (lambda message: message[:50], kept),
        (kept, lambda message: message[:-1]),
        (with_field("base_pose", np.full(3, np.nan)), kept),
        (with_field("joint_positions", np.zeros(3)), kept),
        (kept, with_field("camera_pose", np.zeros((4, 4)))),
        (kept, with_field("joint", np.full(11, np.inf))),
    ],
)
def test_a_strange_message_stops_the_base_at_once(side: FakeBridge, state: Spoil, observation: Spoil) -> None:
    error, seconds = driven(side, state, observation)
    assert isinstance(error, StrangeMessageError)
    assert seconds < 0.06  # the next picture comes after a thirtieth of a second


def test_the_button_stops_the_run_at_once(side: FakeBridge) -> None:
    error, seconds = driven(side, with_field("is_runstopped", True), kept)
    assert "run-stop is engaged" in str(error)
    assert seconds < 0.03


def test_a_robot_that_only_repeats_itself_is_not_driven_for_long(side: FakeBridge) -> None:
    first: list[bytes] = []

    def again(message: bytes) -> bytes:
        first.append(message)
        return first[0]

    error, seconds = driven(side, again, kept)
    assert "has taken no velocity" in str(error) or "did not acknowledge" in str(error)
    assert seconds < 1.1


def test_after_a_short_silence_the_base_stands_and_the_run_goes_on(side: FakeBridge) -> None:
    line = Spoiled(side, lambda message: back_after(0.8, message), lambda message: back_after(0.8, message))

    def back_after(seconds: float, message: bytes) -> bytes | None:
        return message if line.now() - line.driven_at > seconds else None

    robot = body(line, line)
    robot.reset()
    seen = robot.step(BaseDisplacement(x=0.9))
    assert line.stopped_at - line.driven_at == pytest.approx(LIMITS.stale / 2, abs=0.05)
    assert 0.05 < seen.base_to_start.x < 0.3  # the rest of the way was not driven
    assert seen.step == 1
    assert robot.step(BaseDisplacement(x=0.25)).base_to_start.x == pytest.approx(seen.base_to_start.x + 0.25, abs=0.02)


def test_a_silence_while_nothing_moves_is_waited_out(side: FakeBridge) -> None:
    class Pausing(Lockstep):
        silent_until = 0.0

        def newest_state(self) -> bytes | None:
            message = super().newest_state()
            return message if self.now() > self.silent_until else None

        def send(self, action: bytes) -> None:
            if "head_to" in pickle.loads(action) and self.silent_until == 0.0:
                self.silent_until = self.now() + 0.7
            super().send(action)

    line = Pausing(side, side.robot.simulator.camera, no_truth)
    robot = body(line, line)
    robot.reset()
    assert robot.step(BaseDisplacement(x=0.25)).base_to_start.x == pytest.approx(0.25, abs=0.02)
    assert line.now() > line.silent_until > 0.0


def test_a_head_that_hangs_a_little_low_does_not_sink_while_the_base_creeps(side: FakeBridge) -> None:
    robot = body(line := Lockstep(side, side.robot.simulator.camera, no_truth), line)
    send = side.robot.motors.send_joints

    def sagging(joints: Joints) -> None:
        send(replace(joints, head_tilt=joints.head_tilt - 0.01))

    side.robot.motors.send_joints = sagging  # type: ignore[method-assign]
    tilts = [robot.reset().joints.head_tilt]
    tilts += [robot.step(BaseDisplacement(x=0.12)).joints.head_tilt for _ in range(5)]
    assert side.robot.base.x == pytest.approx(0.6, abs=0.02)
    assert tilts == pytest.approx([NAVIGATION_POSTURE.head_tilt - 0.01] * 6, abs=0.002)
