"""Whether what was let go of went through a receptacle that is solid there."""

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.causes.reading.places import distances_to
from uniteam.geometry import invert_transform, transform_points
from uniteam.world.assets.mesh import load_model_mesh
from uniteam.world.homes.home import Home, Instance

Bounds = tuple[NDArray[np.float64], NDArray[np.float64]]
"""Lowest and highest x, y, z (m)."""


def falls_through(home: Home, goal: Instance, surface: float, boxes: Iterable[Bounds]) -> bool:
    """Return whether an object that hung over a part of a receptacle came to be below a height by no way around it.

    Args:
        home: with its furniture.
        goal: the receptacle.
        surface: height of the receptacle's lowest surface (m).
        boxes: the object's lowest and highest x, y, z (m, world) from when it was let go of, moment by moment.
    """
    for count, (low, high) in enumerate(boxes):
        if not count and (low[2] < surface or not _is_over_a_part(home, goal, (low + high) / 2)):
            return False
        if high[2] < surface:
            return True
        corners = np.array([(x, y) for x in (low[0], high[0]) for y in (low[1], high[1])])
        if distances_to(home, goal, corners).any():
            return False
    return False


def _is_over_a_part(home: Home, instance: Instance, place: NDArray[np.float64]) -> bool:
    """Return whether a part of an instance is below a point (3,) (m, world)."""
    mesh = load_model_mesh(home.model_of(instance))
    point = transform_points(invert_transform(instance.model_to_world()), place[None])[0]
    corners = mesh.vertices.astype(np.float64)[mesh.triangles]
    is_below = corners[:, :, 2].max(axis=1) < point[2]
    return bool((_holds(corners[:, :, :2], point[:2]) & is_below).any())


def _holds(triangles: NDArray[np.float64], point: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return which of (T, 3, 2) triangles hold a point of the plane."""
    edges, to_point = np.roll(triangles, -1, axis=1) - triangles, point - triangles
    sides = edges[..., 0] * to_point[..., 1] - edges[..., 1] * to_point[..., 0]
    return np.asarray((sides > 0).all(axis=1) | (sides < 0).all(axis=1))
