"""Where the base could stand to grasp an object or to release one over a surface, by Stretch's geometry alone.

A stand is the pose of the base before manipulation mode, which turns the base left by 90 degrees: what the robot faces
at a stand is what its arm points at afterwards. Whether anything is in the way is for the simulator to say.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from uniteam.geometry import BasePose, PinholeCamera, invert_transform, transform_points, wrap_angle
from uniteam.interface import Joints
from uniteam.stretch import GRASP_RANGE, JOINT_LIMITS, MANIPULATION_POSTURE, gripper_to_base, head_camera_to_base

GRASP_REACH = GRASP_RANGE - 0.05
"""How far (m) the gripper may be from what it grasps, a little less than the simulator allows."""
BEST_GRASP_DISTANCE = 0.6
"""Of the base from the object (m): close, yet with the object well inside the image."""
IMAGE_MARGIN = 0.08
"""Share of the image, at each border, that an object to be grasped keeps clear of."""
ARM_MARGIN = 0.01
"""What the arm keeps of its range (m)."""
BEST_EXTENSION = 0.3
"""Of the arm when it releases (m): far enough from the furniture to turn there with something in the gripper."""


@dataclass(frozen=True)
class Release:
    """A stand, and the joint positions that hold the gripper over a point."""

    stand: BasePose
    joints: Joints


def manipulation_base(stand: BasePose) -> BasePose:
    """Return where the base is once it has entered manipulation mode at a stand."""
    return BasePose(stand.x, stand.y, wrap_angle(stand.heading + math.pi / 2.0))


def grasp_stands(position: np.ndarray, floor_points: np.ndarray, camera: PinholeCamera) -> Iterator[BasePose]:
    """Yield stands on (N, 2) points of the floor from which an object (3,) is in reach and in view, best first."""
    offsets = position[:2] - floor_points
    order = np.argsort(np.abs(np.hypot(*offsets.T) - BEST_GRASP_DISTANCE), kind="stable")
    for (x, y), (dx, dy) in zip(floor_points[order], offsets[order], strict=True):
        stand = BasePose(float(x), float(y), math.atan2(dy, dx))
        if can_grasp(stand, position, camera):
            yield stand


def can_grasp(stand: BasePose, position: np.ndarray, camera: PinholeCamera) -> bool:
    """Return whether an object at `position` (3,) is near enough to the gripper and well inside the camera's view."""
    in_base = transform_points(invert_transform(manipulation_base(stand).matrix()), position)
    gripper = gripper_to_base(MANIPULATION_POSTURE)[:3, 3]
    if float(np.linalg.norm(in_base - gripper)) > GRASP_REACH:
        return False
    in_camera = transform_points(invert_transform(head_camera_to_base(MANIPULATION_POSTURE)), in_base)
    if in_camera[2] <= 0.0:
        return False
    u, v = camera.project(in_camera) / (camera.width, camera.height)
    return bool(IMAGE_MARGIN < u < 1.0 - IMAGE_MARGIN and IMAGE_MARGIN < v < 1.0 - IMAGE_MARGIN)


def releases(point: np.ndarray, floor_points: np.ndarray, gripper_height: float, wrist_pitch: float) -> list[Release]:
    """Return the ways to hold the gripper over a point, those with the best extension of the arm first.

    Args:
        point: (2,) of the grasp centre (m, world).
        floor_points: (N, 2) where the base may stand (m, world).
        gripper_height: of the grasp centre above the floor (m).
        wrist_pitch: rad.
    """
    at_zero = gripper_to_base(Joints(0.0, 0.0, wrist_pitch=wrist_pitch))[:3, 3]
    joints = replace(MANIPULATION_POSTURE, lift=gripper_height - float(at_zero[2]), wrist_pitch=wrist_pitch)
    low, high = JOINT_LIMITS
    if not low.lift <= joints.lift <= high.lift:
        return []
    offsets = point - floor_points
    along = np.sqrt(np.maximum(0.0, (offsets**2).sum(axis=1) - at_zero[0] ** 2))
    headings = np.arctan2(offsets[:, 1], offsets[:, 0]) - np.arctan2(at_zero[0], along)
    arms = along + at_zero[1]
    order = np.argsort(np.abs(arms - BEST_EXTENSION), kind="stable")
    return [
        Release(
            BasePose(float(floor_points[i, 0]), float(floor_points[i, 1]), wrap_angle(float(headings[i]))),
            replace(joints, arm=float(arms[i])),
        )
        for i in order
        if low.arm + ARM_MARGIN <= arms[i] <= high.arm - ARM_MARGIN
    ]


def approach(joints: Joints) -> tuple[Joints, Joints, Joints]:
    """Return the postures through which the arm comes to release at `joints`: lifted, the wrist turned, extended."""
    lifted = replace(MANIPULATION_POSTURE, lift=joints.lift)
    return lifted, replace(joints, arm=lifted.arm), joints
