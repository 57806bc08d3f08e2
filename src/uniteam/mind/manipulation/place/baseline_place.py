"""Placing as HomeRobot's heuristic baseline does (arXiv 2306.11565): choose a point once, go there, put down.

Turn to the point, drive the distance in one go, point the arm at it, raise the lift, extend, let go. What stands in the
way of the base or the arm is not considered, nor is the receptacle looked at again.
"""

import math
from dataclasses import dataclass, replace

from uniteam.geometry import transform_points
from uniteam.mind.manipulation.arm_path import ArmPath
from uniteam.mind.manipulation.place.place import Aim, PlaceContext, Stand, enter_manipulation_mode
from uniteam.mind.manipulation.place.placing_points import PlacingPoints
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

    def __call__(self, view: View, context: PlaceContext) -> Skill[Stand | None]:
        """Answer with the stand before the best point seen at first; None where no receptacle is seen."""
        points = view.points(ClassRole.GOAL_RECEPTACLE)
        if len(points) == 0:
            return None
        chosen = context.choose_points(points, context.load, context.generator)
        if len(chosen.points) == 0:
            return None
        best = chosen.best_first()[:1]
        target = chosen.points[best[0]]
        in_start = transform_points(view.observation.base_to_start.matrix(), target)
        bearing = math.atan2(target[1], target[0])
        if abs(bearing) >= SMALLEST_TURN:
            view = yield turn(bearing, "I turn to the placing point.")
        distance = min(math.hypot(target[0], target[1]) - self.standoff, LONGEST_DRIVE)
        if distance >= SMALLEST_DRIVE:
            view = yield drive(distance, f"I drive the {distance:.2f} m to the placing point in one go.")
        view = yield from enter_manipulation_mode(view, "I point the arm at the placing point.")
        in_base = transform_points(view.observation.base_to_start.inverse().matrix(), in_start)
        return Stand(view, PlacingPoints(in_base[None], chosen.worth[best]), view.surroundings(), stay_in_line)


def stay_in_line(angle: float) -> float:
    """Take the arm's line for what it should be, and do not turn the base."""
    return 0.0


def straight_path(stand: Stand, context: PlaceContext) -> Aim | None:
    """Raise the retracted arm over the height of the best point in reach, then extend it, whatever is in between.

    Where no point is in reach, the arm goes as far towards the best as it can; None where the base cannot turn to any.
    """
    reach, joints = context.release.reach, stand.view.observation.joints
    points = [tuple(float(value) for value in stand.candidates.points[i]) for i in stand.candidates.best_first()]
    for x, y, z in sorted(points, key=lambda point: not reach.reaches(*point[:2])):
        angle = stand.line_up(reach.turn_to(x, y))
        if angle is not None:
            height = z + context.release.height_above_surface(context.load)
            end = reach.over(joints, reach.distance_to(x, y), height)
            raised = replace(joints, lift=end.lift)
            return Aim(stand.view, angle, ArmPath((raised, replace(raised, wrist_pitch=end.wrist_pitch), end)))
    return None


def extend_blindly(view: View, context: PlaceContext) -> Skill[Aim]:
    """Raise the lift to the top and extend the whole arm, whatever is there: HomeRobot's fallback."""
    view = yield from enter_manipulation_mode(view, "I see no receptacle, so I extend the arm blindly.")
    return blind_aim(view)


def blind_aim(view: View) -> Aim:
    """Return the aim that raises the lift to the top and extends the whole arm."""
    raised = replace(view.observation.joints, lift=JOINT_LIMITS[1].lift, arm=0.0)
    return Aim(view, 0.0, ArmPath((raised, replace(raised, arm=JOINT_LIMITS[1].arm))))
