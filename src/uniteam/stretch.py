"""Hello Robot's Stretch RE2 with the dexterous wrist: its joints, postures, cameras and forward kinematics.

The base frame has its origin on the floor at the centre of rotation between the wheels, x forward, y left and z up; the
arm points to -y. The kinematics is a product of motions, each about or along an axis of the base frame given where it
is when every joint is at zero, so a link's geometry needs no frame of its own: `link_motions` moves it from there.
Figures are those of the manufacturer's URDF (RE2V0, `stretch_dex_wrist`), with angles rounded to exact quarter turns.
"""

import math
from dataclasses import fields

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import PinholeCamera
from uniteam.interface import Joints

Transform = NDArray[np.float64]

BASE_RADIUS = 0.30
"""Radius of the cylinder that stands for the base, the mast and the head (m)."""
ROBOT_HEIGHT = 1.41
"""Height of that cylinder (m)."""

DEPTH_RANGE = 10.0
"""How far the depth camera measures (m); beyond, depth is 0."""

GRASP_RANGE = 0.8
"""How far from the grasp centre an object's middle may be in the horizontal plane to be grasped (m), as in the
challenge."""

FINGER_LENGTH = 0.171
"""From a finger's pivot to its tip (m), by which its angle becomes an opening, as in the maker's software."""
OPEN_FINGER = 0.6
"""To which an opened gripper's fingers are sent (rad of one finger)."""
FULL_OPENING = 2.0 * FINGER_LENGTH * OPEN_FINGER
"""How far apart the fingertips of an opened gripper are (m)."""

ARM_SEGMENTS = 4
"""The arm telescopes in four segments that share its extension equally."""

JOINT_LIMITS = (
    Joints(lift=0.0, arm=0.0, wrist_yaw=-1.75, wrist_pitch=-1.57, wrist_roll=-3.14, head_pan=-4.0, head_tilt=-1.6),
    Joints(lift=1.1, arm=0.52, wrist_yaw=4.0, wrist_pitch=0.56, wrist_roll=3.14, head_pan=1.7, head_tilt=0.5),
)
"""The lowest and the highest position of every joint (m and rad)."""

NAVIGATION_POSTURE = Joints(lift=0.78, arm=0.0, wrist_pitch=-1.5, head_tilt=-math.radians(30.0))
"""Wrist yaw is 0, as in the challenge: with the wrist pitched down, the gripper hangs within the base's footprint."""

MANIPULATION_POSTURE = Joints(
    lift=0.78, arm=0.0, wrist_pitch=-1.5, head_pan=-math.radians(90.0), head_tilt=-math.radians(45.0)
)
"""The head looks along the arm; the arm and the wrist are as in navigation."""

HEAD_CAMERA_FULL = PinholeCamera.from_horizontal_fov(480, 640, math.radians(42.0))
HEAD_CAMERA_HALF = PinholeCamera.from_horizontal_fov(240, 320, math.radians(42.0))
HEAD_CAMERA_SMALL = PinholeCamera.from_horizontal_fov(120, 160, math.radians(42.0))
"""The size to which HomeRobot's learned skills shrink their pictures."""

ARM_AXIS = (-0.104384, 0.194999)
"""x and z of the arm's centre line (m), which runs along -y."""
WRIST_YAW_AXIS = (-0.021384, -0.144950, 0.164249)
"""A point of the yaw axis, which is parallel to z; positive yaw turns the gripper to its left (m)."""
WRIST_PITCH_AXIS = (-0.021384, -0.144950, 0.139499)
"""A point of the pitch axis, which is parallel to x; positive pitch lifts the gripper (m)."""
WRIST_ROLL_AXIS = (-0.021384, -0.163809, 0.115499)
"""A point of the roll axis, which runs along -y; positive roll lifts the gripper's left side (m)."""
GRASP_CENTRE = (-0.021384, -0.409309, 0.115499)
"""The point between the fingertips (m)."""

HEAD_RISE = 0.010826
"""How much higher than in the URDF the head sits, so that the camera is 1.31 m above the floor in navigation (m)."""
HEAD_PAN_AXIS = (0.0061, 0.0, 1.355204 + HEAD_RISE)
"""A point of the pan axis, which is parallel to z (m)."""
HEAD_TILT_AXIS = (0.0048, 0.027758, 1.301893 + HEAD_RISE)
"""A point of the tilt axis, which is parallel to y; positive tilt looks up (m)."""
HEAD_CAMERA = (0.0454, -0.002942, 1.322193 + HEAD_RISE)
"""The colour camera's optical centre (m)."""

