"""What a body needs of a robot, whichever way it is reached: to look, to move, to stop.

A motion is an iterator: the robot moves while it is gone through, and each state it yields may be looked at before the
motion goes on. Whoever leaves one before its end calls `halt`.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Joints, Segmentation


class Clock(Protocol):
    """Time: the machine's own, or that of a robot that only stands for one."""

    def now(self) -> float:
        """Return the time (s), from wherever it is counted."""

    def sleep(self, seconds: float) -> None:
        """Let time pass."""


@dataclass(frozen=True)
class RobotState:
    """What a robot says of itself.

    Attributes:
        base: where it believes that its base is, in a frame of its own: the world of its odometry or of its map.
        joints: where its joints are.
        gripper: angle of a finger (rad): 0 where the fingertips touch, positive where they are apart.
        is_run_stopped: whether its run-stop is engaged; no motor moves then.
    """

    base: BasePose
    joints: Joints
    gripper: float
    is_run_stopped: bool


@dataclass(frozen=True)
class View:
    """A picture of the head camera, and the state in which it was taken.

    Attributes:
        rgb: (H, W, 3) uint8, upright, read-only.
        depth: (H, W) float32 (m), 0 where nothing returned, read-only.
        camera: intrinsics of both.
        camera_to_world: (4, 4) float64, from OpenCV's axes to the frame of `state.base`.
        state: of the robot.
        truth: a simulator's own segmentation; None from a robot.
    """

    rgb: NDArray[np.uint8]
    depth: NDArray[np.float32]
    camera: PinholeCamera
    camera_to_world: NDArray[np.float64]
    state: RobotState
    truth: Segmentation | None = None


class RobotLink(Protocol):
    """A robot that can be reached. All methods but `halt` and `close` raise RobotError where it cannot go on."""

    def glance(self) -> View:
        """Return the next picture that comes, without asking the robot for anything."""

    def look(self) -> View:
        """Return a picture that was taken after all that was asked before had been done."""

    def turn(self, angle: float) -> Iterator[RobotState]:
        """Turn the base on the spot (rad, left-positive)."""

    def translate(self, distance: float) -> Iterator[RobotState]:
        """Drive the base straight ahead (m), or back where it is negative."""

    def move_joints(self, joints: Joints) -> Iterator[RobotState]:
        """Move every joint to its position, or as near as it gets."""

    def grip(self, closed: bool) -> Iterator[RobotState]:
        """Close the gripper on whatever is between its fingers, or open it."""

    def recover(self) -> None:
        """Wait for a robot that fell silent; raises SilentRobotError where it does not come back."""

    def halt(self) -> None:
        """Stop base and arm, whatever they do; it never raises, and may be called at any time."""

    def close(self) -> None:
        """Let go of the robot."""
