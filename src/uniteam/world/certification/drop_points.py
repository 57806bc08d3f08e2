"""Where on a piece of furniture an object could be put down: points of its support surfaces with room around them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import transform_points
from uniteam.world.assets.model import SupportSurface
from uniteam.world.homes.home import Home, Instance

POINT_SPACING = 0.04
LEAST_MARGIN = 0.03
"""A point keeps at least so far from its surface's edge (m)."""
MOST_MARGIN = 0.25
"""What lies farther inside than this is no better (m)."""

_LOWEST_SURFACE = 0.03


@dataclass(frozen=True)
class DropPoints:
    """Points of one surface.

    Attributes:
        points: (N, 2) m, world.
        margins: (N,) distance to the surface's edge or to the nearest object on it, at most `MOST_MARGIN` (m).
        height: of the surface above the floor (m).
        clearance: free height above it (m).
    """

    points: NDArray[np.float64]
    margins: NDArray[np.float64]
    height: float
    clearance: float


def drop_points(home: Home, receptacle: Instance) -> tuple[DropPoints, ...]:
    """Return the points of every surface of a receptacle at which an object could be put down."""
    surfaces = home.model_of(receptacle).surfaces
    found = (_on_surface(home, receptacle, surface) for surface in surfaces)
    return tuple(points for points in found if len(points.points))


def _on_surface(home: Home, receptacle: Instance, surface: SupportSurface) -> DropPoints:
    outline = np.array(surface.outline)
    grid = np.stack(np.meshgrid(*(_ticks(low, high) for low, high in zip(outline.min(0), outline.max(0), strict=True))))
    points = grid.reshape(2, -1).T
    to_world = receptacle.model_to_world()
    height = receptacle.position[2] + surface.height
    in_world = transform_points(to_world, np.column_stack([points, np.full(len(points), surface.height)]))[:, :2]
    margins = np.minimum(_distance_to_edge(points, outline), _distance_to_objects(home, in_world, height))
    inside = margins >= LEAST_MARGIN
    return DropPoints(in_world[inside], np.minimum(margins[inside], MOST_MARGIN), height, surface.clearance)


def _ticks(low: float, high: float) -> NDArray[np.float64]:
    count = max(1, int((high - low) / POINT_SPACING))
    return low + (np.arange(count) + 0.5) * (high - low) / count


def _distance_to_edge(points: NDArray[np.float64], outline: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return how far (N,) inside a convex counter-clockwise outline (K, 2) points (N, 2) lie; negative outside."""
    along = np.roll(outline, -1, axis=0) - outline
    lengths = np.linalg.norm(along, axis=1)
    along, corners = along[lengths > 0] / lengths[lengths > 0, None], outline[lengths > 0]
    offsets = points[:, None, :] - corners
    return np.asarray((along[:, 0] * offsets[..., 1] - along[:, 1] * offsets[..., 0]).min(axis=1))


def _distance_to_objects(home: Home, points: NDArray[np.float64], height: float) -> NDArray[np.float64]:
    """Return how far (N,) points (N, 2) at a height are from the rims of the things that stand there."""
    distances = np.full(len(points), np.inf)
    for instance in home.instances:
        if instance.position[2] > _LOWEST_SURFACE and -0.1 < instance.position[2] - height < 0.5:
            radius = float(np.hypot(*home.model_of(instance).size[:2])) / 2.0
            distances = np.minimum(distances, np.linalg.norm(points - instance.position[:2], axis=1) - radius)
    return distances
