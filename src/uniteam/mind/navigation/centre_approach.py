"""Ending up before the centre of a receptacle's side."""

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap, Mask, disc, disc_mask
from uniteam.mind.navigation.distance_field import distance_field
from uniteam.mind.navigation.exploration import ChooseGoal
from uniteam.mind.navigation.goal import Goal
from uniteam.mind.navigation.traversible import traversible
from uniteam.mind.navigation.window import Window, window_around


@dataclass(frozen=True)
class CentreApproach:
    """Leads to the middle of the free stretch along a side of what another choice chose: UniTeam's `centre_approach`.

    The sides are those of the smallest rectangle around each connected group of the goal's cells. Where no side has a
    free stretch, the other choice's goal stands.

    Attributes:
        choose: the other choice.
        stand_off: how far from the side the robot's axis stands (m).
        robot_cells: obstacles grow by so many cells where it stands, its own radius.
        min_stretch: a free stretch must be so long (m).
        play: how far from the middle is near enough (m).
        min_cells: smaller groups are passed over.
    """

    choose: ChooseGoal
    stand_off: float = 0.45
    robot_cells: int = 6
    min_stretch: float = 0.2
    play: float = 0.15
    min_cells: int = 8

    def __call__(self, bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
        """Return the goal of standing before the middle of a side and facing it."""
        goal = self.choose(bird_map, base)
        if goal is None:
            return None
        window = window_around(bird_map, base, goal.cells)
        cells = window.cut(goal.cells)
        free = self._standing_room(bird_map, window, base)
        stands, faces = np.zeros_like(cells), np.zeros_like(cells)
        for group in _groups(cells, self.min_cells):
            for stand, face in self._middles(group, free, bird_map.cell_size):
                play = round(self.play / bird_map.cell_size)
                stands |= disc_mask(cells.shape, stand, play) & free
                faces |= disc_mask(cells.shape, face, play)
        if not stands.any():
            return goal
        shape = bird_map.shape
        return Goal(goal.kind, window.paste(stands, shape), distance=0.0, face=window.paste(faces, shape))

    def _standing_room(self, bird_map: BirdsEyeMap, window: Window, base: BasePose) -> Mask:
        """Return the cells where the robot can stand and to which there is a path."""
        robot = window.inside(bird_map.to_cell(base.x, base.y))
        here = np.zeros((window.high[0] - window.low[0], window.high[1] - window.low[1]), dtype=np.bool_)
        here[robot] = True
        field = distance_field(traversible(bird_map, window, robot, dilation=3), here, bird_map.cell_size)
        blocked = cv2.dilate(window.cut(bird_map.obstacle).view(np.uint8), disc(self.robot_cells))
        return np.isfinite(field) & (blocked == 0) & window.cut(bird_map.explored)

    def _middles(
        self, group: NDArray[np.int32], free: Mask, cell_size: float
    ) -> Iterator[tuple[tuple[int, int], tuple[int, int]]]:
        """Yield (where to stand, what to face), both (row, column), for each side of a (K, 2) group of (x, y) cells."""
        corners = cv2.boxPoints(cv2.minAreaRect(group))
        centre = corners.mean(axis=0)
        off = self.stand_off / cell_size
        for start, end in zip(corners, np.roll(corners, -1, axis=0), strict=True):
            length = float(np.hypot(*(end - start)))
            outward = (start + end) / 2 - centre
            size = float(np.hypot(*outward))
            if length < 1.0 or size < 1e-6:
                continue
            edge = start + np.linspace(0.0, 1.0, round(length) + 1)[:, None] * (end - start)
            before = np.rint(edge + outward * (off / size)).astype(np.int32)
            middle = _middle_of_longest_run(_at(free, before), round(self.min_stretch / cell_size))
            if middle is not None:
                (x, y), (face_x, face_y) = before[middle], np.rint(edge[middle]).astype(np.int32)
                yield (int(y), int(x)), (int(face_y), int(face_x))


def _groups(cells: Mask, min_cells: int) -> Iterator[NDArray[np.int32]]:
    """Yield the (K, 2) (x, y) cells of each connected group that is large enough."""
    count, labels = cv2.connectedComponents(cells.view(np.uint8), connectivity=8)
    for index in range(1, count):
        group = np.argwhere(labels == index)[:, ::-1]
        if len(group) >= min_cells:
            yield np.ascontiguousarray(group, dtype=np.int32)


def _at(mask: Mask, points: NDArray[np.int32]) -> Mask:
    """Return the mask at (K, 2) cells (x, y); False outside."""
    inside = ((points >= 0) & (points < np.array(mask.shape[::-1]))).all(axis=1)
    clipped = np.clip(points, 0, np.array(mask.shape[::-1]) - 1)
    return inside & mask[clipped[:, 1], clipped[:, 0]]


def _middle_of_longest_run(flags: Mask, least: int) -> int | None:
    """Return the index in the middle of the longest run of True that is longer than `least`, or None."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(np.int8)))
    starts, ends = edges[::2], edges[1::2]
    if not len(starts) or (ends - starts).max() <= least:
        return None
    longest = int(np.argmax(ends - starts))
    return int((starts[longest] + ends[longest] - 1) // 2)
