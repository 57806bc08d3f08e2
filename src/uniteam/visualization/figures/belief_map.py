"""The agent's map in the figures' colours: receptacles by whether they were looked at, and where the robot may go."""

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import Point2
from uniteam.grid import Mask
from uniteam.interface import MapLabel, MapOverlay
from uniteam.mind.agents.map_overlay import draw_overlay
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.window import Window, window_around
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.visualization.canvas import Image
from uniteam.visualization.colors import Color
from uniteam.visualization.figures import colors
from uniteam.visualization.figures.moment import Moment
from uniteam.visualization.map_window import MapWindow

_LABELS: dict[MapLabel, Color] = {
    MapLabel.UNKNOWN: colors.UNKNOWN,
    MapLabel.FREE: colors.FREE,
    MapLabel.VISITED: colors.FREE,
    MapLabel.OBSTACLE: colors.OBSTACLE,
    MapLabel.COLLISION: colors.COLLISION,
    MapLabel.FRONTIER: colors.FREE,
    MapLabel.START_RECEPTACLE: colors.UNEXPLORED_START,
    MapLabel.GOAL_RECEPTACLE: colors.GOAL_RECEPTACLE,
    MapLabel.OBJECT: colors.OBJECT,
}
_PALETTE = np.array([_LABELS[label] for label in MapLabel], dtype=np.uint8)
CHOSEN_RADIUS = 8
"""Of the disc at the chosen point (px)."""


@dataclass(frozen=True)
class Layer:
    """Cells of the map in one colour, over what is there: (H, W) bool of the map's shape."""

    cells: Mask
    color: Color


def start_cells(bird_map: BirdsEyeMap) -> tuple[Mask, Mask]:
    """Return the cells of start receptacles that have not been looked at from any side, and those that have."""
    start, looked_at = bird_map.class_cells(ClassRole.START_RECEPTACLE), bird_map.looked_from > 0
    return start & ~looked_at, start & looked_at


def draw_belief(moment: Moment, layers: Sequence[Layer], size: tuple[int, int]) -> Image:
    """Return the known part of the map as a (height, width, 3) RGB picture, x to the right and y up.

    Args:
        moment: whose map it is, and where it is on its way.
        layers: what is drawn over the map, the foremost last.
        size: width and height (px).
    """
    board, base = moment.agent.board, moment.observation.base_to_start
    overlay = draw_overlay(board.bird_map, base, plan=board.plan)
    window = MapWindow(overlay, base, size)
    cells = _colors(overlay, board.bird_map, window_around(board.bird_map, base), layers)
    picture = window.background(cells, colors.UNKNOWN)
    window.polyline(picture, np.array([(pose.x, pose.y) for pose in moment.trail]), colors.FAINT_INK, 2)
    window.polyline(picture, overlay.path, colors.PATH, 3)
    if len(overlay.goal):
        at = window.pixel(*chosen_point(overlay.goal, overlay.path))
        cv2.circle(picture, at, CHOSEN_RADIUS + 2, colors.PAPER, cv2.FILLED, cv2.LINE_AA)
        cv2.circle(picture, at, CHOSEN_RADIUS, colors.CHOSEN_POINT, cv2.FILLED, cv2.LINE_AA)
    window.robot(picture, base, colors.ROBOT)
    return picture


def chosen_point(goal: NDArray[np.float64], path: NDArray[np.float64]) -> Point2:
    """Return of (K, 2) goal points the one at which a (P, 2) path ends, or the nearest to that."""
    x, y = goal[np.argmin(np.hypot(*(goal - path[-1]).T))]
    return float(x), float(y)


def _colors(overlay: MapOverlay, bird_map: BirdsEyeMap, known: Window, layers: Sequence[Layer]) -> Image:
    """Return the (H, W, 3) colours of the overlay's cells."""
    painted = _PALETTE[overlay.labels]
    is_start = overlay.labels == MapLabel.START_RECEPTACLE
    painted[is_start & known.cut(start_cells(bird_map)[1])] = colors.EXPLORED_START
    for layer in layers:
        painted[known.cut(layer.cells)] = layer.color
    return painted
