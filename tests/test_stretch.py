"""Stretch's forward kinematics against the manufacturer's URDF."""

import math
from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose

from uniteam import stretch
from uniteam.interface import Joints

OPTICAL_TO_UPRIGHT = np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
"""The URDF's camera lies on its side; ours is the same camera with the image turned upright."""


def sampled_joints(count: int) -> list[Joints]:
    rng = np.random.default_rng(7)
    low, high = ([getattr(limit, f.name) for f in fields(Joints)] for limit in stretch.JOINT_LIMITS)
    return [Joints(*(float(v) for v in rng.uniform(low, high))) for _ in range(count)]


def urdf_transform(link: str, joints: Joints) -> np.ndarray:
    """Evaluate the URDF's own chain from base_link to `link` by the joints' origins and axes."""
    yourdfpy = pytest.importorskip("yourdfpy", reason="needs yourdfpy to evaluate the URDF independently")
    stretch_urdf = pytest.importorskip("stretch_urdf", reason="needs hello-robot-stretch-urdf for the URDF itself")
    folder = Path(stretch_urdf.__file__).parent / "RE2V0"
    path = folder / "stretch_description_RE2V0_tool_stretch_dex_wrist.urdf"
    robot = yourdfpy.URDF.load(str(path), load_meshes=False)
    positions = {f"joint_arm_l{k}": joints.arm / 4.0 for k in range(4)}
    names = {"lift": "joint_lift", "wrist_yaw": "joint_wrist_yaw", "wrist_pitch": "joint_wrist_pitch"}
    names |= {"wrist_roll": "joint_wrist_roll", "head_pan": "joint_head_pan", "head_tilt": "joint_head_tilt"}
    positions |= {joint: getattr(joints, field) for field, joint in names.items()}
    still = {name: 0.0 for name in robot.actuated_joint_names}
    robot.update_cfg({name: np.array(value) for name, value in (still | positions).items()})
    return np.array(robot.get_transform(link, "base_link"))


@pytest.mark.parametrize("joints", sampled_joints(5))
def test_gripper_stands_where_the_urdf_puts_its_grasp_centre(joints: Joints) -> None:
    assert_allclose(stretch.gripper_to_base(joints), urdf_transform("link_grasp_center", joints), atol=1e-4)


@pytest.mark.parametrize("joints", sampled_joints(5))
def test_head_camera_is_the_urdfs_turned_upright_and_raised(joints: Joints) -> None:
    expected = urdf_transform("camera_color_optical_frame", joints)
    expected[:3, :3] = expected[:3, :3] @ OPTICAL_TO_UPRIGHT
    expected[2, 3] += stretch.HEAD_RISE
    assert_allclose(stretch.head_camera_to_base(joints), expected, atol=1e-4)


@pytest.mark.parametrize(
    ("group", "link"),
    [
        ("lift", "link_lift"),
        ("arm_2", "link_arm_l2"),
        ("wrist_pitch", "link_wrist_pitch"),
        ("gripper", "link_wrist_roll"),
    ],
)
def test_links_move_from_their_zero_pose_as_in_the_urdf(group: str, link: str) -> None:
    joints = sampled_joints(1)[0]
    moved = stretch.link_motions(joints)[group] @ urdf_transform(link, Joints(0.0, 0.0))
    assert_allclose(moved, urdf_transform(link, joints), atol=1e-4)


def test_camera_is_131_cm_up_and_looks_30_degrees_down_in_navigation() -> None:
    camera_to_base = stretch.head_camera_to_base(stretch.NAVIGATION_POSTURE)
    assert camera_to_base[2, 3] == pytest.approx(1.31, abs=1e-5)
    assert_allclose(camera_to_base[:3, 2], [math.cos(math.pi / 6), 0.0, -0.5], atol=1e-12)
    assert_allclose(camera_to_base[:3, 0], [0.0, -1.0, 0.0], atol=1e-12)


def test_camera_looks_along_the_arm_in_manipulation() -> None:
    forward = stretch.head_camera_to_base(stretch.MANIPULATION_POSTURE)[:3, 2]
    assert_allclose(forward, [0.0, -math.sqrt(0.5), -math.sqrt(0.5)], atol=1e-12)


def test_gripper_stays_within_the_footprint_in_navigation() -> None:
    tip = stretch.gripper_to_base(stretch.NAVIGATION_POSTURE)[:3, 3]
    assert math.hypot(tip[0], tip[1]) < stretch.BASE_RADIUS


def test_arm_extends_to_the_right_of_the_base() -> None:
    reach = stretch.gripper_to_base(Joints(0.5, 0.52))[:3, 3] - stretch.gripper_to_base(Joints(0.5, 0.0))[:3, 3]
    assert_allclose(reach, [0.0, -0.52, 0.0], atol=1e-12)


def test_joints_are_clamped_to_their_ranges() -> None:
    clamped = stretch.clamp_joints(Joints(2.0, -1.0, wrist_yaw=1.0, head_tilt=9.0))
    assert clamped == Joints(1.1, 0.0, wrist_yaw=1.0, head_tilt=0.5)
