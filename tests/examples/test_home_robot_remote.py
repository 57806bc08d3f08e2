"""HomeRobot's classes, for which stand-ins are put, meet the example's mapping; HomeRobot itself is not installed."""

import ast
import importlib
import math
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

pytest.importorskip("grpc", reason="the extra 'serve' is not installed")

import uniteam_client
from examples.conftest import EXAMPLES
from scipy.spatial.transform import Rotation
from worlds.home_robot_stand_in import (
    ContinuousFullBodyAction,
    ContinuousNavigationAction,
    DiscreteNavigationAction,
    Observations,
    put_in_place,
)
from worlds.served import Offer, playing, serve, write_episodes


@pytest.fixture
def example(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    put_in_place(monkeypatch)
    monkeypatch.delitem(importlib.sys.modules, "home_robot_remote", raising=False)  # type: ignore[attr-defined]
    return importlib.import_module("home_robot_remote")


class HomeRobotsAgent:
    """An agent with HomeRobot's API: it turns, looks along its arm, and stops."""

    ACTIONS = ("TURN_LEFT", "POST_NAV_MODE", "MANIPULATION_MODE", "STOP")

    def __init__(self) -> None:
        self.seen: list[Observations] = []
        self.resets = 0

    def reset(self) -> None:
        self.resets += 1
        self._step = 0

    def act(self, observations: Observations) -> tuple[Any, dict[str, Any], Observations]:
        self.seen.append(observations)
        action = DiscreteNavigationAction[self.ACTIONS[self._step]]
        self._step += 1
        return action, {"curr_skill": "NAV_TO_OBJ"}, observations


def test_an_agent_with_home_robots_api_plays_through_the_server(example: ModuleType, tmp_path: Path) -> None:
    agent = HomeRobotsAgent()
    offer = Offer(write_episodes(tmp_path / "one.jsonl.gz", 1), tmp_path / "out")
    served = serve(offer, [playing(example.HomeRobotAgent(agent))])
    assert served.results["e0"].measures.num_steps == 4
    assert served.results["e0"].state == "NAV_TO_OBJ"
    assert agent.resets == 1
    first, turned, waited, along_arm = agent.seen
    assert first.task_observations is not None
    assert first.task_observations["goal_name"] == served.results["e0"].instruction
    assert first.gps.tolist() == [0.0, 0.0] and first.compass.tolist() == [0.0]
    assert turned.compass[0] == pytest.approx(math.radians(30.0), abs=1e-6)
    assert waited.compass[0] == turned.compass[0]
    assert tilt(first) == pytest.approx(-math.radians(30.0), abs=0.02)
    assert tilt(along_arm) == pytest.approx(-math.radians(45.0), abs=0.02)
    assert along_arm.joint is not None and along_arm.joint.shape == (10,)
    assert along_arm.joint[8] == pytest.approx(-math.pi / 2.0, abs=1e-5)
    assert first.is_holding is not None and first.is_holding.tolist() == [0.0]


def tilt(observations: Observations) -> float:
    """Return the camera's tilt (rad) as HomeRobot's maps read it: the second of the intrinsic angles z, y, x."""
    assert observations.camera_pose is not None
    return float(Rotation.from_matrix(observations.camera_pose[:3, :3]).as_euler("ZYX")[1])


def test_the_cameras_pose_stands_as_high_and_looks_as_far_down_as_it_does(example: ModuleType) -> None:
    down = math.radians(30.0)  # about the camera's x, from looking ahead along the start's x
    ahead = np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
    camera_to_start = np.eye(4)
    camera_to_start[:3, :3] = ahead @ Rotation.from_euler("x", -down).as_matrix()
    camera_to_start[:3, 3] = (0.1, 0.0, 1.31)
    pose = example.camera_pose_of(camera_to_start)
    assert pose[2, 3] == pytest.approx(1.31)
    assert np.linalg.det(pose[:3, :3]) == pytest.approx(1.0, abs=1e-6)
    assert Rotation.from_matrix(pose[:3, :3]).as_euler("ZYX")[1] == pytest.approx(-down, abs=1e-6)
    point = np.array([0.3, 0.2, 2.0])  # right, down, forward
    there = camera_to_start[:3, :3] @ point
    assert np.allclose(pose[:3, :3] @ np.array([-point[2], point[0], -point[1]]), there, atol=1e-6)


def test_depth_beyond_the_range_is_what_home_robots_maps_take_for_it(example: ModuleType) -> None:
    observation = uniteam_client.Observation(
        rgb=np.zeros((1, 2, 3), np.uint8),
        depth=np.array([[0.0, 2.5]], np.float32),
        camera=uniteam_client.Camera(2, 1, 1.0, 1.0, 0.5, 0.0),
        camera_to_start=np.eye(4),
        base_to_start=uniteam_client.BasePose(1.0, 2.0, 0.5),
        joints=uniteam_client.Joints(lift=0.7, arm=0.4),
        is_holding=True,
        step=3,
        truth=None,
    )
    seen = example.observations_of(uniteam_client.Instruction("cup", "table", "bed"), observation)
    assert seen.depth.tolist() == [[10001.0, 2.5]]
    assert seen.depth.dtype == np.float32
    assert seen.joint[:5].tolist() == pytest.approx([0.1, 0.1, 0.1, 0.1, 0.7])
    assert seen.task_observations["prev_grasp_success"].tolist() == [1.0]
    seen.rgb[0] = 1  # HomeRobot's agents write into what they are given


def test_every_discrete_action_is_done_or_lets_a_step_pass(example: ModuleType) -> None:
    done = {action.name: example.action_of(action) for action in DiscreteNavigationAction}
    assert {name for name, action in done.items() if action == "empty_action"} == {
        "EMPTY_ACTION", "POST_NAV_MODE", "PICK_OBJECT", "PLACE_OBJECT", "OPEN_GRIPPER", "CLOSE_GRIPPER",
    }  # fmt: skip
    assert set(done.values()) == set(uniteam_client.DISCRETE_ACTIONS)
    assert done["SNAP_OBJECT"] == "snap_object"


def test_continuous_actions_keep_their_numbers(example: ModuleType) -> None:
    assert example.action_of(ContinuousNavigationAction([0.5, 0.0, 0.1])) == uniteam_client.BaseDisplacement(
        0.5, 0.0, 0.1
    )
    joints = [0.11, 0.0, 0.0, 0.0, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7]
    moved = example.action_of(ContinuousFullBodyAction(joints))
    assert moved.delta == uniteam_client.Joints(0.2, 0.11, 0.3, 0.4, 0.5, 0.6, 0.7)
    assert moved.base == uniteam_client.BaseDisplacement(0.0, 0.0, 0.0)
    with pytest.raises(TypeError, match="none of its actions"):
        example.action_of("TURN_LEFT")


@pytest.mark.parametrize("name", ["home_robot_remote.py", "wander_remote.py"])
def test_examples_for_other_pythons_speak_an_old_one(name: str) -> None:
    assert ast.parse((EXAMPLES / name).read_text(), feature_version=(3, 8)).body
