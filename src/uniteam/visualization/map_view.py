"""The agent's map as a picture: what is known, where it has been, where it is and where it wants to go."""

from collections.abc import Sequence

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.interface import MapLabel, MapOverlay
from uniteam.stretch import BASE_RADIUS
from uniteam.visualization.canvas import Image
from uniteam.visualization.colors import GOAL_POINT, MAP_COLORS, PATH, ROBOT

MARGIN = 1.0
SMALLEST_VIEW = 6.0

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
    view = _View(overlay, base, size)
    picture = view.background()
    view.polyline(picture, np.array([(pose.x, pose.y) for pose in trail]), ROBOT, 1)
    view.polyline(picture, overlay.path, PATH, 2)
    for x, y in overlay.goal:
        cv2.circle(picture, view.pixel(x, y), 2, GOAL_POINT, cv2.FILLED, cv2.LINE_AA)
    if overlay.short_term_goal is not None:
        cv2.circle(picture, view.pixel(*overlay.short_term_goal), 5, PATH, 2, cv2.LINE_AA)
    _draw_robot(picture, view, base)
    return picture


class _View:
    """The window on the map that shows everything known, in the proportions of the picture."""

    def __init__(self, overlay: MapOverlay, base: BasePose, size: tuple[int, int]) -> None:
        known = np.argwhere(overlay.labels != MapLabel.UNKNOWN)
        corners = np.vstack([known.min(0), known.max(0) + 1]) if len(known) else np.zeros((2, 2))
        points = corners[:, ::-1] * overlay.cell_size + overlay.origin
        points = np.vstack([points, (base.x, base.y)]) if len(known) else np.array([(base.x, base.y)] * 2)
        low, high = points.min(0) - MARGIN, points.max(0) + MARGIN
        self._overlay = overlay
        self._size = size
        self._center = (low + high) / 2.0
        extent = np.maximum(high - low, SMALLEST_VIEW)
        self.scale = float(min(size[0] / extent[0], size[1] / extent[1]))

    def pixel(self, x: float, y: float) -> tuple[int, int]:
        """Return the pixel (u, v) of a point (m, start frame)."""
        u = (x - self._center[0]) * self.scale + self._size[0] / 2.0
        v = self._size[1] / 2.0 - (y - self._center[1]) * self.scale
        return round(u), round(v)

    def background(self) -> Image:
        """Return the labels' colours, resampled to the picture."""
        width, height = self._size
        scale, overlay = self.scale * self._overlay.cell_size, self._overlay
        x0, y0 = overlay.origin
        u0 = (x0 - self._center[0]) * self.scale + width / 2.0 + scale / 2.0 - 0.5
        v0 = height / 2.0 - (y0 - self._center[1]) * self.scale - scale / 2.0 - 0.5
        cells_to_picture = np.array([[scale, 0.0, u0], [0.0, -scale, v0]])
        unknown = MAP_COLORS[MapLabel.UNKNOWN]
        colors = _PALETTE[overlay.labels]
        return np.asarray(
            cv2.warpAffine(colors, cells_to_picture, self._size, flags=cv2.INTER_NEAREST, borderValue=unknown)
        ).astype(np.uint8, copy=False)

    def polyline(self, picture: Image, points: NDArray[np.floating], color: tuple[int, int, int], width: int) -> None:
        """Draw a line through (N, 2) points (m, start frame)."""
        pixels = np.array([self.pixel(x, y) for x, y in points], dtype=np.int32)
        if len(pixels) > 1:
            cv2.polylines(picture, [pixels], False, color, width, cv2.LINE_AA)


def _draw_robot(picture: Image, view: _View, base: BasePose) -> None:
    """Draw the base as a disc with a nose that shows its heading."""
    nose = base.compose(BasePose(2.0 * BASE_RADIUS, 0.0, 0.0))
    radius = max(round(BASE_RADIUS * view.scale), 4)
    cv2.circle(picture, view.pixel(base.x, base.y), radius, ROBOT, cv2.FILLED, cv2.LINE_AA)
    cv2.circle(picture, view.pixel(base.x, base.y), radius, (255, 255, 255), 1, cv2.LINE_AA)
    cv2.line(picture, view.pixel(base.x, base.y), view.pixel(nose.x, nose.y), (255, 255, 255), 3, cv2.LINE_AA)
    cv2.line(picture, view.pixel(base.x, base.y), view.pixel(nose.x, nose.y), ROBOT, 1, cv2.LINE_AA)
