"""The motors of a Stretch in time: joints that go to where they were sent, and a base that is driven in three ways."""

import math
from dataclasses import dataclass, fields, replace

from uniteam.geometry import BasePose, wrap_angle
from uniteam.interface import Joints
from uniteam.stretch import NAVIGATION_POSTURE, clamp_joints

RATES = Joints(lift=0.11, arm=0.14, wrist_yaw=3.0, wrist_pitch=3.0, wrist_roll=3.0, head_pan=3.0, head_tilt=3.0)
"""How fast the joints go (m/s, rad/s): the defaults of a Stretch 3."""
GRIPPER_RATE = 1.0
"""rad/s of a finger."""
SPEED, TURN_SPEED = 0.3, 1.5
"""What the base does at most (m/s, rad/s)."""
POSITION_SPEED, POSITION_TURN_SPEED = 0.12, 0.4
"""Of the base where it is moved by distances and angles (m/s, rad/s)."""
ACCELERATION, TURN_ACCELERATION = 0.3, 1.5
"""Of the base (m/s2, rad/s2)."""
VELOCITY_LASTS = 0.5
"""s after which the driver stops a base that was given no new velocity."""
GOAL_LASTS = 30.0
"""s after which the goto controller gives a goal up."""
_NEAR = 1e-4


@dataclass(frozen=True)
class Goal:
    """Where the base is to drive, in the frame of its odometry, and for how long it has been on its way (s)."""

    pose: BasePose
    age: float = 0.0


class Motors:
    """What moves a robot.

    Attributes:
        joints: where they are.
        joint_goal: where they were sent.
        gripper: angle of a finger (rad).
        gripper_stop: below which something between the fingers holds it up.
        goal: of the base, while it is on its way to one.
        has_failed: whether the last goal was given up.
    """

    def __init__(self, agility: float) -> None:
        """Stand still in the navigation posture, the gripper closed on nothing."""
        self._agility = agility
        self.joints = self.joint_goal = NAVIGATION_POSTURE
        self.gripper = self._gripper_goal = 0.0
        self.gripper_stop = -math.inf
        self.goal: Goal | None = None
        self.has_failed = False
        self._distance, self._angle = 0.0, 0.0
        self._velocity, self._wanted, self._age = (0.0, 0.0), (0.0, 0.0), math.inf

    @property
    def is_at_rest(self) -> bool:
        """Whether nothing moves, nor is to."""
        return (
            self.joints == self.joint_goal
            and self.is_gripper_at_rest
            and self.goal is None
            and self._distance == self._angle == 0.0
            and self._velocity == (0.0, 0.0)
            and (self._wanted == (0.0, 0.0) or self._age > VELOCITY_LASTS)
        )

    @property
    def is_gripper_at_rest(self) -> bool:
        """Whether the fingers are where they were sent, or held up."""
        return self.gripper == max(self._gripper_goal, self.gripper_stop)

    def send_joints(self, joints: Joints) -> None:
        """Send the joints to positions, or as near as their ranges allow."""
        self.joint_goal = clamp_joints(joints)

    def send_head(self, pan: float, tilt: float) -> None:
        """Send the head to a position."""
        self.send_joints(replace(self.joint_goal, head_pan=pan, head_tilt=tilt))

    def send_gripper(self, angle: float) -> None:
        """Send the fingers to an angle (rad)."""
        self._gripper_goal = min(max(angle, -0.37), 0.6)

    def send_base(self, velocity: tuple[float, float]) -> None:
        """Drive at velocities (m/s, rad/s) until told otherwise, or for as long as the driver lets them last."""
        self.goal, self._distance, self._angle = None, 0.0, 0.0
        self._wanted, self._age = velocity, 0.0

    def send_base_to(self, pose: BasePose) -> None:
        """Drive to a pose of the odometry."""
        self.stop_base()
        self.goal, self.has_failed = Goal(pose), False

    def send_base_by(self, distance: float) -> None:
        """Drive straight ahead by a distance (m)."""
        self.stop_base()
        self._distance = distance

    def turn_base_by(self, angle: float) -> None:
        """Turn on the spot by an angle (rad)."""
        self.stop_base()
        self._angle = angle

    def stop_base(self) -> None:
        """Stop the base where it is."""
        self.goal, self._distance, self._angle = None, 0.0, 0.0
        self._velocity = self._wanted = (0.0, 0.0)

    def freeze(self) -> None:
        """Stop everything and forget where it was to go, as a run-stop does."""
        self.stop_base()
        self.joint_goal, self._gripper_goal = self.joints, self.gripper

    def advance(self, seconds: float, base: BasePose) -> tuple[float, float]:
        """Let time pass and return by how much the base drives and then turns (m, rad).

        Args:
            seconds: how much time.
            base: where the odometry has it.
        """
        goal = self.joint_goal
        if self.joints != goal:
            steps = ((f.name, getattr(RATES, f.name) * self._agility * seconds) for f in fields(Joints))
            self.joints = Joints(*(_towards(getattr(self.joints, n), getattr(goal, n), step) for n, step in steps))
        grip = max(self._gripper_goal, self.gripper_stop)
        self.gripper = _towards(self.gripper, grip, GRIPPER_RATE * self._agility * seconds)
        if self.goal is not None:
            return self._towards_goal(self.goal, base, seconds)
        if self._distance != 0.0:
            step = _towards(0.0, self._distance, POSITION_SPEED * self._agility * seconds)
            self._distance -= step
            return step, 0.0
        if self._angle != 0.0:
            step = _towards(0.0, self._angle, POSITION_TURN_SPEED * self._agility * seconds)
            self._angle -= step
            return 0.0, step
        return self._at_velocity(seconds)

    def _at_velocity(self, seconds: float) -> tuple[float, float]:
        wanted = self._wanted if self._age <= VELOCITY_LASTS else (0.0, 0.0)
        self._age += seconds
        squared = self._agility**2 * seconds
        v = _towards(self._velocity[0], _cut(wanted[0], SPEED * self._agility), ACCELERATION * squared)
        w = _towards(self._velocity[1], _cut(wanted[1], TURN_SPEED * self._agility), TURN_ACCELERATION * squared)
        self._velocity = (v, w)
        return v * seconds, w * seconds

    def _towards_goal(self, goal: Goal, base: BasePose, seconds: float) -> tuple[float, float]:
        """Turn to where the goal is, drive there, turn as it says; each exactly."""
        self.goal = replace(goal, age=goal.age + seconds)
        rest = goal.pose.distance_to(base.x, base.y)
        step, turn = SPEED * self._agility * seconds, TURN_SPEED * self._agility * seconds
        if goal.age > GOAL_LASTS:
            self.goal, self.has_failed = None, True
            return 0.0, 0.0
        if rest > _NEAR:
            bearing = base.bearing_to(goal.pose.x, goal.pose.y)
            if abs(bearing) > _NEAR:
                return 0.0, _cut(bearing, turn)
            return min(rest, step), 0.0
        angle = wrap_angle(goal.pose.heading - base.heading)
        if abs(angle) > _NEAR:
            return 0.0, _cut(angle, turn)
        self.goal = None
        return 0.0, 0.0


def _towards(value: float, goal: float, step: float) -> float:
    return goal if abs(goal - value) <= step else value + math.copysign(step, goal - value)


def _cut(value: float, most: float) -> float:
    return min(max(value, -most), most)
