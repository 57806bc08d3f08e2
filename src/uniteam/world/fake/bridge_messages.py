"""The messages that a fake bridge sends: the fields of the real one, of a simulated robot.

A message is made in two halves. What a moment was is written down at once; its images are packed where it is sent, for
that takes the most time, and not every message is read.
"""

import pickle
from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import PinholeCamera
from uniteam.interface import Joints, Segmentation
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.fake.depth_faults import with_faults
from uniteam.world.real.images import encode_depth, encode_rgb
from uniteam.world.real.messages import ARM, BASE_X, GRIPPER, JOINT_COUNT, LIFT, PAN, PITCH, ROLL, TILT, YAW, pack_truth
from uniteam.world.rendering.kernels.frame import Frame

SERVO_SCALE = 0.5
"""Of the small images."""
MOVING_SPEED = 0.05
"""What the velocity of each joint is said to be while anything moves (m/s, rad/s)."""

TruthOf = Callable[[Frame], Segmentation | None]
"""What to tell of the truth in a frame; None where it is kept."""


def no_truth(frame: Frame) -> None:
    """Keep the truth, as a real robot does."""


@dataclass(frozen=True)
class Moment:
    """A robot at the time of a picture.

    Attributes:
        joints: the vector of all joints (11,).
        gps: where it believes that its base is, x and y (m).
        compass: its heading (1,) (rad).
        camera_to_world: (4, 4).
        gripper_to_world: (4, 4).
        frame: what its camera saw.
        depth: (H, W) (m), with the camera's errors.
        step: of the last action that was done.
        at_goal: whether its base is where it was sent.
        mode: of its control.
        has_failed: whether the base gave its last goal up.
    """

    joints: NDArray[np.float64]
    gps: NDArray[np.float64]
    compass: NDArray[np.float64]
    camera_to_world: NDArray[np.float64]
    gripper_to_world: NDArray[np.float64]
    frame: Frame
    depth: NDArray[np.float32]
    step: int
    at_goal: bool
    mode: str
    has_failed: bool


def moment_of(bridge: FakeBridge) -> Moment:
    """Return what is to be sent of a picture that was just taken."""
    robot = bridge.robot
    return Moment(
        joints=joint_vector(robot.joints, robot.motors.gripper, bridge.base_x),
        gps=np.array([robot.base.x, robot.base.y]),
        compass=np.array([robot.base.heading]),
        camera_to_world=robot.camera_to_world(),
        gripper_to_world=robot.gripper_to_world(),
        frame=robot.frame,
        depth=with_faults(robot.frame.depth, robot.dials.depth_noise, robot.dials.holes, robot.rng),
        step=bridge.step,
        at_goal=robot.motors.goal is None,
        mode=bridge.mode,
        has_failed=robot.motors.has_failed,
    )


def state_message(bridge: FakeBridge) -> bytes:
    """Return the message of state, packed."""
    robot = bridge.robot
    speed = 0.0 if robot.motors.is_at_rest else MOVING_SPEED
    fields = {
        "base_pose": np.array([robot.base.x, robot.base.y, robot.base.heading]),
        "ee_pose": robot.gripper_to_world(),
        "joint_positions": joint_vector(robot.joints, robot.motors.gripper, bridge.base_x),
        "joint_velocities": np.full(JOINT_COUNT, speed),
        "joint_efforts": np.zeros(JOINT_COUNT),
        "control_mode": bridge.mode,
        "at_goal": robot.motors.goal is None,
        "is_homed": True,
        "is_runstopped": robot.is_run_stopped,
        "step": bridge.step,
    }
    return pickle.dumps(fields, protocol=4)


def observation_message(moment: Moment, camera: PinholeCamera, truth_of: TruthOf) -> bytes:
    """Return the message of observation, packed; the names of its size are exchanged, as the real bridge has them."""
    truth = truth_of(moment.frame)
    fields = {
        "rgb": encode_rgb(moment.frame.rgb),
        "depth": encode_depth(moment.depth),
        "camera_K": camera_matrix(camera, 1.0),
        "camera_pose": moment.camera_to_world,
        "ee_pose": moment.gripper_to_world,
        "joint": moment.joints,
        "joint_velocities": np.zeros(JOINT_COUNT),
        "gps": moment.gps,
        "compass": moment.compass,
        "rgb_width": moment.depth.shape[0],
        "rgb_height": moment.depth.shape[1],
        "lidar_points": None,
        "lidar_timestamp": None,
        "pose_graph": [],
        "last_motion_failed": moment.has_failed,
        "recv_address": "tcp://*:4402",
        "step": moment.step,
        "at_goal": moment.at_goal,
        "control_mode": moment.mode,
        "is_simulation": True,
        **({} if truth is None else pack_truth(truth)),
    }
    return pickle.dumps(fields, protocol=4)


def servo_message(moment: Moment, camera: PinholeCamera) -> bytes:
    """Return the message of small images, packed; this robot has no camera at its wrist."""
    size = (round(camera.width * SERVO_SCALE), round(camera.height * SERVO_SCALE))
    rgb = cv2.resize(moment.frame.rgb, size, interpolation=cv2.INTER_AREA)
    depth = cv2.resize(moment.depth, size, interpolation=cv2.INTER_NEAREST)
    fields = {
        "ee/pose": moment.gripper_to_world,
        "head_cam/color_camera_K": camera_matrix(camera, SERVO_SCALE),
        "head_cam/depth_camera_K": camera_matrix(camera, SERVO_SCALE),
        "head_cam/color_image": encode_rgb(np.asarray(rgb, np.uint8)),
        "head_cam/depth_image": encode_depth(np.asarray(depth, np.float32)),
        "head_cam/color_image/shape": rgb.shape,
        "head_cam/depth_image/shape": depth.shape,
        "head_cam/image_scaling": SERVO_SCALE,
        "head_cam/depth_scaling": 0.001,
        "head_cam/pose": moment.camera_to_world,
        "robot/config": moment.joints,
        "step": moment.step,
        "is_simulation": True,
    }
    return pickle.dumps(fields, protocol=4)


def joint_vector(joints: Joints, gripper: float, base_x: float) -> NDArray[np.float64]:
    """Return the (11,) vector of all joints; its wrist is in the order roll, pitch, yaw."""
    vector = np.zeros(JOINT_COUNT)
    vector[[BASE_X, LIFT, ARM, GRIPPER]] = base_x, joints.lift, joints.arm, gripper
    vector[[ROLL, PITCH, YAW]] = joints.wrist_roll, joints.wrist_pitch, joints.wrist_yaw
    vector[[PAN, TILT]] = joints.head_pan, joints.head_tilt
    return vector


def camera_matrix(camera: PinholeCamera, scale: float) -> NDArray[np.float64]:
    """Return the (3, 3) intrinsics of an image that was scaled."""
    return np.array(
        [[camera.fx * scale, 0.0, camera.cx * scale], [0.0, camera.fy * scale, camera.cy * scale], [0.0, 0.0, 1.0]]
    )
