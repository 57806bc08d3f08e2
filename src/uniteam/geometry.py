"""Poses, cameras and point clouds: pure functions that both wings share.

Frames are right-handed. `world` and `start` have z up; `start` is the robot's base when the episode begins (x forward,
y left, z up, origin on the floor). `base` moves with the robot, axes as `start`. `camera` is OpenCV's: x right, y down,
z forward. A transform is named by what it does: `camera_to_start` takes points of the camera frame to the start frame.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.floating]
Point2 = tuple[float, float]
Point3 = tuple[float, float, float]

_IDENTITY = np.eye(4)  # a copy of it takes a fifth of the time of a new one
_GRAIN_BITS = 21


def wrap_angle(angle: float) -> float:
    """Return the equivalent angle in (-pi, pi] (rad)."""
    wrapped = math.remainder(angle, 2.0 * math.pi)
    return math.pi if wrapped == -math.pi else wrapped


@dataclass(frozen=True)
class BasePose:
    """A pose on the floor: x and y (m) and heading (rad, counter-clockwise from the x axis) in some parent frame."""

    x: float
    y: float
    heading: float

    def compose(self, inner: "BasePose") -> "BasePose":
        """Return `inner`, given in this pose's frame, in the parent frame of this pose."""
        c, s = math.cos(self.heading), math.sin(self.heading)
        return BasePose(
            self.x + c * inner.x - s * inner.y,
            self.y + s * inner.x + c * inner.y,
            wrap_angle(self.heading + inner.heading),
        )

    def inverse(self) -> "BasePose":
        """Return the pose of the parent frame in this pose's frame."""
        c, s = math.cos(self.heading), math.sin(self.heading)
        return BasePose(-c * self.x - s * self.y, s * self.x - c * self.y, wrap_angle(-self.heading))

    def matrix(self) -> NDArray[np.float64]:
        """Return the (4, 4) transform from this pose's frame to its parent frame."""
        c, s = math.cos(self.heading), math.sin(self.heading)
        return np.array([[c, -s, 0, self.x], [s, c, 0, self.y], [0, 0, 1, 0], [0, 0, 0, 1]], dtype=np.float64)

    def distance_to(self, x: float, y: float) -> float:
        """Return the distance (m) on the floor to a point of the parent frame."""
        return math.hypot(x - self.x, y - self.y)

    def bearing_to(self, x: float, y: float) -> float:
        """Return how far (rad, left-positive) the base must turn to face a point of the parent frame."""
        return wrap_angle(math.atan2(y - self.y, x - self.x) - self.heading)


@dataclass(frozen=True)
class PinholeCamera:
    """Intrinsics in pixels; the centre of the upper left pixel is (0, 0), width and height count pixels."""

    width: int
    height: int
    fx: float
    fy: float
    cx: float
    cy: float

    @staticmethod
    def from_horizontal_fov(width: int, height: int, horizontal_fov: float) -> "PinholeCamera":
        """Return the camera with square pixels and a centred principal point (horizontal_fov in rad)."""
        focal = width / (2.0 * math.tan(horizontal_fov / 2.0))
        return PinholeCamera(width, height, focal, focal, (width - 1) / 2.0, (height - 1) / 2.0)

    def unproject(self, depth: FloatArray) -> NDArray[np.float32]:
        """Return the (H, W, 3) points (m, camera frame) of a (H, W) image of depth along z (m)."""
        u = (np.arange(self.width, dtype=np.float32) - np.float32(self.cx)) / np.float32(self.fx)
        v = (np.arange(self.height, dtype=np.float32) - np.float32(self.cy)) / np.float32(self.fy)
        depth = depth.astype(np.float32, copy=False)
        return np.stack([depth * u[None, :], depth * v[:, None], depth], axis=-1)

    def unproject_pixels(self, rows: NDArray[np.intp], columns: NDArray[np.intp], depth: FloatArray) -> FloatArray:
        """Return the (N, 3) points (m, camera frame) of N pixels, by their (N,) rows, columns and depths (m)."""
        rays = np.stack([(columns - self.cx) / self.fx, (rows - self.cy) / self.fy, np.ones(len(rows))], axis=1)
        return rays * depth[:, None]

    def project(self, points: FloatArray) -> NDArray[np.float64]:
        """Return the (..., 2) pixel coordinates (u, v) of (..., 3) points of the camera frame with z > 0."""
        points = np.asarray(points, dtype=np.float64)
        z = points[..., 2]
        return np.stack([self.fx * points[..., 0] / z + self.cx, self.fy * points[..., 1] / z + self.cy], axis=-1)


