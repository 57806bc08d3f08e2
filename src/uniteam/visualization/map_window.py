"""The window on a map that shows everything known of it, in the proportions of a picture."""

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose
from uniteam.interface import MapLabel, MapOverlay
from uniteam.stretch import BASE_RADIUS
from uniteam.visualization.canvas import Image
from uniteam.visualization.colors import Color

MARGIN = 1.0
SMALLEST_VIEW = 6.0

_RIM: Color = (255, 255, 255)


class MapWindow:
    """Where the points and the cells of a map lie in a picture, x to the right and y up."""

    def __init__(self, overlay: MapOverlay, base: BasePose, size: tuple[int, int]) -> None:
        """Take the map, where the robot is (start frame), and width and height of the picture (px)."""
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

    def background(self, colors: Image, unknown: Color) -> Image:
        """Return the (H, W, 3) colours of the map's cells, resampled to the picture; `unknown` is around them."""
        width, height = self._size
        scale, overlay = self.scale * self._overlay.cell_size, self._overlay
        x0, y0 = overlay.origin
        u0 = (x0 - self._center[0]) * self.scale + width / 2.0 + scale / 2.0 - 0.5
        v0 = height / 2.0 - (y0 - self._center[1]) * self.scale - scale / 2.0 - 0.5
        cells_to_picture = np.array([[scale, 0.0, u0], [0.0, -scale, v0]])
        return np.asarray(
            cv2.warpAffine(colors, cells_to_picture, self._size, flags=cv2.INTER_NEAREST, borderValue=unknown)
        ).astype(np.uint8, copy=False)

    def polyline(self, picture: Image, points: NDArray[np.floating], color: tuple[int, int, int], width: int) -> None:
        """Draw a line through (N, 2) points (m, start frame)."""
        pixels = np.array([self.pixel(x, y) for x, y in points], dtype=np.int32)
        if len(pixels) > 1:
            cv2.polylines(picture, [pixels], False, color, width, cv2.LINE_AA)

    def robot(self, picture: Image, base: BasePose, color: Color) -> None:
        """Draw the base (start frame) as a disc with a nose that shows its heading."""
        here, nose = self.pixel(base.x, base.y), base.compose(BasePose(2.0 * BASE_RADIUS, 0.0, 0.0))
        radius = max(round(BASE_RADIUS * self.scale), 4)
        cv2.circle(picture, here, radius, color, cv2.FILLED, cv2.LINE_AA)
        cv2.circle(picture, here, radius, _RIM, 1, cv2.LINE_AA)
        cv2.line(picture, here, self.pixel(nose.x, nose.y), _RIM, 3, cv2.LINE_AA)
        cv2.line(picture, here, self.pixel(nose.x, nose.y), color, 1, cv2.LINE_AA)
