"""The agent's map as a picture: what is known, where it has been, where it is and where it wants to go."""

from collections.abc import Sequence

import cv2
import numpy as np

from uniteam.geometry import BasePose
from uniteam.interface import MapLabel, MapOverlay
from uniteam.visualization.canvas import Image
from uniteam.visualization.colors import GOAL_POINT, MAP_COLORS, PATH, ROBOT
from uniteam.visualization.map_window import MapWindow

_PALETTE = np.zeros((256, 3), dtype=np.uint8)
for _label, _color in MAP_COLORS.items():
    _PALETTE[_label] = _color


def draw_map(overlay: MapOverlay, base: BasePose, trail: Sequence[BasePose], size: tuple[int, int]) -> Image:
    """Return the explored part of a map, x to the right and y up, as a (height, width, 3) RGB picture.

    Args:
        overlay: the map behind a decision.
        base: where the robot is (start frame).
        trail: where it has been.
        size: width and height (px).
    """
    view = MapWindow(overlay, base, size)
    picture = view.background(_PALETTE[overlay.labels], MAP_COLORS[MapLabel.UNKNOWN])
    view.polyline(picture, np.array([(pose.x, pose.y) for pose in trail]), ROBOT, 1)
    view.polyline(picture, overlay.path, PATH, 2)
    for x, y in overlay.goal:
        cv2.circle(picture, view.pixel(x, y), 2, GOAL_POINT, cv2.FILLED, cv2.LINE_AA)
    if overlay.short_term_goal is not None:
        cv2.circle(picture, view.pixel(*overlay.short_term_goal), 5, PATH, 2, cv2.LINE_AA)
    view.robot(picture, base, ROBOT)
    return picture
