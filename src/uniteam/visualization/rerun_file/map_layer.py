"""The agent's map in Rerun: coloured cells on the floor, and what it wants."""

from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.interface import MapLabel, MapOverlay
from uniteam.visualization.colors import GOAL_POINT, MAP_COLORS, PATH
from uniteam.visualization.rerun_file import paths

FLOOR, ABOVE = -0.02, 0.03
"""z (m) of the map, below the points that the camera sees of the floor, and of the plan."""


def _palette() -> NDArray[np.uint8]:
    colors = np.zeros((256, 4), np.uint8)
    for label, color in MAP_COLORS.items():
        colors[label] = (*color, 0 if label is MapLabel.UNKNOWN else 255)
    return colors


_PALETTE = _palette()


class MapLayer:
    """Logs maps, each once: while nothing on it changes, Rerun goes on showing the last."""

    def __init__(self, rerun: ModuleType, stream: Any) -> None:
        """Begin without a map."""
        self._rerun, self._stream = rerun, stream
        self._shown: MapOverlay | None = None

    def log(self, overlay: MapOverlay | None) -> None:
        """Log the map of a step; None keeps the one before."""
        if overlay is None:
            return
        if self._shown is None or not _is_same(overlay, self._shown):
            self._stream.log(paths.MAP, self._grid(overlay))
        self._shown = overlay
        goal, short = overlay.goal, overlay.short_term_goal
        self._log_points(paths.GOAL, goal, 0.04, GOAL_POINT)
        self._log_points(paths.SHORT_TERM_GOAL, np.array([] if short is None else [short]), 0.08, PATH)
        ways = [_raised(overlay.path)] if len(overlay.path) > 1 else []
        self._stream.log(paths.WAY, self._rerun.LineStrips3D(ways, colors=[PATH], radii=[0.02]))

    def _grid(self, overlay: MapOverlay) -> Any:
        rows, columns = overlay.labels.shape
        picture = _PALETTE[overlay.labels[::-1]]  # a picture's first row is its upper one
        shape = self._rerun.components.ImageFormat(
            width=columns, height=rows, color_model="RGBA", channel_datatype="U8"
        )
        return self._rerun.GridMap(
            data=picture.tobytes(), format=shape, cell_size=overlay.cell_size, translation=(*overlay.origin, FLOOR)
        )

    def _log_points(self, path: str, points: NDArray[np.float64], radius: float, color: tuple[int, int, int]) -> None:
        self._stream.log(path, self._rerun.Points3D(_raised(points), colors=[color], radii=[radius]))


def _is_same(one: MapOverlay, other: MapOverlay) -> bool:
    return one.origin == other.origin and np.array_equal(one.labels, other.labels)


def _raised(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return (N, 2) points of the floor as (N, 3), above it."""
    flat = np.asarray(points, np.float64).reshape(-1, 2)
    return np.column_stack([flat, np.full(len(flat), ABOVE)])
