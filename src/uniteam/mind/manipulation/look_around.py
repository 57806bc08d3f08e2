"""Looking around at the pick: what to do when the object is not where the arm points, or not within its reach."""

import math
from dataclasses import dataclass, replace

import numpy as np

from uniteam.interface import DiscreteAction
from uniteam.mind.manipulation.pick import object_points
from uniteam.mind.manipulation.reach import Reach
from uniteam.mind.manipulation.skill import (
    LONGEST_DRIVE,
    SMALLEST_DRIVE,
    SMALLEST_TURN,
    Skill,
    discrete,
    drive,
    move_joints,
    turn,
)
from uniteam.mind.manipulation.view import View
from uniteam.stretch import gripper_to_base


@dataclass(frozen=True)
class LookAround:
    """Turns left and right until the object is in view, then brings the gripper within reach of it.

    Attributes:
        tilts: of the head, tried before the base turns (rad): a high object is above the picture, a low one below.
        turns: of the whole base, one after the other (rad).
        reach: how far (m) from the grasp centre the object's middle may be.
        approaches: how often the robot drives closer at most.
    """

    tilts: tuple[float, ...] = (math.radians(-22.0), math.radians(-68.0))
    turns: tuple[float, ...] = tuple(math.radians(degrees) for degrees in (30, 30, -90, -30))
    reach: float = 0.7
    approaches: int = 3

    def __call__(self, view: View) -> Skill[View]:
        """Answer with the view from which to snap."""
        view = yield from self._search(view)
        for _ in range(self.approaches):
            view = yield from self._lift_gripper(view)
            if self._shortfall(view) <= 0.0:
                break
            view = yield from self._drive_closer(view)
        return view

    def _search(self, view: View) -> Skill[View]:
        at_first = view.observation.joints
        for tilt in (*self.tilts, at_first.head_tilt):
            if len(object_points(view)):
                break
            target = replace(view.observation.joints, head_tilt=tilt)
            view = yield from move_joints(view, target, "The object is not in view of the arm; I tilt the head.")
        for angle in self.turns:
            if len(object_points(view)):
                break
            side = "left" if angle > 0 else "right"
            view = yield turn(angle, f"The object is not in view of the arm; I look further to the {side}.")
        return view

    def _lift_gripper(self, view: View) -> Skill[View]:
        """Bring the gripper to the object's height while the arm is retracted, where it touches nothing."""
        if self._shortfall(view) <= 0.0:
            return view
        joints = view.observation.joints
        height = float(np.median(object_points(view)[:, 2]))
        target = replace(joints, lift=Reach.of_wrist(joints.wrist_pitch).lift_for(height))
        return (yield from move_joints(view, target, "I bring the gripper to the object's height."))

    def _drive_closer(self, view: View) -> Skill[View]:
        """Turn to the object, drive towards it and point the arm at it again."""
        x, y, _ = object_points(view).mean(axis=0)
        bearing = math.remainder(math.atan2(y, x) + math.pi / 2, 2 * math.pi)
        distance = min(max(self._shortfall(view), SMALLEST_DRIVE), LONGEST_DRIVE)
        view = yield discrete(DiscreteAction.NAVIGATION_MODE, "The object is beyond reach, so I drive closer.")
        if abs(bearing) >= SMALLEST_TURN:
            view = yield turn(bearing, "I turn to the object.")
        view = yield drive(distance, f"I drive {distance:.2f} m closer to the object.")
        return (yield discrete(DiscreteAction.MANIPULATION_MODE, "I point the arm at the object again."))

    def _shortfall(self, view: View) -> float:
        """Return how far (m) the object is beyond reach; 0 where it is not in view."""
        points = object_points(view)
        if len(points) == 0:
            return 0.0
        gripper = gripper_to_base(view.observation.joints)[:3, 3]
        return max(0.0, float(np.linalg.norm(points.mean(axis=0) - gripper)) - self.reach)
