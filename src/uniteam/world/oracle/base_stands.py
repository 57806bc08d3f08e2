"""Where the base could stand to grasp an object or to release one over a surface, by Stretch's geometry alone.

A stand is the pose of the base before manipulation mode, which turns the base left by 90 degrees: what the robot faces
at a stand is what its arm points at afterwards. Whether anything is in the way is for the simulator to say.
"""

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import islice, product
from typing import TypeVar

import numpy as np

from uniteam.geometry import BasePose, PinholeCamera, invert_transform, transform_points, wrap_angle
from uniteam.interface import Joints
from uniteam.stretch import GRASP_RANGE, JOINT_LIMITS, MANIPULATION_POSTURE, gripper_to_base, head_camera_to_base

GRASP_REACH = GRASP_RANGE - 0.05
"""How far (m) the gripper may be from what it grasps in the horizontal plane, a little less than the rules allow."""
BEST_GRASP_DISTANCE = 0.6
"""Of the base from the object (m): close, yet with the object well inside the image."""
IMAGE_MARGIN = 0.06
"""Share of the image, at each border, that an object to be grasped keeps clear of."""
ARM_MARGIN = 0.01
"""What the arm keeps of its range (m)."""
BEST_EXTENSION = 0.3
"""Of the arm when it releases (m): far enough from the furniture to turn there with something in the gripper."""


_GRASP_POSTURES = (
    MANIPULATION_POSTURE,
    *(
        replace(MANIPULATION_POSTURE, lift=lift, arm=arm, head_tilt=-math.radians(tilt))
        for arm, lift, tilt in product((0.0, 0.25, 0.48), (0.78, 1.06, 0.45), (45.0, 20.0, 65.0, -8.0))
        if (arm, lift, tilt) != (0.0, 0.78, 45.0)
    ),
)
STANDS_A_POSTURE, STANDS_APART = 5, 0.2
"""How many stands a posture is tried at, and how far apart they are (m)."""
SIDES_APART = 0.5
"""How far apart the stands are that reach one point from different sides (m)."""


@dataclass(frozen=True)
class Grasp:
    """A stand, and the joint positions at which something is within the gripper's reach and in view."""

    stand: BasePose
    joints: Joints


@dataclass(frozen=True)
class Release:
    """A stand, the joint positions that hold the gripper over a point, and from how much higher it comes (m)."""

    stand: BasePose
    joints: Joints
    rise: float = 0.0


Way = TypeVar("Way", Grasp, Release)


def manipulation_base(stand: BasePose) -> BasePose:
    """Return where the base is once it has entered manipulation mode at a stand."""
    return BasePose(stand.x, stand.y, wrap_angle(stand.heading + math.pi / 2.0))


def grasps(position: np.ndarray, floor_points: np.ndarray, camera: PinholeCamera) -> Iterator[Grasp]:
    """Yield ways to grasp an object (3,) that is in reach and in view from (N, 2) points of the floor, best first.

    The posture of the challenge's manipulation mode comes first, at a few stands; then those in which the head looks
    higher or lower, the lift is nearer to the object's height, or the arm is extended to it.
    """
    offsets = position[:2] - floor_points
    distances = np.hypot(*offsets.T)
    for joints in _GRASP_POSTURES:
        order = np.argsort(np.abs(distances - BEST_GRASP_DISTANCE - joints.arm), kind="stable")
        stands = (
            BasePose(float(x), float(y), math.atan2(dy, dx))
            for (x, y), (dx, dy) in zip(floor_points[order], offsets[order], strict=True)
        )
        found = (Grasp(stand, joints) for stand in stands if can_grasp(Grasp(stand, joints), position, camera))
        yield from islice(apart(found, STANDS_APART), STANDS_A_POSTURE)


def apart(ways: Iterable[Way], distance: float) -> Iterator[Way]:
    """Yield of some ways those whose stands are not near (m) the stand of one that was yielded before."""
    taken: list[BasePose] = []
    for way in ways:
        if all(way.stand.distance_to(stand.x, stand.y) >= distance for stand in taken):
            taken.append(way.stand)
            yield way


def can_grasp(grasp: Grasp, position: np.ndarray, camera: PinholeCamera) -> bool:
    """Return whether an object at `position` (3,) is near enough to the gripper and well inside the camera's view."""
    in_base = transform_points(invert_transform(manipulation_base(grasp.stand).matrix()), position)
    gripper = gripper_to_base(grasp.joints)[:3, 3]
    if float(np.hypot(*(in_base - gripper)[:2])) > GRASP_REACH:
        return False
    in_camera = transform_points(invert_transform(head_camera_to_base(grasp.joints)), in_base)
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


def approach(joints: Joints, rise: float) -> tuple[Joints, ...]:
    """Return the postures through which the arm comes to release at `joints`.

    It is lifted, the wrist is turned, the arm extended; from above, all of that `rise` (m) higher, and it is lowered
    at the end.
    """
    high = min(joints.lift + rise, JOINT_LIMITS[1].lift)
    lifted = replace(MANIPULATION_POSTURE, lift=high)
    over = replace(joints, lift=high)
    way = (lifted, replace(over, arm=lifted.arm), over)
    return way if high == joints.lift else (*way, joints)
