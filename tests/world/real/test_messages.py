"""What the bridge calls a thing is taken for that thing: the wrist's order, the exchanged names, the turned camera."""

import math
import pickle
from typing import Any

import numpy as np
import pytest

from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Detection, Joints, Segmentation
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.world.fake.bridge_messages import joint_vector
from uniteam.world.real.images import encode_depth, encode_rgb
from uniteam.world.real.messages import command, observation_message, pack_truth, state_message
from uniteam.world.real.robot_errors import StrangeMessageError

JOINTS = Joints(lift=0.9, arm=0.3, wrist_yaw=0.1, wrist_pitch=-0.2, wrist_roll=0.3, head_pan=-0.4, head_tilt=-0.5)
VECTOR = [0.07, 0.0, 0.0, 0.9, 0.3, 0.25, 0.3, -0.2, 0.1, -0.4, -0.5]
"""Base x, y and heading, lift, arm, gripper, wrist roll, pitch and yaw, head pan and tilt."""
STATE: dict[str, Any] = {
    "base_pose": np.array([1.0, 2.0, 0.5]),
    "ee_pose": np.eye(4),
    "joint_positions": np.array(VECTOR),
    "joint_velocities": np.zeros(11),
    "joint_efforts": np.zeros(11),
    "control_mode": "navigation",
    "at_goal": True,
    "is_homed": True,
    "is_runstopped": False,
    "step": 5,
}
ROWS, COLUMNS = 128, 96
SEEN: dict[str, Any] = {
    "rgb": encode_rgb(np.full((ROWS, COLUMNS, 3), (10, 120, 230), np.uint8)),
    "depth": encode_depth(np.full((ROWS, COLUMNS), 2.5, np.float32)),
    "camera_K": np.array([[110.0, 0.0, 40.0], [0.0, 112.0, 60.0], [0.0, 0.0, 1.0]]),
    "camera_pose": BasePose(1.0, 2.0, 0.5).matrix(),
    "joint": np.array(VECTOR),
    "gps": np.array([1.0, 2.0]),
    "compass": np.array([0.5]),
    "rgb_width": ROWS,
    "rgb_height": COLUMNS,
    "step": 5,
}


def test_the_joints_of_a_vector_are_in_their_places() -> None:
    message = state_message(STATE)
    assert message.state.joints == JOINTS
    assert message.state.gripper == 0.25
    assert message.base_x == 0.07
    assert message.state.base == BasePose(1.0, 2.0, 0.5)


def test_a_fake_robots_vector_is_the_same_one() -> None:
    assert joint_vector(JOINTS, 0.25, 0.07).tolist() == VECTOR


def test_the_wrist_of_a_command_is_yaw_pitch_and_roll_unlike_a_vectors() -> None:
    assert command(0.07, JOINTS) == [0.07, 0.9, 0.3, 0.1, -0.2, 0.3]


def test_an_observation_has_as_many_rows_as_its_width_says() -> None:
    view = observation_message(SEEN).view()
    assert view.rgb.shape == (ROWS, COLUMNS, 3)
    assert view.rgb[0, 0].tolist() == pytest.approx([10, 120, 230], abs=3)
    assert view.depth[0, 0] == pytest.approx(2.5)
    assert (view.camera.height, view.camera.width) == (ROWS, COLUMNS)
    assert view.state.base == BasePose(1.0, 2.0, 0.5)
    assert view.state.joints == JOINTS


def lying_camera() -> tuple[PinholeCamera, np.ndarray]:
    """Return the intrinsics of a camera that lies on its side, and a point that it sees, in its own axes."""
    return PinholeCamera(ROWS, COLUMNS, 112.0, 110.0, 60.0, 40.0), np.array([0.4, -0.2, 2.0])


