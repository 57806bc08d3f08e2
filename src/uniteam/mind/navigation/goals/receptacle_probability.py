"""Receptacles on the map: the connected groups of a class's cells, what they are worth, and which can be reached."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from uniteam.geometry import BasePose
from uniteam.grid import Cell, Mask, disc
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.navigation.planning.distance_field import alike, nearest_target
from uniteam.mind.navigation.planning.traversible import connected_to, traversible
from uniteam.mind.navigation.window import Window, window_around
from uniteam.mind.perception.vocabulary import ClassRole

_DILATION = 3
_GAP = 2
_MOST = 12


@dataclass(frozen=True)
class Receptacle:
    """A connected group of a class's cells; grids are the window's.

    Attributes:
        cells: (H, W) bool.
        probability: that it is of the class: the upper quartile of its cells' running probabilities.
        stands: (H, W) bool, the free cells to which there is a path and from which it is in reach; there may be none.
    """

    cells: Mask
    probability: float
    stands: Mask


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
        window = window_around(bird_map, base)
        robot = window.inside(bird_map.to_cell(base.x, base.y))
        free = traversible(bird_map, window, robot, _DILATION)
        receptacles = tuple(find_receptacles(bird_map, window, connected_to(robot, free), self.reach))
        if not receptacles:
            return None
        within_reach = [r for r in receptacles if r.stands.any()] or receptacles
        best = max(r.probability for r in within_reach)
        chosen = _nearest([r for r in within_reach if r.probability >= best - self.alike], free, robot)
        cells = window.paste(chosen.cells, bird_map.shape)
        return Goal(GoalKind.GOAL_RECEPTACLE, cells, face=cells)


def find_receptacles(bird_map: BirdsEyeMap, window: Window, known: Mask, reach: float) -> Iterator[Receptacle]:
    """Yield the largest goal receptacles.

    Args:
        bird_map: the map.
        window: the part of it that is worth searching.
        known: (H, W) bool, the window's free cells to which there is a path.
        reach: how far from a free cell a receptacle may lie to be within reach (m).
    """
    probability = window.cut(bird_map.class_probability(ClassRole.GOAL_RECEPTACLE))
    for group in group_cells(window.cut(bird_map.class_cells(ClassRole.GOAL_RECEPTACLE))):
        stands = known & _around(group, round(reach / bird_map.cell_size))
        yield Receptacle(group, float(np.quantile(probability[group], 0.75)), stands)


def _nearest(receptacles: Sequence[Receptacle], free: Mask, robot: Cell) -> Receptacle:
    """Return the receptacle of which the way to a stand is shortest, the first one of equals or where there is no way.

    Those at the same cost as the first stand that the search comes to have that cost on its map.
    """
    stands = np.logical_or.reduce([receptacle.stands for receptacle in receptacles])
    if len(receptacles) == 1 or not stands.any():
        return receptacles[0]
    found = nearest_target(free, alike(free), robot, stands)
    is_nearest = found.costs == found.costs[found.target]
    return next(receptacle for receptacle in receptacles if (receptacle.stands & is_nearest).any())


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


def _around(group: Mask, reach: int) -> Mask:
    """Return the cells within `reach` cells of a group."""
    x, y, width, height = cv2.boundingRect(group.view(np.uint8))
    box = slice(max(0, y - reach), y + height + reach), slice(max(0, x - reach), x + width + reach)
    around = np.zeros_like(group)
    around[box] = cv2.distanceTransform((~group[box]).view(np.uint8), cv2.DIST_L2, cv2.DIST_MASK_5) <= reach
    return around
