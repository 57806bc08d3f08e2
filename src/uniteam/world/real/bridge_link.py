"""A Stretch over the network, through the bridge of stretch_ai.

The base is driven by velocities which this side keeps to its limits and renews ten times a second: the robot's driver
stops a base that has been given none for half a second, so a laptop that hangs or a network that fails leaves nothing
in motion. (Goals, the bridge's other way, are driven to at speeds of the robot's own choice, to the end, whether or not
anybody is there; and it calls a goal reached that is 10 cm or 6 degrees off.) Small distances go through the arm's
mode, which moves the base by exact positions and feels what it meets.
"""

import math
from collections.abc import Callable, Generator, Iterator
from dataclasses import replace

from uniteam.geometry import BasePose, wrap_angle
from uniteam.interface import Joints
from uniteam.stretch import OPEN_FINGER, clamp_joints
from uniteam.world.real.channel import Channel
from uniteam.world.real.drive import Coast, Drive, travelled, turned
from uniteam.world.real.link import RobotState, View
from uniteam.world.real.messages import MANIPULATION, NAVIGATION, StateMessage, command
from uniteam.world.real.pace import Pace, Patience
from uniteam.world.real.robot_errors import SilentRobotError
from uniteam.world.real.safety import SafetyLimits

SMALL_DISTANCE = 0.2
"""Up to which (m) the base is moved by positions."""
GRIPPER_OPEN, GRIPPER_CLOSED = OPEN_FINGER, -0.3
"""What the gripper is sent to (rad of a finger); the fingertips touch at 0 and press below."""
STILL, STILL_ANGLE = 0.002, 0.01
"""What moved less from one look to the next (m; rad) stands still."""
NEAR, NEAR_ANGLE = 0.005, 0.02
"""How near (m; rad) to where it is to be a joint has arrived."""
BLOCKED = 0.02
"""How far (m) from where it was sent a base that was moved by a position has met something."""

Velocity = Callable[[float], dict[str, float]]
"""From a speed to the velocities of a base that moves along one axis."""


