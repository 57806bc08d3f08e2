"""What is free on the surfaces of one piece of furniture."""

import math

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import Point2, Point3
from uniteam.world.assets.model import Model, SupportSurface

Footprint = NDArray[np.float64]
"""(4, 2) corners of the turned rectangle that a model covers, about its origin (m)."""

_STEP = 0.04
"""Between places that are tried (m)."""
_GAP = 0.01
"""Between things (m)."""


def footprint(model: Model, yaw: float) -> Footprint:
    """Return what a model covers that is turned by `yaw` (rad)."""
    w, d = model.size[0] / 2.0, model.size[1] / 2.0
    c, s = math.cos(yaw), math.sin(yaw)
    return np.array([(-w, -d), (w, -d), (w, d), (-w, d)]) @ np.array([[c, s], [-s, c]])


class Tops:
    """The surfaces of a piece of furniture, and what lies on them already."""

    def __init__(self, model: Model) -> None:
        """Begin with all of them free."""
        self._surfaces = model.surfaces
        self._taken: list[list[tuple[Point2, Point2]]] = [[] for _ in model.surfaces]

    def take(self, wanted: Point2, bottom: float, covered: Footprint, height: float) -> Point3 | None:
        """Return the nearest free place, which is then taken, or None where nothing is free.

        Args:
            wanted: (x, y) where it should be (m, frame of the furniture's model).
            bottom: how high its underside should be (m).
            covered: what it covers, in the same frame.
            height: its own (m).
        """
        order = sorted(range(len(self._surfaces)), key=lambda i: abs(self._surfaces[i].height - bottom))
        for index in order:
            surface = self._surfaces[index]
            spot = _nearest(surface, wanted, covered, self._taken[index]) if height < surface.clearance else None
            if spot is not None:
                low, high = covered.min(axis=0) + spot - _GAP, covered.max(axis=0) + spot + _GAP
                self._taken[index].append(((low[0], low[1]), (high[0], high[1])))
                return float(spot[0]), float(spot[1]), surface.height
        return None


def _nearest(
    surface: SupportSurface, wanted: Point2, covered: Footprint, taken: list[tuple[Point2, Point2]]
) -> NDArray[np.float64] | None:
    """Return the nearest (2,) point at which the whole footprint lies on a surface and on nothing else."""
    outline = np.array(surface.outline)
    xs, ys = (np.arange(outline[:, i].min(), outline[:, i].max() + _STEP, _STEP) for i in (0, 1))
    points = np.vstack([[wanted], np.stack(np.meshgrid(xs, ys), axis=-1).reshape(-1, 2)])
    points = points[np.argsort(np.linalg.norm(points - wanted, axis=1), kind="stable")]
    fits = _lies_within(points[:, None] + covered, outline).all(axis=1)
    low, high = points + covered.min(axis=0), points + covered.max(axis=0)
    for other_low, other_high in taken:
        fits &= ~((low < other_high) & (high > other_low)).all(axis=1)
    return points[fits][0] if fits.any() else None


def _lies_within(points: NDArray[np.float64], outline: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Say of points (..., 2) whether they lie in a convex outline whose corners go around either way."""
    edges = np.roll(outline, -1, axis=0) - outline
    offsets = points[..., None, :] - outline
    sides = edges[:, 0] * offsets[..., 1] - edges[:, 1] * offsets[..., 0]
    return np.asarray((sides >= -1e-9).all(axis=-1) | (sides <= 1e-9).all(axis=-1))
