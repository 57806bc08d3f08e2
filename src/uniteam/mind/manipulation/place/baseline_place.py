"""Placing as HomeRobot's heuristic baseline does (arXiv 2306.11565): choose a point once, go there, put down.

Turn to the point, drive the distance in one go, point the arm at it, raise the lift, extend, let go, lift, retract.
What stands in the way of the base or the arm is not considered, nor is the receptacle looked at again.
"""

from dataclasses import dataclass, replace

from uniteam.mind.manipulation.arm_path import ArmPath
from uniteam.mind.manipulation.place.place import Aim, PlaceContext, Stand, enter_manipulation_mode
from uniteam.mind.manipulation.place.placing_points import PlacingPoints
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.mind.skills.skill import Skill
from uniteam.mind.skills.view import View
from uniteam.stretch import JOINT_LIMITS

BLIND_LIFT = 0.8
"""m; that of the challenge's action `EXTEND_ARM`, which HomeRobot places with where it sees nothing."""


@dataclass(frozen=True)
class DriveInOneGo:
    """Drives the whole distance to a placing point at once."""

    def __call__(self, view: View, context: PlaceContext) -> Skill[Stand | None]:
        """Answer with the stand before the best point seen at first; None where no receptacle is seen."""
        points = context.receptacle(view)
        if len(points) == 0:
            return None
        others = view.surroundings_but(ClassRole.GOAL_RECEPTACLE)
        chosen = context.choose_points(points, others, context.load, context.generator)
        if len(chosen.points) == 0:
            return None
        best = chosen.best_first()[:1]
        first, target = view, chosen.points[best[0]]
        view = yield from context.motion.go_to(view, target)
        view = yield from enter_manipulation_mode(view, "I point the arm at the placing point.")
        point = context.motion.point_after(first, target, view, context.release.reach)
        return Stand(view, PlacingPoints(point[None], chosen.worth[best]), view.surroundings(), stay_in_line)


def stay_in_line(angle: float) -> float:
    """Take the arm's line for what it should be, and do not turn the base."""
    return 0.0


def straight_path(stand: Stand, context: PlaceContext) -> Aim | None:
    """Raise the retracted arm to the top, then bring it over the best point in reach, whatever is in between.

    Where no point is in reach, the arm goes as far towards the best as it can; None where the base cannot turn to any.
    """
    reach, joints = context.release.reach, stand.view.observation.joints
    points = [tuple(float(value) for value in stand.candidates.points[i]) for i in stand.candidates.best_first()]
    for x, y, z in sorted(points, key=lambda point: not reach.reaches(*point[:2])):
        angle = stand.line_up(reach.turn_to(x, y))
        if angle is not None:
            height = z + context.release.height_above_surface(context.load)
            raised = replace(joints, lift=JOINT_LIMITS[1].lift, arm=0.0)
            end = reach.over(joints, reach.distance_to(x, y), height)
            return Aim(stand.view, angle, ArmPath((raised, replace(raised, wrist_pitch=end.wrist_pitch), end)))
    return None


def extend_blindly(view: View, stand: Stand | None, context: PlaceContext) -> Skill[Aim]:
    """Extend the whole arm at a fixed height, whatever is there: HomeRobot's fallback."""
    view = yield from enter_manipulation_mode(view, "I see no receptacle, so I extend the arm blindly.")
    raised = replace(view.observation.joints, lift=JOINT_LIMITS[1].lift, arm=0.0)
    return Aim(view, 0.0, ArmPath((raised, replace(raised, lift=BLIND_LIFT, arm=JOINT_LIMITS[1].arm))))
