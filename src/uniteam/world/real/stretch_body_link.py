"""A Stretch from within: through stretch_body, in a process on the robot itself.

Base motions are commanded as distances and angles, each of which the robot's firmware ends by itself, so that a process
that dies leaves at most the rest of one motion. Nothing here was tried on hardware; the calls are those of stretch_body
0.7. Its packages are imported only where this is used.
"""

from collections.abc import Iterator, Mapping
from importlib import import_module
from typing import Any, Protocol

import numpy as np

from uniteam.errors import UnavailableError
from uniteam.geometry import BasePose, wrap_angle
from uniteam.interface import Joints
from uniteam.stretch import FULL_OPENING, clamp_joints, head_camera_to_base
from uniteam.world.real.head_camera import HeadCamera, RealSenseHead
from uniteam.world.real.link import Clock, RobotState, View
from uniteam.world.real.pace import Pace, Patience
from uniteam.world.real.robot_errors import RobotError, SilentRobotError
from uniteam.world.real.safety import SafetyLimits, check_run_stop
from uniteam.world.real.system_clock import SystemClock

ACCELERATION, TURN_ACCELERATION = 0.1, 0.3
"""Of the base (m/s2, rad/s2): gentle."""
GRIPPER_OPEN, GRIPPER_CLOSED = FULL_OPENING / 0.09 * 70.0, -100.0
"""What the gripper is sent to, in its own percent: the fingertips touch at 0 and are 0.09 m apart at 70."""
STILL, STILL_ANGLE = 0.002, 0.01
"""What moved less from one look to the next (m; rad) stands still."""

Status = Mapping[str, Any]


class BodyRobot(Protocol):
    """What is used of `stretch_body.robot.Robot`."""

    base: Any
    lift: Any
    arm: Any
    head: Any
    end_of_arm: Any

    def startup(self) -> bool:
        """Take hold of the hardware; False where another process has it."""

    def is_homed(self) -> bool:
        """Return whether every joint knows where it is."""

    def get_status(self) -> dict[str, Any]:
        """Return what it last heard of its parts."""

    def push_command(self) -> None:
        """Begin what base, lift and arm were told."""

    def stop(self) -> None:
        """Let go of the hardware."""


class StretchBodyLink:
    """A robot held by this process."""

    def __init__(
        self, robot: BodyRobot, camera: HeadCamera, clock: Clock, limits: SafetyLimits, pace: Pace, patience: Patience
    ) -> None:
        """Take hold of a robot and its head camera; nothing moves.

        Raises:
            RobotError: another process has it, or it is not homed, or run-stopped.
        """
        self._robot, self._camera, self._clock = robot, camera, clock
        self._limits, self._pace, self._patience = limits, pace, patience
        self._heard, self._heard_at = -1.0, clock.now()
        if not robot.startup():
            raise RobotError("another process has hold of the robot; end it (stretch_free_robot_process.py)")
        if not robot.is_homed():
            robot.stop()
            raise RobotError("the robot is not homed, so its arm would not move; run stretch_robot_home.py")
        self._tick()

    def glance(self) -> View:
        """Return the next picture."""
        state = self._tick()
        rgb, depth, camera = self._camera.read()
        camera_to_world = np.asarray(state.base.matrix() @ head_camera_to_base(state.joints))
        return View(rgb, depth, camera, camera_to_world, state)

    def look(self) -> View:
        """Return a picture taken after everything before was done: two that were under way are dropped."""
        self._clock.sleep(self._pace.settle)
        self._camera.read(), self._camera.read()
        return self.glance()

    def turn(self, angle: float) -> Iterator[RobotState]:
        """Turn the base by an angle, which the firmware ends."""
        self._robot.base.rotate_by(angle, self._limits.turn_speed, TURN_ACCELERATION)
        self._robot.push_command()
        return self._until_rest()

    def translate(self, distance: float) -> Iterator[RobotState]:
        """Drive the base by a distance, which the firmware ends."""
        self._robot.base.translate_by(distance, self._limits.speed, ACCELERATION)
        self._robot.push_command()
        return self._until_rest()

    def move_joints(self, joints: Joints) -> Iterator[RobotState]:
        """Send every joint to its position; stretch_body cuts it to what this robot can reach."""
        goal = clamp_joints(joints)
        self._robot.lift.move_to(goal.lift)
        self._robot.arm.move_to(goal.arm)
        self._robot.push_command()
        for name in ("wrist_yaw", "wrist_pitch", "wrist_roll"):
            self._robot.end_of_arm.move_to(name, getattr(goal, name))
        for name in ("head_pan", "head_tilt"):
            self._robot.head.move_to(name, getattr(goal, name))
        return self._until_rest()

    def grip(self, closed: bool) -> Iterator[RobotState]:
        """Close or open the gripper; its firmware eases off where it is held up."""
        self._robot.end_of_arm.move_to("stretch_gripper", GRIPPER_CLOSED if closed else GRIPPER_OPEN)
        return self._until_rest()

    def recover(self) -> None:
        """Wait until the robot's parts are heard again."""
        began = self._clock.now()
        while not self._is_fresh(self._robot.get_status()):
            if self._clock.now() - began > self._patience.recover:
                raise SilentRobotError(f"the robot's parts sent nothing for {self._patience.recover:g} s; restart it")
            self._clock.sleep(self._pace.poll)

    def halt(self) -> None:
        """Stop base, lift and arm where they are; it never raises."""
        try:
            self._robot.base.set_velocity(0.0, 0.0)
            self._robot.lift.move_by(0.0)
            self._robot.arm.move_by(0.0)
            self._robot.push_command()
        except Exception:  # there is nothing more that could be done
            return

    def close(self) -> None:
        """Let go of the robot and its camera."""
        self._robot.stop()
        self._camera.close()

    def _tick(self) -> RobotState:
        """Let a moment pass and return the state; raises RobotError where it is old or the run-stop is engaged."""
        self._clock.sleep(self._pace.poll)
        status = self._robot.get_status()
        if not self._is_fresh(status):
            raise SilentRobotError(
                f"the robot's base has said nothing new for {self._limits.stale:g} s; the base was told to stop"
            )
        state = state_of(status)
        check_run_stop(state)
        return state

    def _is_fresh(self, status: Status) -> bool:
        """Return whether the base has been heard of late; its status bears its own time."""
        heard, now = float(status["base"]["pose_time_s"]), self._clock.now()
        if heard != self._heard:
            self._heard, self._heard_at = heard, now
        return now - self._heard_at <= self._limits.stale

    def _until_rest(self) -> Iterator[RobotState]:
        """Yield states until nothing has moved for a while, from the command's first effect on."""
        began = still_since = self._clock.now()
        last = self._tick()
        while self._clock.now() - began < self._patience.motion:
            state = self._tick()
            if not _stands_still(last, state):
                still_since, last = self._clock.now(), state
            if self._clock.now() - still_since >= self._pace.rest:
                return
            yield state


