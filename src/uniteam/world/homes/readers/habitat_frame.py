"""From Habitat's frames to ours: points, rotations, and what a rotation of the robot means.

Habitat's world has y up and is right-handed; ours has z up. The one that we choose of the proper rotations between them
is the one between a glTF file and a mesh here, so that a stage's file needs no other: (x, y, z) becomes (x, -z, y).
"""

import math
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import quaternion_to_matrix

Vector = NDArray[np.float64]
Heading = Callable[[Sequence[float]], float]
"""From the quaternion (x, y, z, w) of an episode's start, in Habitat's world, to the base's heading in ours (rad)."""

TO_WORLD = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])

_UPRIGHT = 1e-6


def point_to_world(point: Sequence[float] | Vector) -> Vector:
    """Return a point (..., 3) of Habitat's world in ours (m)."""
    return np.asarray(point, dtype=np.float64) @ TO_WORLD.T


def rotation_to_world(rotation: Vector) -> Vector:
    """Return what a (3, 3) rotation of Habitat's world is in ours."""
    return np.asarray(TO_WORLD @ rotation @ TO_WORLD.T)


def scale_to_world(scale: Sequence[float]) -> Vector:
    """Return the (3,) factors along our axes of factors along those of a file with y up."""
    x, y, z = scale
    return np.array([x, z, y], dtype=np.float64)


def from_wxyz(quaternion: Sequence[float]) -> Vector:
    """Return the (3, 3) rotation of our world of a quaternion as scene instances have it."""
    return rotation_to_world(quaternion_to_matrix(np.array(quaternion)))


def from_xyzw(quaternion: Sequence[float]) -> Vector:
    """Return the (3, 3) rotation of our world of a quaternion as episodes have it."""
    x, y, z, w = quaternion
    return from_wxyz((w, x, y, z))


def quaternion_of(rotation: Vector) -> tuple[float, float, float, float]:
    """Return the unit quaternion (w, x, y, z), w not negative, of a (3, 3) rotation that may be a little off."""
    r = np.asarray(rotation, dtype=np.float64)
    # Of the symmetric matrix that Bar-Itzhack 2000 makes of a rotation the largest eigenvector is its quaternion.
    wanted = np.array(
        [
            [r[0, 0] + r[1, 1] + r[2, 2], r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]],
            [r[2, 1] - r[1, 2], r[0, 0] - r[1, 1] - r[2, 2], r[0, 1] + r[1, 0], r[0, 2] + r[2, 0]],
            [r[0, 2] - r[2, 0], r[0, 1] + r[1, 0], r[1, 1] - r[0, 0] - r[2, 2], r[1, 2] + r[2, 1]],
            [r[1, 0] - r[0, 1], r[0, 2] + r[2, 0], r[1, 2] + r[2, 1], r[2, 2] - r[0, 0] - r[1, 1]],
        ]
    )
    quaternion = np.linalg.eigh(wanted)[1][:, -1]
    w, x, y, z = (quaternion if quaternion[0] >= 0.0 else -quaternion).tolist()
    return w, x, y, z


def is_upright(rotation: Vector) -> bool:
    """Say whether a (3, 3) rotation of our world leaves what is upright so."""
    return bool(rotation[2, 2] > 1.0 - _UPRIGHT)


def heading_as_coded(quaternion: Sequence[float]) -> float:
    """Return the heading (rad) that the challenge's task gives the robot, as it reads the quaternion.

    habitat-lab's OVMM branch turns (0, 0, -1) by it and takes atan2(x, -z) of that for the rotation of a robot whose
    front is +x: the negative of the quaternion's own yaw (`nav_to_obj_task.py`, `reset`).
    """
    return -heading_as_written(quaternion)


def heading_as_written(quaternion: Sequence[float]) -> float:
    """Return the heading (rad) that the quaternion itself gives a robot whose front is +x."""
    return _yaw(from_xyzw(quaternion))


def _yaw(rotation: Vector) -> float:
    """Return the angle (rad) about z of the rotation nearest to an upright one."""
    return math.atan2(rotation[1, 0] - rotation[0, 1], rotation[0, 0] + rotation[1, 1])
