"""What stands for the Python package of the robot's maker: its calls, answered by a simulated robot.

As in stretch_body, base, lift and arm begin to move at `push_command`, head, wrist and gripper at once; headings count
from 0 to two pi, the gripper in percent. Time passes while somebody sleeps by the robot's own clock.
"""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from uniteam.interface import Joints
from uniteam.world.fake.fake_stretch import TICK, FakeStretch
from uniteam.world.real.head_camera import Picture

FINGER_LENGTH = 0.171
"""m."""
APERTURE_PER_PERCENT = 0.09 / 70.0
"""m: the fingertips are 9 cm apart at 70 %."""


class RobotClock:
    """The time of a simulated robot, which passes while it is waited for."""

    def __init__(self, robot: FakeStretch) -> None:
        self._robot = robot

    def now(self) -> float:
        """Return the robot's time (s)."""
        return self._robot.time

    def sleep(self, seconds: float) -> None:
        """Let the robot's time pass, in whole ticks."""
        for _ in range(max(1, round(seconds / TICK))):
            self._robot.tick()


class FakeHead:
    """The head camera of a simulated robot, upright as it is."""

    def __init__(self, robot: FakeStretch) -> None:
        self._robot = robot

    def read(self) -> Picture:
        """Wait for the next picture and return it."""
        while not self._robot.tick():
            pass
        frame = self._robot.frame
        rgb, depth = frame.rgb.copy(), frame.depth.copy()
        rgb.flags.writeable = depth.flags.writeable = False
        return rgb, depth, self._robot.simulator.camera

    def close(self) -> None:
        """Do nothing: there is nothing to let go of."""


class Robot:
    """Stands for `stretch_body.robot.Robot`.

    Attributes:
        base, lift, arm, head, end_of_arm: its parts, with the calls that are used of theirs.
        is_held: whether a process has hold of it.
    """

    def __init__(self, robot: FakeStretch) -> None:
        """Answer for a simulated robot."""
        self._robot = robot
        self._queue: list[Callable[[], None]] = []
        self.base, self.head, self.end_of_arm = _Base(robot, self._queue), _Head(robot), _EndOfArm(robot)
        self.lift, self.arm = _Stepper(robot, self._queue, "lift"), _Stepper(robot, self._queue, "arm")
        self.is_held = False

    def startup(self) -> bool:
        """Take hold of the hardware; False where somebody has it."""
        was_held, self.is_held = self.is_held, True
        return not was_held

    def is_homed(self) -> bool:
        """Return whether every joint knows where it is."""
        return True

    def push_command(self) -> None:
        """Begin what base, lift and arm were told, unless the run-stop is engaged."""
        if not self._robot.is_run_stopped:
            for command in self._queue:
                command()
        self._queue.clear()

    def get_status(self) -> dict[str, Any]:
        """Return a status with the fields that are used of the real one's."""
        base, joints, gripper = self._robot.base, self._robot.joints, self._robot.motors.gripper
        percent = 2.0 * gripper * FINGER_LENGTH / APERTURE_PER_PERCENT
        return {
            "base": {"x": base.x, "y": base.y, "theta": base.heading % math.tau, "pose_time_s": self._robot.time},
            "lift": {"pos": joints.lift},
            "arm": {"pos": joints.arm},
            "head": {name: {"pos": getattr(joints, name)} for name in ("head_pan", "head_tilt")},
            "end_of_arm": {
                **{name: {"pos": getattr(joints, name)} for name in ("wrist_yaw", "wrist_pitch", "wrist_roll")},
                "stretch_gripper": {"pos_pct": percent, "gripper_conversion": {"finger_rad": gripper}},
            },
            "pimu": {"runstop_event": self._robot.is_run_stopped},
        }

    def stop(self) -> None:
        """Let go of the hardware."""
        self.is_held = False


class _Base:
    def __init__(self, robot: FakeStretch, queue: list[Callable[[], None]]) -> None:
        self._robot, self._queue = robot, queue

    def translate_by(self, x_m: float, v_m: float | None = None, a_m: float | None = None) -> None:
        """Queue a distance."""
        self._queue.append(lambda: self._robot.motors.send_base_by(x_m))

    def rotate_by(self, x_r: float, v_r: float | None = None, a_r: float | None = None) -> None:
        """Queue an angle."""
        self._queue.append(lambda: self._robot.motors.turn_base_by(x_r))

    def set_velocity(self, v_m: float, w_r: float) -> None:
        """Queue velocities."""
        self._queue.append(lambda: self._robot.motors.send_base((v_m, w_r)))


class _Stepper:
    def __init__(self, robot: FakeStretch, queue: list[Callable[[], None]], name: str) -> None:
        self._robot, self._queue, self._name = robot, queue, name

    def move_to(self, x_m: float) -> None:
        """Queue a position."""
        self._queue.append(lambda: _send(self._robot, self._name, x_m))

    def move_by(self, x_m: float) -> None:
        """Queue a position relative to where the joint is when that is pushed."""
        self._queue.append(lambda: _send(self._robot, self._name, getattr(self._robot.joints, self._name) + x_m))


class _Head:
    def __init__(self, robot: FakeStretch) -> None:
        self._robot = robot

    def move_to(self, joint: str, x_r: float) -> None:
        """Send a joint to a position."""
        _send(self._robot, joint, x_r)


class _EndOfArm(_Head):
    def move_to(self, joint: str, x_r: float) -> None:
        """Send a joint to a position (rad), or the gripper (percent)."""
        if joint != "stretch_gripper":
            super().move_to(joint, x_r)
        elif not self._robot.is_run_stopped:
            self._robot.send_gripper(float(np.clip(x_r, -100.0, 100.0)) * APERTURE_PER_PERCENT / 2.0 / FINGER_LENGTH)


def _send(robot: FakeStretch, joint: str, position: float) -> None:
    if not robot.is_run_stopped:
        wanted: Joints = replace(robot.motors.joint_goal, **{joint: position})
        robot.motors.send_joints(wanted)
