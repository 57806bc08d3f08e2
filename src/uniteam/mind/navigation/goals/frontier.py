"""Frontiers: where the explored floor ends and nothing seen stands in the way."""

import math
from dataclasses import dataclass

import cv2
import numpy as np

from uniteam.geometry import BasePose
from uniteam.grid import Mask, disc, grown_by_rows
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.window import window_around

HOMEROBOT_DILATION = 10
"""Cells by which HomeRobot grows the explored area before it takes its border."""

_HALF_WIDTHS = tuple(math.isqrt(HOMEROBOT_DILATION**2 - row * row) for row in range(HOMEROBOT_DILATION + 1))
"""Of the disc's rows, from its middle one on."""


@dataclass(frozen=True)
class FrontierConfig:
    """What counts as a frontier.

    Attributes:
        closing_cells: gaps in the explored area up to twice as wide count as explored.
        dilation_cells: frontier cells this near to an obstacle are dropped: the unseen insides and backs of walls.
        min_cells: smaller connected groups are dropped.
    """

    closing_cells: int = 5
    dilation_cells: int = 3
    min_cells: int = 6


def find_frontiers(bird_map: BirdsEyeMap, base: BasePose, config: FrontierConfig) -> Mask:
    """Return the (H, W) unexplored cells that border on explored ones, away from obstacles, in groups large enough.

    The method is that of Yamauchi, "A frontier-based approach for autonomous exploration" (1997); closing the explored
    area first, as HomeRobot dilates it, keeps slivers between views from drawing the robot back.
    """
    window = window_around(bird_map, base)
    explored = cv2.morphologyEx(
        window.cut(bird_map.explored).view(np.uint8), cv2.MORPH_CLOSE, disc(config.closing_cells)
    )
    blocked = cv2.dilate(window.cut(bird_map.obstacle).view(np.uint8), disc(config.dilation_cells))
    edge = (cv2.dilate(explored, disc(1)) > explored) & (blocked == 0)
    return window.paste(large_groups(edge, config.min_cells), bird_map.shape)


def border_of_explored(bird_map: BirdsEyeMap, base: BasePose) -> Mask:
    """Return the (H, W) cells half a metre beyond what is explored, whatever stands there: HomeRobot's frontier."""
    window = window_around(bird_map, base)
    explored = grown_by_rows(window.cut(bird_map.explored), _HALF_WIDTHS)
    beyond = (~explored).view(np.uint8)
    return window.paste((cv2.dilate(beyond, disc(1)) > beyond), bird_map.shape)


def large_groups(cells: Mask, min_cells: int) -> Mask:
    """Return the cells whose 8-connected group has at least `min_cells`."""
    _, labels = cv2.connectedComponents(cells.view(np.uint8), connectivity=8)
    where = np.flatnonzero(cells)
    group = labels.reshape(-1)[where]
    large = np.zeros_like(cells)
    large.reshape(-1)[where] = np.bincount(group)[group] >= min_cells
    return large
