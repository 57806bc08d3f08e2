"""Ending up before the centre of a receptacle's side."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.grid import Cell, Mask, disc, disc_mask
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal
from uniteam.mind.navigation.goals.receptacle_probability import group_cells
from uniteam.mind.navigation.planning.traversible import connected_to, traversible
from uniteam.mind.navigation.window import Window, window_around
from uniteam.stretch import BASE_RADIUS


class _Side(NamedTuple):
    """Where to stand before a side and what to face there, both (row, column); how many cells its free stretch has."""

    stand: Cell
    face: Cell
    stretch: int


@dataclass(frozen=True)
class CentreApproach:
    """Leads to the middle of the free stretch along a side of a receptacle: UniTeam's `centre_approach`.

    The sides are those of the smallest rectangle around each connected group of the goal's cells. Where no side has a
    free stretch, the goal stays as it is; where one has a much longer stretch than another, the short one is no choice.

    Attributes:
        stand_off: how far from the side the robot's axis stands (m).
        radius: obstacles grow by so much where it stands (m), its own.
        min_stretch: a free stretch must be so long (m).
        play: how far from the middle is near enough (m).
    """

    stand_off: float = 0.45
    radius: float = BASE_RADIUS
    min_stretch: float = 0.2
    play: float = 0.15

    def __call__(self, goal: Goal, bird_map: BirdsEyeMap, base: BasePose) -> Goal:
        """Return the goal of standing before the middle of a side and facing it."""
        window = window_around(bird_map, base)
        cells = window.cut(goal.cells)
        free = self._standing_room(bird_map, window, base)
        stands, faces = np.zeros_like(cells), np.zeros_like(cells)
        for group in group_cells(cells):
            for side in self._middles(group, free, bird_map.cell_size):
                play = round(self.play / bird_map.cell_size)
                stands |= disc_mask(cells.shape, side.stand, play) & free
                faces |= disc_mask(cells.shape, side.face, play)
        if not stands.any():
            return goal
        shape = bird_map.shape
        return Goal(goal.kind, window.paste(stands, shape), distance=0.0, face=window.paste(faces, shape))

    def _standing_room(self, bird_map: BirdsEyeMap, window: Window, base: BasePose) -> Mask:
        """Return the cells where the robot can stand and to which there is a path."""
        robot = window.inside(bird_map.to_cell(base.x, base.y))
        own = disc(round(self.radius / bird_map.cell_size))
        blocked = cv2.dilate(window.cut(bird_map.obstacle).view(np.uint8), own)
        known = connected_to(robot, traversible(bird_map, window, robot, dilation=3))
        return known & (blocked == 0) & window.cut(bird_map.explored)

    def _middles(self, group: Mask, free: Mask, cell_size: float) -> Iterator[_Side]:
        """Yield the sides of a group of cells that have a free stretch, but not the much shorter ones."""
        corners = cv2.boxPoints(cv2.minAreaRect(cv2.findNonZero(group.view(np.uint8))))
        off = self.stand_off / cell_size
        sides = []
        for start, end in zip(corners, np.roll(corners, -1, axis=0), strict=True):
            outward = (start + end) / 2 - corners.mean(axis=0)
            size = float(np.hypot(*outward))
            if size > 0.5:
                shares = np.linspace(0.0, 1.0, round(float(np.hypot(*(end - start)))) + 1)[:, None]
                edge = start + shares * (end - start)
                sides.append(_side(edge, np.rint(edge + outward * (off / size)).astype(np.int32), free))
        longest = max((side.stretch for side in sides), default=0)
        for side in sides:
            if side.stretch * cell_size > self.min_stretch and side.stretch >= longest / 2:
                yield side


def _at(mask: Mask, points: NDArray[np.int32]) -> Mask:
    """Return the mask at (K, 2) cells (x, y); False outside."""
    inside = ((points >= 0) & (points < np.array(mask.shape[::-1]))).all(axis=1)
    clipped = np.clip(points, 0, np.array(mask.shape[::-1]) - 1)
    return inside & mask[clipped[:, 1], clipped[:, 0]]


def _side(edge: NDArray[np.float64], before: NDArray[np.int32], free: Mask) -> _Side:
    """Return a side by the longest free run of the places before its edge; both are (K, 2) cells (x, y).

    A run begins where False turns into True and ends where True turns into False, so beginnings and ends alternate.
    """
    ends = np.flatnonzero(np.diff(np.concatenate([[False], _at(free, before), [False]]).astype(np.int8)))
    if not len(ends):
        return _Side((0, 0), (0, 0), 0)
    lengths = ends[1::2] - ends[::2]
    middle = int(ends[2 * int(np.argmax(lengths))] + (lengths.max() - 1) // 2)
    (x, y), (face_x, face_y) = before[middle], np.rint(edge[middle]).astype(np.int32)
    return _Side((int(y), int(x)), (int(face_y), int(face_x)), int(lengths.max()))
