"""What the gripper holds, and where it hangs."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class HeldObject:
    """An object that hangs in the gripper.

    It stays as level as it lay, however the wrist turns.

    Attributes:
        name: of the instance.
        axes: (3, 3) rotation from the model's frame to the base frame.
        offset: (3,) from the grasp centre to the model's origin (m, base frame).
        radius: the largest distance of any of its points from the grasp centre (m).
    """

    name: str
    axes: NDArray[np.float64]
    offset: NDArray[np.float64]
    radius: float

    def to_base(self, gripper_to_base: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the (4, 4) transform from the model's frame to the base frame."""
        matrix = np.eye(4)
        matrix[:3, :3] = self.axes
        matrix[:3, 3] = gripper_to_base[:3, 3] + self.offset
        return matrix


Hold = Callable[[str, NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]], HeldObject]
"""From an object's name, the (V, 3) vertices of its collision shapes (m, model frame), the (4, 4) pose (base frame) in
which it lay and the grasp centre (3,) (m, base frame) to how it is held."""


def hang(
    name: str, vertices: NDArray[np.float64], object_to_base: NDArray[np.float64], grasp_centre: NDArray[np.float64]
) -> HeldObject:
    """Return the object as the challenge's gripper takes it: with its top centred at the grasp centre.

    It is turned about the vertical so that its long side lies along the base. So a long object sticks out ahead and
    behind, not to the side, and lies along a shelf's edge when it is put down. Takes what `Hold` says.
    """
    axes = _turn_long_side(vertices @ object_to_base[:3, :3].T) @ object_to_base[:3, :3]
    points = vertices @ axes.T
    low, high = points.min(axis=0), points.max(axis=0)
    offset = -np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, high[2]])
    return HeldObject(name, axes, offset, float(np.linalg.norm(points + offset, axis=1).max()))


def hold_as_it_lies(
    name: str, vertices: NDArray[np.float64], object_to_base: NDArray[np.float64], grasp_centre: NDArray[np.float64]
) -> HeldObject:
    """Return the object as fingers take it that close around it: where it is. Takes what `Hold` says."""
    axes, offset = object_to_base[:3, :3], object_to_base[:3, 3] - grasp_centre
    return HeldObject(name, axes, offset, float(np.linalg.norm(vertices @ axes.T + offset, axis=1).max()))


def _turn_long_side(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the least rotation about z that lays the long side of (V, 3) points, seen from above, along x."""
    corners = cv2.boxPoints(cv2.minAreaRect(points[:, :2].astype(np.float32))).astype(np.float64)
    sides = np.diff(corners[:3], axis=0)
    x, y = max(sides, key=lambda side: float(np.hypot(*side)))
    turn = -math.atan(y / x) if x != 0.0 else math.pi / 2
    c, s = math.cos(turn), math.sin(turn)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