def pixels_of(mask: NDArray[np.bool_], most: int | None = None) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Return the (N,) rows and columns of an (H, W) mask's pixels, as `np.nonzero` does, but many times faster.

    Args:
        mask: (H, W).
        most: so many at most, evenly thinned.
    """
    found = np.flatnonzero(mask)
    every = 1 if most is None else max(1, -(-len(found) // most))
    rows, columns = np.divmod(found[::every], mask.shape[1])
    return rows, columns


def transform_points(a_to_b: FloatArray, points: FloatArray) -> NDArray[np.float64]:
    """Return (..., 3) points of frame a in frame b, by a (4, 4) rigid transform."""
    return np.asarray(points) @ a_to_b[:3, :3].T + a_to_b[:3, 3]


def grain_keys(points: NDArray[np.float64], grain: float) -> NDArray[np.int64]:
    """Return a number for the grain of space, a cube of a side (m), that each of (N, 3) points lies in.

    An axis has 21 bits, so that three of them make one key of 63: two million grains.
    """
    grains = np.floor(points / grain).astype(np.int64)
    low_bits = (1 << _GRAIN_BITS) - 1
    return (grains[:, 0] << 2 * _GRAIN_BITS) + ((grains[:, 1] & low_bits) << _GRAIN_BITS) + (grains[:, 2] & low_bits)


def invert_transform(a_to_b: FloatArray) -> NDArray[np.float64]:
    """Return `b_to_a` of a (4, 4) rigid transform."""
    rotation = a_to_b[:3, :3].T
    inverse = _IDENTITY.copy()
    inverse[:3, :3] = rotation
    inverse[:3, 3] = -rotation @ a_to_b[:3, 3]
    return inverse


def quaternion_to_matrix(quaternion: FloatArray) -> NDArray[np.float64]:
    """Return the (3, 3) rotation of a unit quaternion (w, x, y, z)."""
    w, x, y, z = np.asarray(quaternion, dtype=np.float64) / np.linalg.norm(quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def pose_matrix(position: FloatArray, quaternion: FloatArray) -> NDArray[np.float64]:
    """Return the (4, 4) transform of a position (m) and a unit quaternion (w, x, y, z)."""
    matrix = _IDENTITY.copy()
    matrix[:3, :3] = quaternion_to_matrix(quaternion)
    matrix[:3, 3] = position
    return matrix


def pose_matrices(poses: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the (N, 4, 4) transforms of (N, 7) positions (m) and unit quaternions; each as `pose_matrix` has it."""
    norms = np.sqrt(np.vecdot(poses[:, 3:], poses[:, 3:]))
    w, x, y, z = poses[:, 3:].T / norms
    matrices = np.zeros((len(poses), 4, 4))
    rows = (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )
    for i, row in enumerate(rows):
        for j, values in enumerate(row):
            matrices[:, i, j] = values
    matrices[:, :3, 3] = poses[:, :3]
    matrices[:, 3, 3] = 1.0
    return matrices


def yaw_quaternion(yaw: float) -> tuple[float, float, float, float]:
    """Return the quaternion (w, x, y, z) of a rotation about z (rad)."""
    return (math.cos(yaw / 2.0), 0.0, 0.0, math.sin(yaw / 2.0))
