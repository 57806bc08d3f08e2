"""Closing in step by step: look, come a little closer, look again; then aim at what the arm reaches without touching.

The robot keeps what it saw on the way in (`Nearby`): close to a receptacle, the camera looks over its near edge.
"""

import math
from dataclasses import dataclass, field

import numpy as np

from uniteam.mind.manipulation.arm_clearance import SweepConfig
from uniteam.mind.manipulation.arm_path import ArmPath, is_path_free, path_to
from uniteam.mind.manipulation.place.drop_height import reach_of
from uniteam.mind.manipulation.place.local_cloud import Nearby
from uniteam.mind.manipulation.place.place import Aim, PlaceTask, enter_manipulation_mode
from uniteam.mind.manipulation.place.placing_points import PlacingPoints
from uniteam.mind.skills.skill import SMALLEST_DRIVE, SMALLEST_TURN, Skill, drive, turn
from uniteam.mind.skills.view import Points, View

TIGHTEST_GAP = 0.02
"""m; between a surface and the lowest part of what is held over it."""
HEIGHT_PRICE = 0.1
"""What a metre of fall costs in worth, which is in metres from the edge."""
ELBOW_ROOM = 0.4
"""m beyond the arm's reach; what is farther is out of its way."""


@dataclass(frozen=True)
class CloseInStepwise:
    """Comes closer in small steps and measures again after each.

    Attributes:
        step: of the drive (m).
        most_steps: how many turns and drives to make before the arm must do.
        comfort: distance (m) from the base to a placing point, as a share of the arm's reach, that is near enough.
        widest_turn: how far (rad) the base turns to bring the arm's line over a point.
        extra_heights: how much higher than the release asks for the arm may go over what stands in its way (m).
        sweep: the room the arm takes.
    """

    step: float = 0.25
    most_steps: int = 12
    comfort: float = 0.92
    widest_turn: float = math.radians(60.0)
    extra_heights: tuple[float, ...] = (0.0, 0.1, 0.2, 0.3, 0.4, 0.5)
    sweep: SweepConfig = field(default_factory=SweepConfig)

    def __call__(self, view: View, task: PlaceTask) -> Skill[Aim | None]:
        """Answer with an aim that touches nothing seen; None where there is none."""
        nearby = Nearby()
        nearby.add(view)
        if len(nearby.goal_points(view.observation.base_to_start)) == 0:
            return None
        view = yield from self._come_closer(view, task, nearby)
        view = yield from enter_manipulation_mode(view, "I am near enough and point the arm at the receptacle.")
        nearby.add(view)
        pose = view.observation.base_to_start
        return (yield from self.aim(view, nearby.goal_points(pose), nearby.surroundings(pose), task))

    def _come_closer(self, view: View, task: PlaceTask, nearby: Nearby) -> Skill[View]:
        reach = reach_of(task.release)
        for _ in range(self.most_steps):
            target = self._nearest_good_point(nearby.goal_points(view.observation.base_to_start), task)
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

    def _nearest_good_point(self, points: Points, task: PlaceTask) -> np.ndarray | None:
        if len(points) == 0:
            return None
        chosen = task.choose_points(points, task.load, task.generator)
        if len(chosen.points) == 0:
            return None
        distance = np.hypot(chosen.points[:, 0], chosen.points[:, 1])
        good = chosen.worth >= 0.7 * chosen.worth.max()
        return chosen.points[int(np.argmin(np.where(good, distance, np.inf)))]

    def aim(self, view: View, points: Points, surroundings: Points, task: PlaceTask) -> Skill[Aim | None]:
        """Turn so that the arm's line meets the best of the points that it reaches freely, and answer with the aim."""
        if len(points) == 0:
            return None
        chosen = task.choose_points(points, task.load, task.generator)
        found = self._first_free(view, chosen, surroundings, task)
        if found is None:
            return None
        angle, path = found
        if angle != 0.0:
            view = yield turn(angle, "I turn so that the arm's line meets the placing point.")
        return Aim(view, path)

    def _first_free(
        self, view: View, chosen: PlacingPoints, surroundings: Points, task: PlaceTask
    ) -> tuple[float, ArmPath] | None:
        """Return the turn and the path to the best point and height that the arm reaches freely."""
        reach, now = reach_of(task.release), view.observation.joints
        near = surroundings[np.hypot(surroundings[:, 0], surroundings[:, 1]) < reach.far + ELBOW_ROOM]
        worth = chosen.worth[:, None] - HEIGHT_PRICE * np.array(self.extra_heights)
        for flat in np.argsort(-worth, axis=None, kind="stable"):
            index, extra = divmod(int(flat), len(self.extra_heights))
            x, y, z = (float(value) for value in chosen.points[index])
            distance, angle = reach.distance_to(x, y), _possible_turn(reach.turn_to(x, y))
            lowest = z + task.load.below + TIGHTEST_GAP
            height = z + task.release.height_above_surface(task.load) + self.extra_heights[extra]
            in_reach = reach.near <= distance <= reach.far and lowest <= reach.high
            if not in_reach or abs(angle) > self.widest_turn:
                continue
            path = path_to(now, reach.over(now, distance, min(height, reach.high)))
            if is_path_free(path, _turned(near, angle), task.load, self.sweep):
                return angle, path
        return None


def _possible_turn(angle: float) -> float:
    """Return the turn that the base can make and that is nearest to `angle` (rad)."""
    if abs(angle) >= SMALLEST_TURN:
        return angle
    return 0.0 if abs(angle) < SMALLEST_TURN / 2 else math.copysign(SMALLEST_TURN, angle)


def _turned(points: Points, angle: float) -> Points:
    """Return the points in the frame of the base after it has turned by `angle` (rad)."""
    c, s = math.cos(angle), math.sin(angle)
    x, y, z = points.T
    return np.stack([c * x + s * y, -s * x + c * y, z], axis=-1)
