"""A fake robot is driven by a client that knows only the bridge of stretch_ai, over real sockets."""

import math
import os
import pickle
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from worlds.fake_robot import QUICK, bridge, served
from worlds.plain_client import PITCH, ROLL, YAW, PlainClient

from uniteam.errors import UniteamError
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.fake.bridge_messages import no_truth
from uniteam.world.fake.zmq_server import ZmqServer
from uniteam.world.simulation.simulator import Simulator

pytest.importorskip("zmq", reason="the extra 'robot' is not installed")


@pytest.fixture
def client(side: FakeBridge) -> Iterator[PlainClient]:
    with served(side) as ports:
        client = PlainClient(ports.first)
        yield client
        client.close()


def test_it_shows_all_that_a_client_takes_without_a_default(client: PlainClient, world: Simulator) -> None:
    seen = client.observation()
    assert np.abs(seen["depth"] - world.render().depth).max() < 0.001
    assert np.abs(seen["rgb"].astype(int) - world.render().rgb).mean() < 3.0
    assert seen["camera_K"].shape == (3, 3)
    assert (seen["gps"].shape, seen["compass"].shape) == ((2,), (1,))
    assert client.servo()["head_cam/image_scaling"] == 0.5
    assert client.state["step"] == -1


def test_a_goal_is_reached_and_reported(client: PlainClient, side: FakeBridge) -> None:
    client.switch_mode("navigation")
    client.move_base_to([0.8, 0.4, 1.0])
    assert client.state["base_pose"] == pytest.approx([0.8, 0.4, 1.0], abs=0.01)
    assert client.state["at_goal"]
    assert client.observation()["gps"] == pytest.approx([0.8, 0.4], abs=0.01)


def test_the_way_to_a_goal_is_shown_while_it_is_driven(client: PlainClient) -> None:
    client.send_action({"xyt": np.array([1.0, 0.0, 0.0]), "nav_relative": False, "nav_blocking": False})
    assert not client.state["at_goal"]
    seen = set()
    while not client.state["at_goal"]:
        seen.add(round(float(client.state["base_pose"][0]), 2))
        time.sleep(0.01)
    assert len(seen) > 5


def test_the_arm_goes_where_its_six_numbers_say(client: PlainClient, side: FakeBridge) -> None:
    client.switch_mode("manipulation")
    client.arm_to([0.1, 0.9, 0.2, 0.3, -0.4, 0.5], head_to=[-0.6, -0.7])
    assert client.joints[[YAW, PITCH, ROLL]] == pytest.approx([0.3, -0.4, 0.5], abs=0.01)
    assert (side.robot.joints.wrist_yaw, side.robot.joints.wrist_roll) == pytest.approx((0.3, 0.5))
    assert client.joints[0] == pytest.approx(0.1, abs=0.005)
    client.arm_to([-0.05, 0.9, 0.2, 0.3, -0.4, 0.5])
    assert side.robot.base.x == pytest.approx(-0.05, abs=0.005)
    client.switch_mode("navigation")
    client.switch_mode("manipulation")
    assert client.joints[0] == 0.0


def test_a_posture_holds_its_acknowledgement_back_until_it_is_taken(client: PlainClient, side: FakeBridge) -> None:
    client.take_posture("manipulation")
    assert side.robot.joints.head_pan == pytest.approx(-math.pi / 2)
    assert side.robot.motors.is_at_rest
    client.take_posture("navigation")
    assert side.mode == "navigation"


def test_the_head_and_the_gripper_move_in_either_mode(client: PlainClient, side: FakeBridge) -> None:
    client.head_to(0.3, -0.9)
    client.gripper_to(0.6)
    assert side.robot.motors.gripper == 0.6
    client.gripper_to(-0.3)
    assert side.robot.motors.gripper == -0.3


def test_velocities_last_half_a_second(client: PlainClient, side: FakeBridge) -> None:
    client.send_action({"base_velocity": {"v": 0.4, "w": 0.0}})
    client.wait(lambda: side.robot.base.x > 0.05, 3.0, "motion")
    client.wait(lambda: side.robot.motors.is_at_rest, 3.0, "rest")
    assert 0.1 < side.robot.base.x < 0.4


def test_speech_is_acknowledged_and_a_number_of_before_is_not_done_again(client: PlainClient, side: FakeBridge) -> None:
    number = client.send_action({"say": "hello"})
    side.receive(pickle.dumps({"head_to": [0.5, 0.0], "step": number}))
    assert side.robot.motors.is_at_rest


def test_commands_of_the_other_mode_are_refused_and_not_acknowledged(client: PlainClient, side: FakeBridge) -> None:
    number = client.send_action({"joint": [0.0, 1.0, 0.0, 0.0, 0.0, 0.0]}, reliable=False)
    client.wait(lambda: len(side.refusals) > 0, 3.0, "a refusal")
    assert "takes this in its manipulation mode only" in side.refusals[0]
    assert side.step < number
    assert side.robot.joints.lift < 0.8


def test_what_is_no_action_is_refused(side: FakeBridge, tmp_path: Path) -> None:
    class Payload:
        def __reduce__(self) -> tuple[object, ...]:
            return os.mkdir, (str(tmp_path / "it_ran"),)

    for message in (
        pickle.dumps(Payload()),
        b"",
        pickle.dumps([]),
        pickle.dumps({"step": 1}),
        pickle.dumps({"xyt": 1}),
    ):
        side.receive(message)
    side.receive(pickle.dumps({"step": 2, "xyt": [0.0, math.nan, 0.0]}))
    side.receive(pickle.dumps({"step": 2, "base_velocity": {"v": math.inf, "w": 0.0}}))
    side.receive(pickle.dumps({"step": 2, "control_mode": "sideways"}))
    assert len(side.refusals) == 8
    assert not (tmp_path / "it_ran").exists()
    assert side.robot.motors.is_at_rest


def test_a_port_that_is_taken_is_said_so(side: FakeBridge, world: Simulator) -> None:
    with served(side) as ports, pytest.raises(UniteamError, match="cannot be bound"):
        ZmqServer(bridge(world, QUICK), world.camera, no_truth, ("127.0.0.1", ports.first))
