"""Reaching out at the pick: what to do when the object is in view but beyond the gripper's reach (`reach_out_pick`)."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import product

import numpy as np
from numpy.typing import NDArray

from uniteam.interface import DiscreteAction, Joints
from uniteam.mind.manipulation.arm_clearance import EMPTY_GRIPPER, SweepConfig
from uniteam.mind.manipulation.arm_path import ArmPath, is_path_free
from uniteam.mind.manipulation.arm_reach import ArmReach
from uniteam.mind.manipulation.leave_manipulation import QUARTER, quarters_turned
from uniteam.mind.manipulation.pick.pick import load_seen, object_points
from uniteam.mind.skills.skill import (
    LONGEST_DRIVE,
    SMALLEST_DRIVE,
    SMALLEST_TURN,
    Skill,
    discrete,
    drive,
    move_joints,
    turn,
)
from uniteam.mind.skills.view import View
from uniteam.stretch import GRASP_RANGE, gripper_to_base


@dataclass(frozen=True)
class ReachOut:
    """Brings the gripper within reach of the object: drives closer, extends the arm.

    Attributes:
        reach: how far (m) from the grasp centre the object's middle may be in the horizontal plane: a little less than
            the gripper bridges, since the middle of what is seen is not the middle of the object.
        approaches: how often the robot drives closer at most.
        extensions: of the arm, tried in this order where the base cannot get closer (m).
        heights: of the grasp centre above the object's top when the arm is extended, tried in this order (m).
        sweep: the room the arm takes.
    """

    reach: float = GRASP_RANGE - 0.06
    approaches: int = 4
    extensions: tuple[float, ...] = (0.1, 0.2, 0.3, 0.4, 0.52)
    heights: tuple[float, ...] = (0.06, 0.16, 0.3, 0.5, 0.8)
    sweep: SweepConfig = field(default_factory=SweepConfig)

    def __call__(self, view: View) -> Skill[View]:
        """Answer with the view from which to snap."""
        longest = LONGEST_DRIVE
        for _ in range(self.approaches):
            if self._shortfall(view) <= 0.0:
                return view
            before, distance = view.observation.base_to_start, self._way_closer(view, longest)
            view = yield from self._drive_closer(view, distance)
            now = view.observation.base_to_start
            if before.distance_to(now.x, now.y) < SMALLEST_DRIVE / 2:
                if distance <= SMALLEST_DRIVE:
                    break
                longest = distance / 2.0  # what is blocked does not move at all, and half of the way may be free
        return (yield from self._reach_out(view))

    def _way_closer(self, view: View, longest: float) -> float:
        """Return how far (m) to drive towards the object."""
        return max(min(self._shortfall(view), longest), SMALLEST_DRIVE)

    def _reach_out(self, view: View) -> Skill[View]:
        """Extend the arm over what is in between, as little as brings the object within reach and touches nothing.

        Where the arm gets there freely, but not back with the object, it goes all the same: what brushes something then
        is the object.
        """
        if self._shortfall(view) <= 0.0:
            return view
        surroundings, points, load = view.surroundings(), object_points(view), load_seen(view)
        everything = np.concatenate([surroundings, points])
        free = [path for path in self._paths(view) if is_path_free(path, everything, EMPTY_GRIPPER, self.sweep)]
        with_it = (path for path in free if is_path_free(path, surroundings, load, self.sweep))
        chosen = next(with_it, free[0] if free else None)
        for station in chosen.stations if chosen else ():
            view = yield from move_joints(view, station, "The object is beyond reach, so I extend the arm over it.")
        return view

    def _paths(self, view: View) -> Iterator[ArmPath]:
        """Yield the ways to bring the gripper within reach, the best first."""
        joints = view.observation.joints
        reach, top = ArmReach.of_wrist(joints.wrist_pitch), float(object_points(view)[:, 2].max())
        for arm, above in product(self.extensions, self.heights):
            end = replace(joints, lift=reach.lift_for(top + above), arm=arm)
            if _distance(view, end) <= self.reach:
                yield ArmPath((replace(joints, lift=end.lift), end))

    def _drive_closer(self, view: View, distance: float) -> Skill[View]:
        """Turn to the object, drive towards it and point the arm at it again."""
        x, y, _ = _middle(view)
        before = view.observation.base_to_start.heading
        view = yield discrete(DiscreteAction.NAVIGATION_MODE, "The object is beyond reach, so I drive closer.")
        bearing = math.remainder(math.atan2(y, x) - quarters_turned(before, view) * QUARTER, 2 * math.pi)
        if abs(bearing) >= SMALLEST_TURN:
            view = yield turn(bearing, "I turn to the object.")
        view = yield drive(distance, f"I drive {distance:.2f} m closer to the object.")
        return (yield discrete(DiscreteAction.MANIPULATION_MODE, "I point the arm at the object again."))

    def _shortfall(self, view: View) -> float:
        """Return how far (m) the object is beyond reach; 0 where it is not in view."""
        if len(object_points(view)) == 0:
            return 0.0
        return max(0.0, _distance(view, view.observation.joints) - self.reach)


def _distance(view: View, joints: Joints) -> float:
    """Return how far (m) what is seen of the object is from the gripper at `joints`, in the horizontal plane."""
    x, y = _middle(view)[:2] - gripper_to_base(joints)[:2, 3]
    return math.hypot(x, y)


def _middle(view: View) -> NDArray[np.float64]:
    """Return (3,) the middle (m, base frame) of what is seen of the object."""
    low, high = np.percentile(object_points(view), (2, 98), axis=0)
    return np.asarray((low + high) / 2)
