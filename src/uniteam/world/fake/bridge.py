"""What the bridge of stretch_ai does with an action, and when it acknowledges it, for a simulated robot."""

import logging
from collections.abc import Callable

from uniteam.errors import UniteamError
from uniteam.geometry import BasePose
from uniteam.interface import Joints
from uniteam.stretch import MANIPULATION_POSTURE, NAVIGATION_POSTURE
from uniteam.world.fake.fake_stretch import FakeStretch
from uniteam.world.real.fields import Fields
from uniteam.world.real.messages import MANIPULATION, NAVIGATION
from uniteam.world.real.restricted_pickle import read_pickle
from uniteam.world.real.robot_errors import StrangeMessageError

BUSY = "none"
"""What the robot calls its mode while it changes it."""
MODE_SECONDS = 0.3
"""How long a change of mode takes, at a real robot's agility."""
FASTEST = 10.0
"""m/s and rad/s: what is larger is no velocity of a base."""

_log = logging.getLogger(__name__)


class FakeBridge:
    """The robot's side of the four ports, without the ports.

    One action is done at a time, and its number is acknowledged once it is. A number that is not above the last one is
    ignored. What a real bridge would fall over (joints outside the arm's mode, velocities within it) is not done and
    not acknowledged.

    Attributes:
        robot: that it speaks for.
        step: the highest number that was acknowledged; -1 at first.
        mode: "navigation", "manipulation", or "none" in between.
        refusals: what it refused, in sentences.
    """

    def __init__(self, robot: FakeStretch) -> None:
        """Speak for a robot, in navigation mode."""
        self.robot = robot
        self.step, self.mode = -1, NAVIGATION
        self.refusals: list[str] = []
        self._entered = robot.base
        self._doing: int | None = None
        self._is_done: Callable[[], bool] = lambda: True
        self._afterwards: Callable[[], None] = lambda: None

    @property
    def is_busy(self) -> bool:
        """Whether it does something that it must end before it takes the next action."""
        return self._doing is not None

    @property
    def base_x(self) -> float:
        """How far ahead the base has come since the arm's mode was entered (m); 0 in the other one."""
        return self._entered.inverse().compose(self.robot.base).x if self.mode == MANIPULATION else 0.0

    def tick(self) -> bool:
        """Let a moment pass and return whether a picture was taken."""
        took_picture = self.robot.tick()
        if self._doing is not None and self._is_done():
            self._afterwards()
            self.step, self._doing = max(self.step, self._doing), None
        return took_picture

    def receive(self, message: bytes) -> None:
        """Begin an action; what is none is refused and remembered."""
        try:
            action = Fields(read_pickle(message), "action")
            number = action.integer("step")
            if number <= self.step:
                return
            self._is_done, self._afterwards = lambda: True, lambda: None
            if not self.robot.is_run_stopped:
                self._begin(action)
            self._doing = number
        except UniteamError as error:
            self.refusals = [*self.refusals[-99:], str(error)]
            _log.warning("refused: %s", error)

    def _begin(self, action: Fields) -> None:
        """Begin the first of the things that an action asks for, in the real bridge's order; it drops the others."""
        beginnings: dict[str, Callable[[Fields], None]] = {
            "posture": self._take_posture,
            "control_mode": lambda fields: self._change_mode(_mode(fields, "control_mode")),
            "say": lambda fields: None,
            "say_sync": lambda fields: None,
            "xyt": self._go_to,
            "base_velocity": self._drive,
            "joint": self._move_joints,
            "head_to": self._move_head,
            "gripper": self._move_gripper,
        }
        for key, begin in beginnings.items():
            if action.has(key):
                begin(action)
                return
        raise StrangeMessageError("an action asks for nothing that a bridge knows")

    def _take_posture(self, action: Fields) -> None:
        mode = _mode(action, "posture")
        self.mode = BUSY
        self.robot.motors.stop_base()
        self.robot.motors.send_joints(MANIPULATION_POSTURE if mode == MANIPULATION else NAVIGATION_POSTURE)
        self._block(lambda: self.robot.motors.is_at_rest, lambda: self._enter(mode))

    def _change_mode(self, mode: str) -> None:
        self.mode = BUSY
        self.robot.motors.stop_base()
        ready = self.robot.time + MODE_SECONDS / self.robot.dials.agility
        self._block(lambda: self.robot.time >= ready, lambda: self._enter(mode))

    def _enter(self, mode: str) -> None:
        self.mode, self._entered = mode, self.robot.base

    def _go_to(self, action: Fields) -> None:
        x, y, heading = action.numbers("xyt", 3)
        pose = BasePose(float(x), float(y), float(heading))
        if action.has("nav_relative") and action.boolean("nav_relative"):
            pose = self.robot.base.compose(pose)
        self._enter(NAVIGATION)
        self.robot.motors.send_base_to(pose)

    def _drive(self, action: Fields) -> None:
        self._need(NAVIGATION)
        velocity = action.part("base_velocity")
        v, w = velocity.number("v", FASTEST), velocity.number("w", FASTEST)
        self.robot.motors.send_base((v, w))

    def _move_joints(self, action: Fields) -> None:
        self._need(MANIPULATION)
        base_x, lift, arm, yaw, pitch, roll = (float(n) for n in action.numbers("joint", 6))
        pan, tilt = action.numbers("head_to", 2) if action.has("head_to") else _head(self.robot.joints)
        self.robot.motors.send_joints(Joints(lift, arm, yaw, pitch, roll, float(pan), float(tilt)))
        self.robot.motors.send_base_by(base_x - self.base_x)
        if action.has("gripper"):
            self.robot.send_gripper(action.number("gripper", FASTEST))

    def _move_head(self, action: Fields) -> None:
        pan, tilt = action.numbers("head_to", 2)
        self.robot.motors.send_head(float(pan), float(tilt))

    def _move_gripper(self, action: Fields) -> None:
        self.robot.send_gripper(action.number("gripper", FASTEST))
        self._block(lambda: self.robot.motors.is_gripper_at_rest, lambda: None)

    def _block(self, is_done: Callable[[], bool], afterwards: Callable[[], None]) -> None:
        self._is_done, self._afterwards = is_done, afterwards

    def _need(self, mode: str) -> None:
        if self.mode != mode:
            raise StrangeMessageError(f"the robot takes this in its {mode} mode only, and is in '{self.mode}'")


def _mode(action: Fields, key: str) -> str:
    mode = action.word(key)
    if mode not in (NAVIGATION, MANIPULATION):
        raise StrangeMessageError(f"'{key}' of an action must be '{NAVIGATION}' or '{MANIPULATION}', got '{mode}'")
    return mode


def _head(joints: Joints) -> tuple[float, float]:
    return joints.head_pan, joints.head_tilt
