"""Placing as HomeRobot's heuristic baseline does (arXiv 2306.11565): choose a point once, go there, put down.

Turn to the point, drive the distance in one go, point the arm at it, raise the lift, extend, let go. What stands in the
way of the base or the arm is not considered, nor is the receptacle looked at again.
"""

import math
from dataclasses import dataclass, replace

import numpy as np

from uniteam.geometry import transform_points
from uniteam.mind.manipulation.arm_path import ArmPath
from uniteam.mind.manipulation.place.drop_height import reach_of
from uniteam.mind.manipulation.place.place import Aim, PlaceTask, enter_manipulation_mode
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.mind.skills.skill import LONGEST_DRIVE, SMALLEST_DRIVE, SMALLEST_TURN, Skill, drive, turn
from uniteam.mind.skills.view import View
from uniteam.stretch import JOINT_LIMITS


@dataclass(frozen=True)
class DriveInOneGo:
    """Drives the whole distance to a placing point at once.

    Attributes:
        standoff: distance of the base from the placing point at which the arm extends (m).
    """

    standoff: float = 0.55

    def __call__(self, view: View, task: PlaceTask) -> Skill[Aim | None]:
        """Answer with the aim at the best point seen at first; None where no receptacle is seen."""
        points = view.points(ClassRole.GOAL_RECEPTACLE)
        if len(points) == 0:
            return None
        chosen = task.choose_points(points, task.load, task.generator)
        if len(chosen.points) == 0:
            return None
        target = chosen.points[chosen.best_first()[0]]
        in_start = transform_points(view.observation.base_to_start.matrix(), target)
        bearing = math.atan2(target[1], target[0])
        if abs(bearing) >= SMALLEST_TURN:
            view = yield turn(bearing, "I turn to the placing point.")
        distance = min(math.hypot(target[0], target[1]) - self.standoff, LONGEST_DRIVE)
        if distance >= SMALLEST_DRIVE:
            view = yield drive(distance, f"I drive the {distance:.2f} m to the placing point in one go.")
        view = yield from enter_manipulation_mode(view, "I point the arm at the placing point.")
        return Aim(view, _straight_path(view, in_start, task))


def _straight_path(view: View, target: np.ndarray, task: PlaceTask) -> ArmPath:
    """Raise the retracted arm over the height of a point of the start frame (m), then extend it."""
    x, y, z = transform_points(view.observation.base_to_start.inverse().matrix(), target)
    reach, joints = reach_of(task.release), view.observation.joints
    height = float(z) + task.release.height_above_surface(task.load)
    end = reach.over(joints, reach.distance_to(float(x), float(y)), height)
    raised = replace(joints, lift=end.lift)
    return ArmPath((raised, replace(raised, wrist_pitch=end.wrist_pitch), end))


def extend_blindly(view: View, task: PlaceTask) -> Skill[Aim]:
    """Raise the lift to the top and extend the whole arm, whatever is there: HomeRobot's fallback."""
    view = yield from enter_manipulation_mode(view, "I see no receptacle, so I extend the arm blindly.")
    return Aim(view, blind_path(view))


def blind_path(view: View) -> ArmPath:
    """Return the path that raises the lift to the top and extends the whole arm."""
    raised = replace(view.observation.joints, lift=JOINT_LIMITS[1].lift, arm=0.0)
    return ArmPath((raised, replace(raised, arm=JOINT_LIMITS[1].arm)))
