"""Grasping with the arm: bring the open gripper around the object, close it, lift, and look (`arm_grasp`).

The gripper hangs straight down where the lift is high enough for that, and else points down obliquely or straight
ahead. It is brought before the object's points as they are seen from where the robot stands, and moved along its
fingers until those are on either side of them. Whether closing it was a grasp, the gripper feels and the camera sees.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import islice

import numpy as np

from uniteam.interface import DiscreteAction, Joints
from uniteam.mind.manipulation.arm_clearance import Load, SweepConfig, is_sweep_free
from uniteam.mind.manipulation.arm_reach import HANGING_WRIST, ArmReach
from uniteam.mind.manipulation.pick.finger_room import STRAY, FingerShape, GraspPose, grasp_poses
from uniteam.mind.manipulation.pick.pick import Prepare, Taken, object_points
from uniteam.mind.manipulation.pick.reach_out_pick import ReachOut
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.mind.skills.skill import Skill, discrete, move_joints, turn_exactly
from uniteam.mind.skills.view import Points, View
from uniteam.stretch import FULL_OPENING, JOINT_LIMITS, clamp_joints, gripper_to_base

OPEN_FINGERS = Load(along_base=FULL_OPENING / 2.0 + FingerShape.thickness, along_arm=0.03, below=FingerShape.tip)
"""The room that open fingers take around the grasp centre, whichever way they are turned to the side."""


@dataclass(frozen=True)
class Way:
    """A grasp, the turn of the base to it (rad, left-positive), and the joints before the object and around it."""

    pose: GraspPose
    turn: float
    before: Joints
    around: Joints


@dataclass(frozen=True)
class ArmGrasp:
    """Takes the object with the fingers.

    Attributes:
        approach: how the base gets so near that the arm reaches the object.
        attempts: how often it tries.
        pitches: of the wrist, tried in this order (rad).
        advances: how far the gripper moves along its fingers to get around the object, tried in this order (m).
        lift: by how much the object is lifted at least before it is looked at (m).
        same_place: what is seen so near to where the object lay, from above, may be the object (m).
        slack: a turn that is smaller need not be made (rad).
        shape: of the gripper.
        sweep: the room the arm takes.
    """

    approach: Prepare = field(default_factory=lambda: ReachOut(reach=0.46, extensions=()))
    attempts: int = 3
    pitches: tuple[float, ...] = (JOINT_LIMITS[0].wrist_pitch, -0.8, -0.4, 0.0)
    advances: tuple[float, ...] = (0.15, 0.22, 0.3, 0.1)
    lift: float = 0.15
    same_place: float = 0.04
    slack: float = 0.02
    shape: FingerShape = field(default_factory=FingerShape)
    sweep: SweepConfig = field(default_factory=lambda: SweepConfig(hand=0.045, margin=0.01))

    def __call__(self, view: View, load: Load) -> Skill[Taken]:
        """Answer with the view after the last attempt; where there is no room for one, the gripper stays as it is."""
        view = yield from self.approach(view)
        for number in range(self.attempts):
            aim = next(islice(self._ways(view), number, None), None)
            if aim is None:
                break
            view = yield from turn_exactly(view, aim.turn, "I turn the arm to the object.")
            way = next((way for way in self._ways(view) if abs(way.turn) <= self.slack), None)
            if way is None:
                continue
            view = yield from self._reach_out(view, way)
            if view.observation.is_holding and not self._lies_still(view, way.pose):
                return Taken(view, _as_it_lies(load))
            view = yield from self._draw_back(view)
        return Taken(view, load)

    def _ways(self, view: View) -> Iterator[Way]:
        """Yield the grasps for which there is room, and to which the arm gets freely, the best first."""
        points, surroundings = object_points(view), view.surroundings()
        everything = np.concatenate([surroundings, points])
        for pitch in self.pitches:
            for pose in grasp_poses(points, surroundings, pitch, self.shape):
                ways = self._ways_to(pose, view.observation.joints)
                yield from islice((way for way in ways if self._is_free(way, everything)), 1)

    def _ways_to(self, pose: GraspPose, joints: Joints) -> Iterator[Way]:
        """Yield how the arm gets to a grasp once the base has turned to it; nothing where it is out of reach."""
        x, y, z = pose.centre
        reach = ArmReach.of_wrist(pose.pitch)
        distance, turn = reach.distance_to(x, y), reach.turn_to(x, y)
        if not (reach.near <= distance <= reach.far and reach.low <= z <= reach.high):
            return
        roll = -math.remainder(pose.turn - turn, math.pi) if pose.pitch <= HANGING_WRIST else 0.0
        around = reach.over(replace(joints, wrist_yaw=0.0, wrist_roll=roll), distance, z)
        for before in (_drawn_back(around, advance) for advance in self.advances):
            if before == clamp_joints(before):
                yield Way(pose, turn, before, around)

    def _is_free(self, way: Way, everything: Points) -> bool:
        """Return whether the arm, once the base has turned, touches nothing seen on its way to before the object."""
        c, s = math.cos(way.turn), math.sin(way.turn)
        turned = everything @ np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]], everything.dtype)
        return is_sweep_free(turned, way.before, OPEN_FINGERS, self.sweep)

    def _reach_out(self, view: View, way: Way) -> Skill[View]:
        """Bring the open gripper before the object and around it, close it, and lift it a little."""
        name = view.instruction.object_category.replace("_", " ")
        raised = replace(view.observation.joints, lift=way.before.lift, arm=0.0)
        view = yield from move_joints(view, raised, f"I bring the arm to the height of the {name}.")
        view = yield from move_joints(view, replace(way.before, arm=0.0), "I turn the wrist to it.")
        view = yield discrete(DiscreteAction.DESNAP_OBJECT, "I open the gripper.")
        view = yield from move_joints(view, way.before, f"I bring the gripper before the {name}.")
        view = yield from move_joints(view, way.around, f"I bring the open fingers to either side of the {name}.")
        view = yield discrete(DiscreteAction.SNAP_OBJECT, f"I close the fingers on the {name}.")
        lifted = replace(way.around, lift=max(way.around.lift + self.lift, way.before.lift))
        return (yield from move_joints(view, lifted, f"I lift the {name} and look."))

    def _lies_still(self, view: View, pose: GraspPose) -> bool:
        """Return whether an object is seen where it lay, though the gripper has been lifted."""
        points = view.points(ClassRole.OBJECT)
        there = points[np.hypot(*(points[:, :2] - pose.centre[:2]).T) < self.same_place]
        risen = gripper_to_base(view.observation.joints)[2, 3] - pose.centre[2]
        return len(there) > 0 and float(np.quantile(there[:, 2], STRAY)) < pose.bottom + risen / 2.0

    def _draw_back(self, view: View) -> Skill[View]:
        """Open the gripper, and take the arm out of the picture."""
        view = yield discrete(DiscreteAction.DESNAP_OBJECT, "I missed it, so I open the gripper.")
        return (yield from move_joints(view, replace(view.observation.joints, arm=0.0), "I retract the arm."))


def _drawn_back(around: Joints, advance: float) -> Joints:
    """Return the joints at which the gripper is so far (m) behind where it is at others, along its fingers."""
    rise, pull = -advance * math.sin(around.wrist_pitch), advance * math.cos(around.wrist_pitch)
    return replace(around, lift=around.lift + rise, arm=around.arm - pull)


def _as_it_lies(load: Load) -> Load:
    """Return the room of an object that is held as it lay, whichever way that is."""
    widest = math.hypot(load.along_base, load.along_arm)
    return replace(load, along_base=widest, along_arm=widest)
