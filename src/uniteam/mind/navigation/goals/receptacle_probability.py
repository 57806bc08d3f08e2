"""Receptacles on the map: the connected groups of a class's cells, what they are worth, and which can be reached."""

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np

from uniteam.geometry import BasePose
from uniteam.grid import Mask, disc
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.navigation.planning.distance_field import distance_field
from uniteam.mind.navigation.planning.traversible import traversible
from uniteam.mind.navigation.window import Window, window_around
from uniteam.mind.perception.vocabulary import ClassRole

_DILATION = 3
_GAP = 2
_MOST = 12


@dataclass(frozen=True)
class Receptacle:
    """A connected group of a class's cells.

    Attributes:
        cells: (H, W) bool.
        probability: that it is of the class: the upper quartile of its cells' running probabilities.
        distance: the path's length (m) to the nearest free cell from which it is in reach; inf where there is none.
    """

    cells: Mask
    probability: float
    distance: float


@dataclass(frozen=True)
class MostProbableReceptacle:
    """Chooses the goal receptacle with the highest probability that can be reached: UniTeam's `receptacle_probability`.

    Attributes:
        alike: probabilities this near to the highest count as equal; among equals the nearest is chosen.
        reach: how far from a free cell a receptacle may lie to be within reach (m).
    """

    alike: float = 0.1
    reach: float = 0.75

    def __call__(self, bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
        """Return the goal of standing before the receptacle that was chosen, or None when none is known."""
        receptacles = tuple(find_receptacles(bird_map, base, ClassRole.GOAL_RECEPTACLE, self.reach))
        if not receptacles:
            return None
        within_reach = [r for r in receptacles if np.isfinite(r.distance)] or receptacles
        best = max(r.probability for r in within_reach)
        chosen = min((r for r in within_reach if r.probability >= best - self.alike), key=lambda r: r.distance)
        return Goal(GoalKind.GOAL_RECEPTACLE, chosen.cells, face=chosen.cells)


def find_receptacles(bird_map: BirdsEyeMap, base: BasePose, role: ClassRole, reach: float) -> Iterator[Receptacle]:
    """Yield the largest receptacles of a class.

    Args:
        bird_map: the map.
        base: the robot (start frame).
        role: the class.
        reach: how far from a free cell a receptacle may lie to be within reach (m).
    """
    cells = bird_map.class_cells(role)
    window = window_around(bird_map, base)
    probability = window.cut(bird_map.class_probability(role))
    to_robot = _reachable_distance(bird_map, window, base)
    for group in group_cells(window.cut(cells)):
        distance = _distance_around(to_robot, group, round(reach / bird_map.cell_size))
        quartile = float(np.quantile(probability[group], 0.75))
        yield Receptacle(window.paste(group, bird_map.shape), quartile, distance)


def group_cells(cells: Mask) -> Iterator[Mask]:
    """Yield the groups of an (H, W) mask that lie together, at most a dozen, the largest first.

    Cells two apart still lie together: from afar a receptacle is seen in specks.
    """
    near = cv2.dilate(cells.view(np.uint8), disc(_GAP))
    count, labels = cv2.connectedComponents(near, connectivity=8)
    sizes = np.bincount(labels[cells], minlength=count)
    for index in np.argsort(-sizes, kind="stable")[:_MOST]:
        if sizes[index] > 0:
            yield (labels == index) & cells


def _reachable_distance(bird_map: BirdsEyeMap, window: Window, base: BasePose) -> np.ndarray:
    robot = window.inside(bird_map.to_cell(base.x, base.y))
    here = np.zeros((window.high[0] - window.low[0], window.high[1] - window.low[1]), dtype=np.bool_)
    here[robot] = True
    return distance_field(traversible(bird_map, window, robot, _DILATION), here, bird_map.cell_size)


def _distance_around(distance: np.ndarray, group: Mask, reach: int) -> float:
    """Return the least distance among the cells within `reach` cells of a group."""
    x, y, width, height = cv2.boundingRect(group.view(np.uint8))
    box = slice(max(0, y - reach), y + height + reach), slice(max(0, x - reach), x + width + reach)
    away = cv2.distanceTransform((~group[box]).view(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_5)
    return float(np.min(distance[box], where=away <= reach, initial=np.inf))