class BridgeLink:
    """A robot behind a `Channel`."""

    def __init__(self, channel: Channel, limits: SafetyLimits, pace: Pace, patience: Patience) -> None:
        """Take a robot that has been connected to; nothing is asked of it yet."""
        self._channel, self._limits, self._pace, self._patience = channel, limits, pace, patience
        self._base_x, self._goal = channel.state.base_x, channel.state.state.joints
        self._rolling, self._turning = Coast(), Coast()

    def glance(self) -> View:
        """Return the next picture that comes."""
        self._channel.refresh()
        return self._channel.observation.view()

    def look(self) -> View:
        """Return a picture taken after everything before was done.

        Messages bear no time. So the head is sent once more to where it was sent last, which both modes allow and moves
        nothing (sent to where it is it would sink, if it hangs a little low): a picture that acknowledges this is of
        after. The bridge takes the picture before it writes down the number, hence the second one is certainly new.
        """
        self._channel.refresh()
        for _ in self._asked(self._head_to_its_goal()):
            pass
        step, began = self._channel.state.step, self._channel.now()
        last, seen = self._channel.observation_count, 0
        while seen < 2 or self._channel.now() - began < self._pace.settle:
            if self._channel.now() - began > self._patience.picture:
                raise SilentRobotError(
                    f"the robot sent no picture of now in {self._patience.picture:g} s, only stale ones; see that its "
                    "cameras run"
                )
            self._channel.tick()
            if self._channel.observation_count > last and self._channel.observation.step >= step:
                seen += 1
            last = self._channel.observation_count
        return self._channel.observation.view()

    def turn(self, angle: float) -> Iterator[RobotState]:
        """Turn the base by velocities."""
        yield from self._mode(NAVIGATION)
        drive = Drive(angle, turned(), self._limits.turn_speed, STILL_ANGLE, self._pace, self._patience)
        yield from self._follow(drive, self._turning, _round)

    def translate(self, distance: float) -> Iterator[RobotState]:
        """Drive the base by velocities, or by a position where it is not far; from what is in its way, back again."""
        if abs(distance) < SMALL_DISTANCE:
            yield from self._mode(MANIPULATION)
            yield from self._shift(distance)
            return
        yield from self._mode(NAVIGATION)
        drive = self._along(distance)
        if (yield from self._follow(drive, self._rolling, _ahead)):
            yield from self._follow(self._along(drive.rest - distance), self._rolling, _ahead)

    def move_joints(self, joints: Joints) -> Iterator[RobotState]:
        """Move the joints; the head alone needs no change of mode."""
        now, self._goal = self._channel.refresh().state.joints, joints
        if _is_near(replace(now, head_pan=joints.head_pan, head_tilt=joints.head_tilt), joints):
            yield from self._asked(self._head_to_its_goal())
            yield from self._until_rest(lambda state: _is_near(state.joints, joints))
            return
        yield from self._mode(MANIPULATION)
        yield from self._send_joints(joints, 0.0)

    def grip(self, closed: bool) -> Iterator[RobotState]:
        """Send the gripper to an end of its range, and wait until it is there or cannot go on."""
        self._channel.refresh()
        goal = GRIPPER_CLOSED if closed else GRIPPER_OPEN
        yield from self._asked({"gripper": goal, "gripper_blocking": False})
        yield from self._until_rest(lambda state: abs(state.gripper - goal) < NEAR_ANGLE)

    def recover(self) -> None:
        """Wait for a robot that fell silent."""
        self._channel.refresh()

    def halt(self) -> None:
        """Stop, in the way that the robot's mode allows; the other would raise in its bridge."""
        state = self._channel.state
        self._goal = state.state.joints
        if state.mode == MANIPULATION:
            self._channel.blurt({"joint": command(state.base_x, clamp_joints(state.state.joints))})
            self._base_x = state.base_x
        else:
            self._channel.blurt({"base_velocity": {"v": 0.0, "w": 0.0}})

    def close(self) -> None:
        """Let go of the robot."""
        self._channel.close()

    def _mode(self, mode: str) -> Iterator[RobotState]:
        """Bring the robot into a mode; in it alone it takes the commands that belong there."""
        if self._channel.refresh().mode == mode:
            return
        yield from self._asked({"control_mode": mode})
        began = self._channel.now()
        while self._channel.state.mode != mode:
            if self._channel.now() - began > self._patience.mode:
                raise SilentRobotError(
                    f"the robot was not in its {mode} mode after {self._patience.mode:g} s; restart its bridge"
                )
            yield self._channel.tick().state
        self._base_x = 0.0

    def _along(self, distance: float) -> Drive:
        return Drive(distance, travelled(), self._limits.speed, STILL, self._pace, self._patience)

    def _shift(self, distance: float) -> Iterator[RobotState]:
        """Move the base by a position, in the arm's mode; from what is in its way, back again."""
        start = self._channel.state.state.base
        yield from self._send_joints(self._goal, distance)
        come = start.inverse().compose(self._channel.state.state.base).x
        if abs(distance - come) > BLOCKED:
            yield from self._send_joints(self._goal, -distance)

    def _follow(self, drive: Drive, coast: Coast, velocity: Velocity) -> Generator[RobotState, None, bool]:
        """Drive the base until it is where it was sent, and return whether something was in its way."""
        for _ in range(3):
            speed = yield from self._approach(drive, coast, velocity)
            rest, is_stuck = drive.rest, drive.is_stuck
            yield from self._asked({"base_velocity": velocity(0.0)})
            yield from self._until_rest(lambda state: False)
            drive.see(self._channel.state.state.base, self._channel.now())
            if is_stuck:
                return not drive.is_there
            coast.learn(rest - drive.rest, speed)
            if drive.is_there:
                return False
            drive.begin_again(self._channel.now())
        return False

    def _approach(self, drive: Drive, coast: Coast, velocity: Velocity) -> Generator[RobotState, None, float]:
        """Drive the base until it is to stop or is stuck, and return the speed that it was sent last (m/s or rad/s)."""
        speed, sent_at = 0.0, -math.inf
        obeyed, obeyed_at = self._channel.state.step, self._channel.now()
        while True:
            message, now = self._channel.tick(), self._channel.now()
            drive.see(message.state.base, now)
            if drive.is_to_stop(coast) or drive.is_stuck:
                return speed
            if message.step != obeyed:
                obeyed, obeyed_at = message.step, now
            if now - obeyed_at > self._patience.obey:
                raise SilentRobotError(
                    f"the robot has taken no velocity for {self._patience.obey:g} s; see that port 4402 is not barred"
                )
            if now - sent_at >= self._pace.command:
                speed = 0.0 if self._channel.is_uncertain else drive.speed()
                self._channel.send({"base_velocity": velocity(speed)})
                sent_at = now
            yield message.state

    def _send_joints(self, joints: Joints, distance: float) -> Iterator[RobotState]:
        """Move the joints, and the base by a small distance, in the arm's mode."""
        start, goal = self._channel.state.state.base, clamp_joints(joints)
        self._base_x += distance
        head = [goal.head_pan, goal.head_tilt]
        yield from self._asked({"joint": command(self._base_x, goal), "head_to": head, "manip_blocking": False})
        end = start.compose(BasePose(distance, 0.0, 0.0))
        yield from self._until_rest(
            lambda state: _is_near(state.joints, goal) and state.base.distance_to(end.x, end.y) < NEAR
        )
        yield from self._until_rest(lambda state: False) if distance else ()

    def _until_rest(self, arrived: Callable[[RobotState], bool]) -> Iterator[RobotState]:
        """Wait until the robot has arrived, or nothing of it has moved for a while."""
        began = still_since = self._channel.now()
        last = self._channel.state
        while self._channel.now() - began < self._patience.motion:
            message = self._channel.tick()
            if message is not last and not _stands_still(last, message):
                still_since, last = self._channel.now(), message
            if arrived(message.state) or self._channel.now() - still_since >= self._pace.rest:
                return
            yield message.state

    def _head_to_its_goal(self) -> dict[str, object]:
        return {"head_to": [self._goal.head_pan, self._goal.head_tilt], "manip_blocking": False}

    def _asked(self, action: dict[str, object]) -> Iterator[RobotState]:
        for message in self._channel.ask(action):
            yield message.state


def _ahead(speed: float) -> dict[str, float]:
    return {"v": speed, "w": 0.0}


def _round(speed: float) -> dict[str, float]:
    return {"v": 0.0, "w": speed}


def _stands_still(one: StateMessage, other: StateMessage) -> bool:
    bases = one.state.base, other.state.base
    return (
        bases[0].distance_to(bases[1].x, bases[1].y) < STILL
        and abs(wrap_angle(bases[0].heading - bases[1].heading)) < STILL_ANGLE
        and abs(one.state.gripper - other.state.gripper) < STILL_ANGLE
        and _differ_less(one.state.joints, other.state.joints, STILL, STILL_ANGLE)
    )


def _is_near(one: Joints, other: Joints) -> bool:
    return _differ_less(one, other, NEAR, NEAR_ANGLE)


def _differ_less(one: Joints, other: Joints, length: float, angle: float) -> bool:
    d = one - other
    angles = (d.wrist_yaw, d.wrist_pitch, d.wrist_roll, d.head_pan, d.head_tilt)
    return max(abs(d.lift), abs(d.arm)) < length and max(map(abs, angles)) < angle
