"""Looking where the object is after the release (`verify_place`): it may have slid off, or lie on another thing."""

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import transform_points
from uniteam.mind.manipulation.arm_clearance import EMPTY_GRIPPER, SweepConfig
from uniteam.mind.manipulation.arm_path import TOP, ArmPath, is_path_free
from uniteam.mind.manipulation.place.after_release import Lying, wait_for_rest
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.mind.skills.skill import Skill, move_joints, turn_exactly
from uniteam.mind.skills.view import Points, View
from uniteam.stretch import gripper_to_base

REST_STEPS = 50
"""Steps at rest after which the challenge takes an object for placed."""
RAISE_BY = 0.15
"""m."""


@dataclass(frozen=True)
class WatchRest:
    """Waits until the object has not moved for long enough, as far as the robot sees; the longest where it does not.

    Attributes:
        still_steps: for so many steps it must not have moved; what rocks on another thing looks still before it is.
        still: it moves where its middle does by more (m).
        longest: after so many steps the robot waits no longer.
        unseen: after so many steps without a sight of it, the arm is taken out of the picture.
        raise_by: how far the arm is lifted before (m).
    """

    still_steps: int = REST_STEPS + 40
    still: float = 0.005
    longest: int = 200
    unseen: int = 10
    raise_by: float = RAISE_BY

    def __call__(self, view: View) -> Skill[View]:
        """Wait."""
        since, at, hidden = 0, _middle(view), 0
        for _ in range(self.longest):
            if at is not None and since >= self.still_steps:
                break
            view = yield wait_for_rest(view)
            now = _middle(view)
            hidden = hidden + 1 if now is None else 0
            if hidden == self.unseen:
                view = yield from take_arm_back(view, self.raise_by)
                now = _middle(view)
            if at is None or now is None or float(np.linalg.norm(now - at)) > self.still:
                since, at = 0, now
            else:
                since += 1
        return view


@dataclass(frozen=True)
class LookWhereItLies:
    """Takes the object for placed where it is seen on the goal receptacle, and where it is not seen at all.

    Once the arm is out of the picture, the robot looks for it on the floor and beyond, then to either side; where the
    arm cannot be taken back, it does not look.

    Attributes:
        beside: receptacle points so near to the object's, from above, are below it (m).
        below: so much lower than its lowest point they may be, or higher, as in a basin (m).
        raise_by: how far the arm is lifted before it is taken back (m).
        gazes: turns of the base and tilts of the head (rad), tried in this order where it is not in view.
    """

    beside: float = 0.08
    below: float = 0.05
    raise_by: float = RAISE_BY
    gazes: tuple[tuple[float, float], ...] = tuple(
        (math.radians(turned), math.radians(tilt)) for turned, tilt in ((0, -68), (0, -22), (35, -60), (-70, -60))
    )

    def __call__(self, view: View) -> Skill[Lying | None]:
        """Answer with where the object lies; None where it is as it should be, or not known."""
        if self._is_placed(view):
            return None
        view = yield from take_arm_back(view, self.raise_by)
        if view.observation.joints.arm > 0.0:
            return None
        for turned, tilt in self.gazes:
            if len(_dropped_points(view)):
                break
            view = yield from turn_exactly(view, turned, "I do not see it, so I look beside the arm.")
            looking = replace(view.observation.joints, head_tilt=tilt)
            view = yield from move_joints(view, looking, "I do not see it, so I look higher or lower.")
        points = _dropped_points(view)
        if len(points) == 0 or self._is_placed(view):
            return None
        x, y, _ = transform_points(view.observation.base_to_start.matrix(), points.mean(axis=0))
        return Lying(float(x), float(y))

    def _is_placed(self, view: View) -> bool:
        """Return whether the object is seen, and something of the goal receptacle below it."""
        points = _dropped_points(view)
        if len(points) == 0:
            return False
        receptacle = view.points(ClassRole.GOAL_RECEPTACLE)
        low, high = points.min(axis=0) - self.beside, points.max(axis=0) + self.beside
        is_near = ((receptacle[:, :2] > low[:2]) & (receptacle[:, :2] < high[:2])).all(axis=1)
        bottom = float(np.percentile(points[:, 2], 2))
        return bool(np.any(np.abs(receptacle[is_near, 2] - bottom) < self.below))


def take_arm_back(view: View, raise_by: float) -> Skill[View]:
    """Retract the arm, lifted (m) where it then touches nothing, for what it hides to be seen.

    It stays where it would touch something either way, and where it is retracted.
    """
    joints = view.observation.joints
    if joints.arm == 0.0:
        return view
    raised = replace(joints, lift=min(joints.lift + raise_by, TOP))
    ways = (
        ArmPath((joints, *stations)) for stations in ((raised, replace(raised, arm=0.0)), (replace(joints, arm=0.0),))
    )
    surroundings = view.surroundings()
    way = next((way for way in ways if is_path_free(way, surroundings, EMPTY_GRIPPER, SweepConfig())), None)
    for target in way.stations[1:] if way else ():
        view = yield from move_joints(view, target, "I take the arm back to see where it lies.")
    return view


def _dropped_points(view: View) -> Points:
    """Return the points (m, base frame) of the object nearest to where the gripper is: what it has let go."""
    return view.nearest(ClassRole.OBJECT, gripper_to_base(view.observation.joints)[:3, 3])


def _middle(view: View) -> NDArray[np.floating] | None:
    points = _dropped_points(view)
    return points.mean(axis=0) if len(points) else None
