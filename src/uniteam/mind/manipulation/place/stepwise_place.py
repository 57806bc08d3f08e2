"""Closing in step by step: look, come a little closer, look again; then line the arm up (`stepwise_place`).

The robot keeps what it saw on the way in (`LocalCloud`): close to a receptacle, the camera looks over its near edge.
"""

import math
from dataclasses import dataclass, field

import numpy as np

from uniteam.mind.manipulation.place.local_cloud import LocalCloud
from uniteam.mind.manipulation.place.place import PlaceContext, Stand, enter_manipulation_mode
from uniteam.mind.skills.skill import SMALLEST_DRIVE, SMALLEST_TURN, Skill, drive, turn
from uniteam.mind.skills.view import Points, View

GOOD_SHARE = 0.7
"""Of the best worth: among points so good the nearest is headed for, since one much farther would cost more steps and
views than the rest of the worth is."""


@dataclass(frozen=True)
class TurnToLine:
    """Turns the base so that the arm's line meets a point.

    Attributes:
        widest: the largest turn that is made (rad).
    """

    widest: float = math.radians(60.0)

    def __call__(self, angle: float) -> float | None:
        """Return the turn that the base can make and that is nearest to `angle` (rad); None where it is too wide."""
        turn_made = _possible_turn(angle)
        return None if abs(turn_made) > self.widest else turn_made


@dataclass(frozen=True)
class CloseInStepwise:
    """Comes closer in small steps and measures again after each.

    Attributes:
        step: of the drive (m).
        most_steps: how many turns and drives to make before the arm must do.
        comfort: distance (m) from the base to a placing point, as a share of the arm's reach, that is near enough.
        line_up: how the base turns in the end to bring the arm's line over a point.
    """

    step: float = 0.25
    most_steps: int = 12
    comfort: float = 0.92
    line_up: TurnToLine = field(default_factory=TurnToLine)

    def __call__(self, view: View, context: PlaceContext) -> Skill[Stand | None]:
        """Answer with the stand near enough to a placing point; None where no receptacle is seen."""
        nearby = LocalCloud()
        nearby.add(view)
        if len(nearby.goal_points(view.observation.base_to_start)) == 0:
            return None
        view = yield from self._come_closer(view, context, nearby)
        view = yield from enter_manipulation_mode(view, "I am near enough and point the arm at the receptacle.")
        nearby.add(view)
        pose = view.observation.base_to_start
        points = nearby.goal_points(pose)
        if len(points) == 0:
            return None
        chosen = context.choose_points(points, context.load, context.generator)
        return Stand(view, chosen, nearby.surroundings(pose), self.line_up)

    def _come_closer(self, view: View, context: PlaceContext, nearby: LocalCloud) -> Skill[View]:
        reach = context.release.reach
        for _ in range(self.most_steps):
            target = self._nearest_good_point(nearby.goal_points(view.observation.base_to_start), context)
            if target is None:
                break
            bearing, distance = math.atan2(target[1], target[0]), math.hypot(target[0], target[1])
            missing = distance - self.comfort * reach.far
            if abs(bearing) >= math.radians(10.0) and abs(bearing) >= SMALLEST_TURN:
                view = yield turn(bearing, "I turn to the placing point.")
            elif missing > 0.0:
                before = view.observation.base_to_start
                length = min(max(missing, SMALLEST_DRIVE), self.step)
                view = yield drive(length, f"The placing point is {distance:.2f} m away, I close in by {length:.2f} m.")
                if before.distance_to(view.observation.base_to_start.x, view.observation.base_to_start.y) < 0.02:
                    break
            else:
                break
            nearby.add(view)
        return view

    def _nearest_good_point(self, points: Points, context: PlaceContext) -> np.ndarray | None:
        if len(points) == 0:
            return None
        chosen = context.choose_points(points, context.load, context.generator)
        if len(chosen.points) == 0:
            return None
        distance = np.hypot(chosen.points[:, 0], chosen.points[:, 1])
        good = chosen.worth >= GOOD_SHARE * chosen.worth.max()
        return chosen.points[int(np.argmin(np.where(good, distance, np.inf)))]


def _possible_turn(angle: float) -> float:
    """Return the turn that the base can make and that is nearest to `angle` (rad)."""
    if abs(angle) >= SMALLEST_TURN:
        return angle
    return 0.0 if abs(angle) < SMALLEST_TURN / 2 else math.copysign(SMALLEST_TURN, angle)
