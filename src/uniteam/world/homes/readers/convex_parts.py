"""A mesh as convex hulls of few corners: one for each connected part, as colliders are made of.

A hull's corners are the outermost points of its part in some thirty directions, which keeps a box and a convex part of
at most 32 corners as they are and shrinks a round one by a little.
"""

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import Point3
from uniteam.world.assets.mesh import Mesh
from uniteam.world.assets.model import Box, CollisionShape, Hull

MOST_CORNERS = 32
MOST_PARTS = 200
"""Of a mesh; where there are more, the smallest are left out."""
WELD = 1e-4
"""Points nearer than this are one (m)."""

_THIN, _THICKNESS = 1e-3, 2e-3
_FEWEST_FACES = 4
"""Of a solid."""


def convex_parts(pieces: Iterable[Mesh]) -> tuple[CollisionShape, ...]:
    """Return a hull for each connected part of some meshes, the largest first; parts of two meshes are two."""
    parts = [part for piece in pieces for part in _parts(piece)]
    parts.sort(key=lambda part: -float(np.ptp(part, axis=0).max()))
    return tuple(hull for part in parts[:MOST_PARTS] if (hull := convex_hull(part)) is not None)


def convex_hull(points: NDArray[np.floating]) -> Hull | None:
    """Return the hull of (N, 3) points, a flat one with a little thickness; None for what is no more than a line."""
    points = np.unique(np.asarray(points, dtype=np.float64).round(6), axis=0)
    centred = points - points.mean(axis=0)
    axes = np.linalg.svd(centred.T @ centred)[0]
    extents = np.ptp(centred @ axes, axis=0)
    if extents[1] < _THIN:
        return None
    if extents[2] < _THIN:
        flat = _outermost(points, MOST_CORNERS // 2)
        return Hull(_as_points(np.concatenate([flat, flat - _THICKNESS * axes[:, 2]])))
    return Hull(_as_points(_outermost(points, MOST_CORNERS)))


def bounding_box(mesh: Mesh) -> Box:
    """Return the axis-aligned box around a mesh."""
    low, high = mesh.vertices.min(axis=0).astype(np.float64), mesh.vertices.max(axis=0).astype(np.float64)
    (center,) = _as_points(((low + high) / 2)[None])
    (size,) = _as_points((high - low)[None])
    return Box(center, size)


def _parts(mesh: Mesh) -> list[NDArray[np.float64]]:
    """Return the points of each connected part: by shared corners, or by their places where faces share none."""
    points, triangles = mesh.vertices.astype(np.float64), mesh.triangles.astype(np.int64)
    labels = _labels(len(points), triangles)
    if (np.unique(labels[triangles[:, 0]], return_counts=True)[1] < _FEWEST_FACES).any():
        points, triangles = _welded(points, triangles)
        labels = _labels(len(points), triangles)
    return [points[labels == label] for label in np.unique(labels[triangles])]


def _welded(points: NDArray[np.float64], triangles: NDArray[np.int64]) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Return the distinct points, and the triangles between them."""
    cells = np.round(points / WELD).astype(np.int64)
    _, first, index = np.unique(cells, axis=0, return_index=True, return_inverse=True)
    return points[first], index.reshape(-1)[triangles]


def _labels(count: int, triangles: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return the least point of the connected part of each point."""
    labels = np.arange(count)
    while True:
        before = labels.copy()
        np.minimum.at(labels, triangles.reshape(-1), labels[triangles].min(axis=1).repeat(3))
        labels = labels[labels]
        if (labels == before).all():
            return labels


def _outermost(points: NDArray[np.floating], count: int) -> NDArray[np.float64]:
    """Return at most so many points, those that lie farthest in as many directions; all where there are no more."""
    if len(points) <= count:
        return np.asarray(points, dtype=np.float64)
    return np.asarray(points[np.unique((points @ _directions(count).T).argmax(axis=0))])


def _directions(count: int) -> NDArray[np.float64]:
    """Return (count, 3) directions: the corners of a cube, its faces' centres, and a spiral over the sphere."""
    signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=np.float64)
    faces = np.concatenate([np.eye(3), -np.eye(3)])
    k = np.arange(max(count - 14, 0))
    z = 1.0 - (2 * k + 1) / max(len(k), 1)
    turn = k * np.pi * (3.0 - np.sqrt(5.0))
    spiral = np.stack([np.sqrt(1.0 - z**2) * np.cos(turn), np.sqrt(1.0 - z**2) * np.sin(turn), z], axis=1)
    return np.concatenate([signs, faces, spiral])[:count]


def _as_points(points: NDArray[np.float64]) -> tuple[Point3, ...]:
    return tuple((float(x), float(y), float(z)) for x, y, z in points)
