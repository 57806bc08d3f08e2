"""Looking at the start receptacles from several sides."""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.grid import Mask, disc
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.mapping.viewed_sides import side_bit
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.navigation.goals.frontier import large_groups
from uniteam.mind.navigation.window import window_around
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.stretch import BASE_RADIUS


@dataclass(frozen=True)
class SurroundStartReceptacle:
    """Chooses places around the start receptacles from which they were not looked at yet: `surround_start_receptacle`.

    Attributes:
        nearest, farthest: how far from the receptacle the robot stands (m).
        radius: obstacles grow by so much where it stands (m), its own.
        min_cells: smaller groups of places are not worth a drive.
    """

    nearest: float = 0.4
    farthest: float = 0.9
    radius: float = BASE_RADIUS
    min_cells: int = 6

    def __call__(self, bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
        """Return the goal of standing at any such place and facing the receptacle, or None when there is none."""
        receptacle = bird_map.class_cells(ClassRole.START_RECEPTACLE)
        if not receptacle.any():
            return None
        window = window_around(bird_map, base)
        near = window.cut(receptacle)
        away, labels = cv2.distanceTransformWithLabels(
            (~near).view(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_5, labelType=cv2.DIST_LABEL_PIXEL
        )
        away = away * np.float32(bird_map.cell_size)
        own = disc(round(self.radius / bird_map.cell_size))
        blocked = cv2.dilate((window.cut(bird_map.obstacle) | near).view(np.uint8), own)
        stands = (away >= self.nearest) & (away <= self.farthest) & (blocked == 0) & window.cut(bird_map.explored)
        stands &= ~_looked_from_there(near, labels, stands, window.cut(bird_map.looked_from))
        stands = large_groups(stands, self.min_cells)
        if not stands.any():
            return None
        return Goal(GoalKind.START_RECEPTACLE, window.paste(stands, bird_map.shape), distance=0.0, face=receptacle)


def _looked_from_there(receptacle: Mask, labels: np.ndarray, stands: Mask, looked_from: NDArray[np.uint8]) -> Mask:
    """Return the stands whose nearest receptacle cell was looked at from the side on which they lie."""
    cells = np.argwhere(receptacle)
    of_label = np.zeros((int(labels.max()) + 1, 2), dtype=np.int64)
    of_label[labels[receptacle]] = cells
    places = np.argwhere(stands)
    nearest = of_label[labels[stands]]
    from_cell = (places - nearest).astype(np.float64)
    sides = side_bit(np.arctan2(from_cell[:, 0], from_cell[:, 1]))
    looked = np.zeros_like(stands)
    looked[places[:, 0], places[:, 1]] = (looked_from[nearest[:, 0], nearest[:, 1]] & sides) > 0
    return looked