_AT_REST = np.eye(4)  # a copy of it takes a fifth of the time of a new one, and a step needs a hundred
_CAMERA_AXES = np.array([[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
_GRIPPER_AXES = np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])


def is_navigation_posture(joints: Joints) -> bool:
    """Return whether the head looks ahead over a retracted arm; from elsewhere the camera may see the arm itself."""
    return math.hypot(joints.head_pan, joints.arm) < 0.05


def looks_along_arm(joints: Joints) -> bool:
    """Return whether the head is turned to the arm's side, as in `MANIPULATION_POSTURE`."""
    return joints.head_pan < -1.0


def clamp_joints(joints: Joints) -> Joints:
    """Return the nearest joint positions within `JOINT_LIMITS`."""
    low, high = JOINT_LIMITS
    return Joints(
        *(min(max(getattr(joints, f.name), getattr(low, f.name)), getattr(high, f.name)) for f in fields(Joints))
    )


def head_camera_to_base(joints: Joints) -> Transform:
    """Return the (4, 4) transform from the head camera's frame (OpenCV, upright) to the base frame."""
    motion = _head_pan_motion(joints) @ _head_tilt_motion(joints)
    return motion @ _frame(_CAMERA_AXES, HEAD_CAMERA)


def gripper_to_base(joints: Joints) -> Transform:
    """Return the (4, 4) transform from the gripper's frame to the base frame.

    The gripper's origin is the grasp centre between the fingertips; x points along the fingers, y to the left of it (as
    seen from behind the gripper) and z up when pitch and roll are zero.
    """
    yaw = _arm_motion(joints, ARM_SEGMENTS) @ _wrist_yaw_motion(joints)
    motion = yaw @ _wrist_pitch_motion(joints) @ _wrist_roll_motion(joints)
    return motion @ _frame(_GRIPPER_AXES, GRASP_CENTRE)


def link_motions(joints: Joints) -> dict[str, Transform]:
    """Return how each moving group of links is displaced from where it is when every joint is at zero.

    Returns:
        (4, 4) transforms of the base frame onto itself: "base", "lift" (with the arm's outer tube), "arm_1" to "arm_4"
        (from the outer segment to the inner, which carries the wrist), "wrist_yaw", "wrist_pitch", "gripper",
        "head_pan" and "head_tilt".
    """
    motions = {"base": _AT_REST.copy(), "lift": _arm_motion(joints, 0)}
    for segment in range(1, ARM_SEGMENTS + 1):
        motions[f"arm_{segment}"] = _arm_motion(joints, segment)
    motions["wrist_yaw"] = motions[f"arm_{ARM_SEGMENTS}"] @ _wrist_yaw_motion(joints)
    motions["wrist_pitch"] = motions["wrist_yaw"] @ _wrist_pitch_motion(joints)
    motions["gripper"] = motions["wrist_pitch"] @ _wrist_roll_motion(joints)
    motions["head_pan"] = _head_pan_motion(joints)
    motions["head_tilt"] = motions["head_pan"] @ _head_tilt_motion(joints)
    return motions


def _arm_motion(joints: Joints, segment: int) -> Transform:
    motion = _AT_REST.copy()
    motion[1, 3] = -joints.arm * segment / ARM_SEGMENTS
    motion[2, 3] = joints.lift
    return motion


def _wrist_yaw_motion(joints: Joints) -> Transform:
    return _turn(2, joints.wrist_yaw, WRIST_YAW_AXIS)


def _wrist_pitch_motion(joints: Joints) -> Transform:
    return _turn(0, -joints.wrist_pitch, WRIST_PITCH_AXIS)


def _wrist_roll_motion(joints: Joints) -> Transform:
    return _turn(1, -joints.wrist_roll, WRIST_ROLL_AXIS)


def _head_pan_motion(joints: Joints) -> Transform:
    return _turn(2, joints.head_pan, HEAD_PAN_AXIS)


def _head_tilt_motion(joints: Joints) -> Transform:
    return _turn(1, -joints.head_tilt, HEAD_TILT_AXIS)


def _turn(axis: int, angle: float, point: tuple[float, float, float]) -> Transform:
    """Return the rotation by `angle` (rad) about the line through `point` along the base frame's `axis` (0 to 2)."""
    c, s = math.cos(angle), math.sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    motion = _AT_REST.copy()
    motion[i, i], motion[i, j], motion[j, i], motion[j, j] = c, -s, s, c
    motion[i, 3] = point[i] - c * point[i] + s * point[j]
    motion[j, 3] = point[j] - s * point[i] - c * point[j]
    return motion


def _frame(axes: NDArray[np.float64], origin: tuple[float, float, float]) -> Transform:
    frame = _AT_REST.copy()
    frame[:3, :3] = axes
    frame[:3, 3] = origin
    return frame
