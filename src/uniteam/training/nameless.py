"""Shapes that are called nothing: things to be found as things, which teach no name."""

import math

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from uniteam.geometry import Point3
from uniteam.world.assets.mesh import Material, Mesh

_RINGS = 12
_SIDES = (3, 4, 5, 6, 8, 16, 16, 16)
"""Of the cross-section; a round one is drawn most often."""


def nameless_mesh(size: Point3, rng: Generator) -> Mesh:
    """Return a closed shape that is about as large as a box, its floor's centre at the origin.

    Args:
        size: of the box (m).
        rng: for its profile, cross-section, twist, lean and colours.
    """
    rings, sides = _RINGS, int(rng.choice(_SIDES))
    level = np.linspace(0.0, 1.0, rings)
    radius = _profile(level, rng)
    angle = np.linspace(0.0, 2.0 * math.pi, sides, endpoint=False) + rng.uniform(0.0, math.pi)
    turned = angle[None, :] + rng.normal(0.0, 0.6) * level[:, None]
    lean = rng.normal(0.0, 0.15, 2)[None, None, :] * level[:, None, None]
    around = np.stack([np.cos(turned), np.sin(turned)], axis=2) * radius[:, None, None] + lean
    around *= np.array(size[:2]) / (2.0 * np.abs(around).max(axis=(0, 1)))
    walls = np.dstack([around, np.broadcast_to(level[:, None] * size[2], (rings, sides))]).reshape(-1, 3)
    middles = np.array([[*around[0].mean(axis=0), 0.0], [*around[-1].mean(axis=0), size[2]]])
    triangles = np.concatenate([_wall(rings, sides), _lids(rings, sides)])
    return _faceted(np.concatenate([walls, middles]), triangles, rng)


def _profile(level: NDArray[np.float64], rng: Generator) -> NDArray[np.float64]:
    """Return the radius at each level (from 0 to 1): smooth, with a few waves, nowhere thin."""
    radius = 1.0 + sum(
        rng.normal(0.0, 0.35) / wave * np.sin(wave * math.pi * level + rng.uniform(0.0, 2.0 * math.pi))
        for wave in (1, 2, 3)
    )
    return np.maximum(radius, 0.25)


def _wall(rings: int, sides: int) -> NDArray[np.int64]:
    """Return the (N, 3) triangles between the rings."""
    ring, side = (a.ravel() for a in np.mgrid[0 : rings - 1, 0:sides])
    after = (side + 1) % sides
    a, b = ring * sides + side, ring * sides + after
    c, d = b + sides, a + sides
    return np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def _lids(rings: int, sides: int) -> NDArray[np.int64]:
    """Return the triangles that close the floor and the top, around the last two vertices."""
    side = np.arange(sides)
    after, top, middle = (side + 1) % sides, (rings - 1) * sides, rings * sides
    floor = np.stack([np.full(sides, middle), after, side], axis=1)
    lid = np.stack([np.full(sides, middle + 1), top + side, top + after], axis=1)
    return np.concatenate([floor, lid])


def _faceted(vertices: NDArray[np.float64], triangles: NDArray[np.int64], rng: Generator) -> Mesh:
    """Return the mesh with a normal a face, in bands of two or three colours."""
    corners = vertices[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    count = len(triangles)
    height = corners[:, :, 2].mean(axis=1) / max(float(vertices[:, 2].max()), 1e-9)
    cuts = np.sort(rng.uniform(0.1, 0.9, int(rng.integers(0, 3))))
    colors = rng.uniform(0.05, 0.95, (len(cuts) + 1, 3))
    return Mesh(
        corners.reshape(-1, 3).astype(np.float32),
        np.repeat(normals, 3, axis=0).astype(np.float32),
        np.zeros((3 * count, 2), np.float32),
        np.arange(3 * count, dtype=np.int32).reshape(-1, 3),
        np.searchsorted(cuts, height).astype(np.int32),
        tuple(Material((float(r), float(g), float(b))) for r, g, b in colors),
    )