def state_of(status: Status) -> RobotState:
    """Return the state of a stretch_body status; raises RobotError where it lacks something or is not finite."""
    try:
        base, head, hand = status["base"], status["head"], status["end_of_arm"]
        joints = Joints(
            lift=float(status["lift"]["pos"]),
            arm=float(status["arm"]["pos"]),
            **{name: float(hand[name]["pos"]) for name in ("wrist_yaw", "wrist_pitch", "wrist_roll")},
            **{name: float(head[name]["pos"]) for name in ("head_pan", "head_tilt")},
        )
        pose = BasePose(float(base["x"]), float(base["y"]), wrap_angle(float(base["theta"])))
        finger = float(hand["stretch_gripper"]["gripper_conversion"]["finger_rad"])
        is_run_stopped = bool(status["pimu"]["runstop_event"])
    except KeyError as error:
        raise RobotError(
            f"the robot's status lacks {error}; a Stretch with the dexterous wrist and its gripper is needed"
        ) from error
    if not np.isfinite([*vars(joints).values(), pose.x, pose.y, pose.heading, finger]).all():
        raise RobotError("the robot's status holds numbers that are not finite; restart it")
    return RobotState(pose, joints, finger, is_run_stopped)


def _stands_still(one: RobotState, other: RobotState) -> bool:
    lengths = [one.base.distance_to(other.base.x, other.base.y)]
    lengths += [abs(one.joints.lift - other.joints.lift), abs(one.joints.arm - other.joints.arm)]
    names = ("wrist_yaw", "wrist_pitch", "wrist_roll", "head_pan", "head_tilt")
    angles = [abs(getattr(one.joints, name) - getattr(other.joints, name)) for name in names]
    angles += [abs(wrap_angle(one.base.heading - other.base.heading)), abs(one.gripper - other.gripper)]
    return max(lengths) < STILL and max(angles) < STILL_ANGLE


def connect_stretch_body(limits: SafetyLimits) -> StretchBodyLink:
    """Take hold of the robot on which this runs.

    Raises:
        UnavailableError: stretch_body or pyrealsense2 is not installed, or the camera is not there.
        RobotError: another process has the robot, or it is not homed, or run-stopped.
    """
    try:
        robot = import_module("stretch_body.robot").Robot()
    except ImportError as error:
        raise UnavailableError(
            f"'here' means the robot itself, through stretch_body, which cannot be imported ({error}); run this on the "
            "robot, in the environment of its maker, or give the robot's address"
        ) from error
    return StretchBodyLink(robot, RealSenseHead(), SystemClock(), limits, Pace(), Patience())
