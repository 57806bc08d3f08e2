"""Picking: stand beside the object, look along the arm, and let the gripper snap at it."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import cv2
import numpy as np

from uniteam.interface import DiscreteAction
from uniteam.mind.manipulation.arm_clearance import Load
from uniteam.mind.manipulation.leave_manipulation import fold
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.mind.skills.skill import Skill, discrete, move_joints
from uniteam.mind.skills.view import Points, View
from uniteam.stretch import gripper_to_base

Prepare = Callable[[View], Skill[View]]
"""What is done between standing in manipulation mode and snapping; answers with the last view."""
GraspCheck = Callable[[View], bool]
"""Whether the view after the grasp says that it was a success."""


@dataclass(frozen=True)
class Taken:
    """What is seen once the gripper has closed, and the room that what it holds then takes, as far as is known."""

    view: View
    load: Load


Take = Callable[[View, Load], Skill[Taken]]
"""How the gripper is closed on the object, given the room that was seen of it."""


def do_nothing(view: View) -> Skill[View]:
    """Leave everything as it is."""
    yield from ()
    return view


def snap(view: View, load: Load) -> Skill[Taken]:
    """Snap at the object from where the gripper is, as in the challenge."""
    name = view.instruction.object_category.replace("_", " ")
    view = yield discrete(DiscreteAction.SNAP_OBJECT, f"I snap at the {name}.")
    return Taken(view, load)


@dataclass(frozen=True)
class PickConfig:
    """The strategies of picking; `BASELINE_PICK` holds those of HomeRobot's heuristic baseline (arXiv 2306.11565).

    Attributes:
        tilt_head: how the head looks for the object.
        step_back: how the base then draws back for it.
        take: how the gripper then takes it.
        look_around: how the base then looks for it.
        reach_out: how the gripper is then brought within reach of it.
        is_grasped: how that is judged.
        leave: how the robot gets back to driving.
    """

    tilt_head: Prepare
    look_around: Prepare
    reach_out: Prepare
    is_grasped: GraspCheck
    leave: Callable[[View, str], Skill[View]] = fold
    step_back: Prepare = do_nothing
    take: Take = snap


@dataclass(frozen=True)
class PickResult:
    """How a pick ended.

    Attributes:
        grasped: whether it counts as a success.
        load: what the gripper holds, by what was seen of it before the grasp.
    """

    grasped: bool
    load: Load


def pick(view: View, config: PickConfig) -> Skill[PickResult]:
    """Take the object beside which the robot stands and faces; ends in navigation mode."""
    name = view.instruction.object_category.replace("_", " ")
    seen_before = load_seen(view)
    view = yield discrete(DiscreteAction.MANIPULATION_MODE, f"I stand at the {name} and point the arm at it.")
    for prepare in (config.tilt_head, config.step_back, config.look_around, config.reach_out):
        view = yield from prepare(view)
    taken = yield from config.take(view, seen_before.enclosing(load_seen(view)))
    grasped = config.is_grasped(taken.view)
    joints = replace(taken.view.observation.joints, arm=0.0)
    view = yield from move_joints(taken.view, joints, "I retract the arm.")
    outcome = f"The {name} is in the gripper, I believe" if grasped else f"The gripper is empty, so I missed the {name}"
    yield from config.leave(view, f"{outcome}; back to driving.")
    return PickResult(grasped, taken.load)


def trust_the_snap(view: View) -> bool:
    """Take every snap for a success."""
    return True


BASELINE_PICK = PickConfig(do_nothing, do_nothing, do_nothing, trust_the_snap)
"""Snap once, and go on as if it had succeeded."""


def object_points(view: View) -> Points:
    """Return the points (m, base frame) of the object that is nearest to the gripper, the one it would grasp."""
    return view.nearest(ClassRole.OBJECT, gripper_to_base(view.observation.joints)[:3, 3])


def load_seen(view: View) -> Load:
    """Return the room the object will take in the gripper, by its points in view; that of a cup where it is not seen.

    The gripper takes a thing by its top and turns it so that its long side lies along the base.
    """
    points = object_points(view)
    if len(points) == 0:
        return object_of_unknown_size()
    _, sides, _ = cv2.minAreaRect(np.ascontiguousarray(points[:, :2], dtype=np.float32))
    low, high = np.percentile(points[:, 2], (1, 99))
    return Load(max(sides) / 2, min(sides) / 2, float(high - low))


def object_of_unknown_size() -> Load:
    """Return the room that a cup takes, for what was not seen."""
    return Load(along_base=0.06, along_arm=0.06, below=0.12)