def test_a_point_is_where_the_picture_shows_it_once_that_is_turned_upright() -> None:
    camera, point = lying_camera()
    u, v = camera.project(point)
    picture = np.zeros((COLUMNS, ROWS))
    picture[round(v), round(u)] = 1.0
    row, column = np.argwhere(np.rot90(picture, k=3))[0]
    x, y, z = point
    upright = observation_message(SEEN).view().camera.project(np.array([-y, x, z]))
    assert upright == pytest.approx([column, row], abs=0.51)


def test_a_simulators_intrinsics_are_taken_as_they_are() -> None:
    camera = observation_message({**SEEN, "is_simulation": True}).view().camera
    assert (camera.cx, camera.cy, camera.fx, camera.fy) == (40.0, 60.0, 110.0, 112.0)


def test_a_rotation_that_is_nearly_one_is_made_exact() -> None:
    pose = SEEN["camera_pose"] + 1e-5 * np.arange(16).reshape(4, 4) / 16
    pose[3] = (0, 0, 0, 1)
    rotation = observation_message({**SEEN, "camera_pose": pose}).view().camera_to_world[:3, :3]
    assert np.abs(rotation @ rotation.T - np.eye(3)).max() < 1e-12


def test_the_truth_comes_out_as_it_was_packed() -> None:
    instances = np.full((HEAD_CAMERA_HALF.height, HEAD_CAMERA_HALF.width), -1, np.int16)
    instances[10:20, 5:9], instances[40:60, 30:70] = 0, 1
    truth = Segmentation(instances, (Detection((("cup", 1.0),)), Detection((("table", 1.0),))))
    rgb = np.zeros((*instances.shape, 3), np.uint8)
    size = {"rgb_width": instances.shape[0], "rgb_height": instances.shape[1]}
    camera = np.array([[300.0, 0.0, 119.5], [0.0, 300.0, 159.5], [0.0, 0.0, 1.0]])
    packed = {**SEEN, **size, "camera_K": camera, "rgb": encode_rgb(rgb), "depth": encode_depth(rgb[..., 0] * 1.0)}
    read = observation_message({**packed, **pack_truth(truth)}).view().truth
    assert read is not None
    np.testing.assert_array_equal(read.instances, instances)
    assert [detection.name for detection in read.detections] == ["cup", "table"]


@pytest.mark.parametrize("key", sorted(STATE.keys() - {"ee_pose", "joint_efforts"}))
def test_a_state_that_lacks_something_is_refused_by_its_name(key: str) -> None:
    with pytest.raises(StrangeMessageError, match=f"lacks '{key}'"):
        state_message({k: v for k, v in STATE.items() if k != key})


@pytest.mark.parametrize("key", sorted(SEEN))
def test_an_observation_that_lacks_something_is_refused_by_its_name(key: str) -> None:
    with pytest.raises(StrangeMessageError, match=f"lacks '{key}'"):
        observation_message({k: v for k, v in SEEN.items() if k != key}).view()


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("camera_K", np.zeros((3, 3))),
        ("camera_K", np.diag([110.0, 112.0, 1.0])),
        ("camera_K", np.eye(4)),
        ("camera_pose", np.diag([1.0, 1.0, -1.0, 1.0])),
        ("camera_pose", 2.0 * np.eye(4)),
        ("rgb_width", 10**9),
        ("rgb_width", -1),
        ("rgb_width", True),
        ("rgb", "a picture"),
        ("rgb", np.zeros((4, 4), np.float64)),
        ("gps", np.array(["a", "b"])),
        ("gps", np.array([1e9, 0.0])),
        ("compass", 0.5),
        ("step", 2**70),
        ("step", 1.0),
        ("uniteam_truth", b"no picture"),
    ],
)
def test_a_field_of_the_wrong_kind_is_refused(key: str, value: Any) -> None:
    with pytest.raises(StrangeMessageError):
        observation_message({**SEEN, "uniteam_truth_names": ["cup"], key: value}).view()


def test_what_is_no_dictionary_is_no_message() -> None:
    with pytest.raises(StrangeMessageError, match="must be a dictionary, got a list"):
        state_message(pickle.loads(pickle.dumps([])))
    assert math.isfinite(state_message(STATE).base_x)
