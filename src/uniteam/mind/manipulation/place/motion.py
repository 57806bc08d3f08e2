"""How the base moves when something is placed: in whole steps as HomeRobot's, or exactly (`exact_motion`)."""

import math
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import transform_points
from uniteam.interface import ACTION_LIMITS, DiscreteAction
from uniteam.mind.manipulation.arm_reach import HANGING_WRIST, ArmReach
from uniteam.mind.manipulation.place.placing_points import PlacingPoints
from uniteam.mind.skills.skill import LONGEST_DRIVE, SMALLEST_DRIVE, SMALLEST_TURN, Move, Skill, discrete, drive, turn
from uniteam.mind.skills.view import View

Point = NDArray[np.floating]
"""(3,) m."""


class Motion(Protocol):
    """How the base gets to a placing point."""

    def go_to(self, view: View, point: Point) -> Skill[View]:
        """Turn to a point of the base frame and drive to it at once, as near as the arm needs."""

    def point_after(self, first: View, point: Point, now: View, reach: ArmReach) -> Point:
        """Return where a point of the first view's base frame is taken to be in the base frame now."""

    def next_move(self, point: Point, enough: float, step: float) -> Move | None:
        """Return the next move towards a point of the base frame; None where the robot is there.

        Args:
            point: where to get near to.
            enough: how near is near enough (m).
            step: how far to drive at most (m).
        """

    def in_line(self, chosen: PlacingPoints, reach: ArmReach) -> PlacingPoints:
        """Return the points onto which the base can turn the arm's line."""

    def line_up(self, angle: float) -> float | None:
        """Return the turn (rad) that the base makes for one of `angle`; None where it makes none that does."""


@dataclass(frozen=True)
class WholeSteps:
    """HomeRobot's: turns of 30 degrees and drives of 0.25 m, as many as there are whole ones; the rest is not made up.

    Where the robot has got to is not looked at either: the arm extends by the distance as it was first seen.

    Attributes:
        standoff: distance of the camera from the placing point at which to stop (m).
        wrist: distance that the arm bridges before it extends (m).
        off_line: a point may lie so far (rad) beside the arm's line, where any lies so near.
        widest: the largest turn (rad) to bring the arm's line over a point.
    """

    standoff: float = 0.385
    wrist: float = 0.235
    off_line: float = math.radians(6.0)
    widest: float = math.radians(60.0)

    def go_to(self, view: View, point: Point) -> Skill[View]:
        """Make the whole turns and steps that the first look asks for."""
        ahead, left = _from_camera(view, point)
        bearing = math.atan2(left, ahead)
        side = DiscreteAction.TURN_LEFT if bearing > 0 else DiscreteAction.TURN_RIGHT
        steps = max(0.0, ahead - self.standoff) // ACTION_LIMITS.forward_step
        for _ in range(int(abs(bearing) // ACTION_LIMITS.turn_step)):
            view = yield discrete(side, "I turn to the placing point by 30 degrees.")
        for _ in range(int(steps)):
            view = yield discrete(DiscreteAction.MOVE_FORWARD, "I drive a step to the placing point.")
        return view

    def point_after(self, first: View, point: Point, now: View, reach: ArmReach) -> Point:
        """Return the point as far along the arm as it was ahead at first."""
        near = ArmReach.of_wrist(HANGING_WRIST).near
        distance = max(0.0, _from_camera(first, point)[0] - self.wrist) + near
        return np.array([reach.side, -distance, point[2]])

    def next_move(self, point: Point, enough: float, step: float) -> Move | None:
        """Return a turn of 30 degrees where that comes nearer to facing the point, else a step forward."""
        bearing = math.atan2(point[1], point[0])
        if abs(bearing) > ACTION_LIMITS.turn_step / 2:
            side = DiscreteAction.TURN_LEFT if bearing > 0 else DiscreteAction.TURN_RIGHT
            return discrete(side, "I turn to the placing point by 30 degrees.")
        if math.hypot(point[0], point[1]) > enough:
            return discrete(DiscreteAction.MOVE_FORWARD, "I drive a step closer to the placing point.")
        return None

    def in_line(self, chosen: PlacingPoints, reach: ArmReach) -> PlacingPoints:
        """Return the points near the lines to which whole turns lead; all where there is none."""
        angles = np.array([reach.turn_to(float(x), float(y)) for x, y, _ in chosen.points])
        near = np.abs(angles - _whole_turns(angles)) <= self.off_line
        return PlacingPoints(chosen.points[near], chosen.worth[near]) if near.any() else chosen

    def line_up(self, angle: float) -> float | None:
        """Return the whole turns that come nearest to `angle`; None where they are too wide."""
        made = float(_whole_turns(np.array(angle)))
        return None if abs(made) > self.widest + 1e-6 else made


@dataclass(frozen=True)
class ExactMotion:
    """Turns and drives by what is asked for, and knows where the robot has got to: `exact_motion`.

    Attributes:
        standoff: distance of the base from the placing point at which the arm extends (m).
        roughly: a smaller bearing (rad) need not be turned to before a drive.
        widest: the largest turn (rad) to bring the arm's line over a point.
    """

    standoff: float = 0.55
    roughly: float = math.radians(10.0)
    widest: float = math.radians(60.0)

    def go_to(self, view: View, point: Point) -> Skill[View]:
        """Turn to the point and drive the distance in one go."""
        bearing = math.atan2(point[1], point[0])
        if abs(bearing) >= SMALLEST_TURN:
            view = yield turn(bearing, "I turn to the placing point.")
        distance = min(math.hypot(point[0], point[1]) - self.standoff, LONGEST_DRIVE)
        if distance >= SMALLEST_DRIVE:
            view = yield drive(distance, f"I drive the {distance:.2f} m to the placing point in one go.")
        return view

    def point_after(self, first: View, point: Point, now: View, reach: ArmReach) -> Point:
        """Return where the point is by the robot's localisation."""
        in_start = transform_points(first.observation.base_to_start.matrix(), point)
        return transform_points(now.observation.base_to_start.inverse().matrix(), in_start)

    def next_move(self, point: Point, enough: float, step: float) -> Move | None:
        """Return the turn to the point, or the drive by what is missing."""
        bearing, distance = math.atan2(point[1], point[0]), math.hypot(point[0], point[1])
        if abs(bearing) >= max(self.roughly, SMALLEST_TURN):
            return turn(bearing, "I turn to the placing point.")
        missing = distance - enough
        length = min(max(missing, SMALLEST_DRIVE), step)
        reason = f"The placing point is {distance:.2f} m away, I close in by {length:.2f} m."
        return drive(length, reason) if missing > 0.0 else None

    def in_line(self, chosen: PlacingPoints, reach: ArmReach) -> PlacingPoints:
        """Return all points: the base can turn to any."""
        return chosen

    def line_up(self, angle: float) -> float | None:
        """Return the turn itself; None where it is too wide."""
        return None if abs(angle) > self.widest else angle


def _from_camera(view: View, point: Point) -> tuple[float, float]:
    """Return how far (m) a point of the base frame is ahead and to the left of the camera, which looks ahead."""
    camera_in_start = view.observation.camera_to_start[:3, 3]
    camera = transform_points(view.observation.base_to_start.inverse().matrix(), camera_in_start)
    return float(point[0] - camera[0]), float(point[1] - camera[1])


def _whole_turns(angles: NDArray[np.floating]) -> NDArray[np.floating]:
    return np.rint(angles / ACTION_LIMITS.turn_step) * ACTION_LIMITS.turn_step
