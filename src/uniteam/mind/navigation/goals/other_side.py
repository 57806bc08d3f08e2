"""The places from which a thing is seen from another side than it was."""

import math
from dataclasses import dataclass

import cv2
import numpy as np

from uniteam.geometry import BasePose, Point2
from uniteam.grid import Mask, disc
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.navigation.planning.distance_field import distance_field
from uniteam.mind.navigation.window import Window, window_around
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.stretch import BASE_RADIUS


@dataclass(frozen=True)
class OtherSide:
    """Chooses a stand before a thing that lies well to the side of where the robot stood before it.

    Attributes:
        kind: of the thing, as a goal.
        role: of its cells on the map.
        target: (x, y) of it (m, start frame).
        seen_from: (x, y) where the robot stood (m, start frame).
        nearest, farthest: how far from the target the robot stands (m).
        aside: how far around the target, at least, it goes (rad).
        longest: a longer way (m) is not worth it.
    """

    kind: GoalKind
    role: ClassRole
    target: Point2
    seen_from: Point2
    nearest: float = 0.6
    farthest: float = 1.6
    aside: float = math.radians(50.0)
    longest: float = 4.0

    def __call__(self, bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
        """Return the goal of standing there and facing the thing, or None where there is no such place near by."""
        window = window_around(bird_map, base)
        own = disc(round(BASE_RADIUS / bird_map.cell_size))
        blocked = cv2.dilate(window.cut(bird_map.obstacle).view(np.uint8), own).view(np.bool_)
        free = ~blocked & window.cut(bird_map.explored)
        stands = free & self._lies_aside(bird_map, window)
        robot = np.zeros_like(free)
        robot[window.inside(bird_map.to_cell(base.x, base.y))] = True
        stands &= distance_field(free, robot, bird_map.cell_size) <= self.longest
        if not stands.any():
            return None
        return Goal(self.kind, window.paste(stands, bird_map.shape), distance=0.0, face=self._face(bird_map))

    def _lies_aside(self, bird_map: BirdsEyeMap, window: Window) -> Mask:
        """Return the window's cells at the right distance from the target, and far enough around it."""
        rows, columns = window.high[0] - window.low[0], window.high[1] - window.low[1]
        x0, y0 = bird_map.to_point(*window.low)
        x = x0 + bird_map.cell_size * np.arange(columns)[None, :] - self.target[0]
        y = y0 + bird_map.cell_size * np.arange(rows)[:, None] - self.target[1]
        before = math.atan2(self.seen_from[1] - self.target[1], self.seen_from[0] - self.target[0])
        around = np.abs((np.arctan2(y, x) - before + math.pi) % (2.0 * math.pi) - math.pi)
        away = np.hypot(x, y)
        return np.asarray((away >= self.nearest) & (away <= self.farthest) & (around >= self.aside))

    def _face(self, bird_map: BirdsEyeMap) -> Mask:
        """Return the cells of the thing that are nearest to the target, or the target itself."""
        row, column = bird_map.to_cell(*self.target)
        around = np.zeros(bird_map.shape, dtype=np.uint8)
        cv2.circle(around, (column, row), round(self.nearest / bird_map.cell_size), color=1, thickness=-1)
        seen = bird_map.class_cells(self.role) & around.view(np.bool_)
        if not seen.any():
            seen[row, column] = True
        return seen
