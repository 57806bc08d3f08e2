"""Collision shapes and support surfaces as meshes that the camera can draw."""

import colorsys
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from uniteam.world.assets.mesh import Material, Mesh
from uniteam.world.assets.model import Box, CollisionShape, Model, SupportSurface

_GREEN = (0.10, 0.85, 0.20)
_LIFT = 0.004


def shapes_and_surfaces(model: Model) -> dict[str, Mesh]:
    """Return a mesh for each collision shape, in its own colour, and one for each support surface, in green."""
    shapes = {
        f"shape_{k}": _shape_mesh(s, colorsys.hsv_to_rgb((k * 0.381) % 1.0, 0.35, 0.85))
        for k, s in enumerate(model.shapes)
    }
    return shapes | {f"surface_{k}": _surface_mesh(s) for k, s in enumerate(model.surfaces)}


def _shape_mesh(shape: CollisionShape, color: tuple[float, float, float]) -> Mesh:
    if isinstance(shape, Box):
        signs = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
        points = np.array(shape.center) + signs * np.array(shape.size)
    else:
        points = np.array(shape.vertices)
    return _flat_shaded(points[hull_triangles(points)], color)


def hull_triangles(points: NDArray[np.float64]) -> NDArray[np.int64]:
    """Return the (T, 3) faces, outwards, of the convex hull of a few (N, 3) points, by trying every triple."""
    middle = points.mean(axis=0)
    triples = np.array(
        [(i, j, k) for i in range(len(points)) for j in range(i + 1, len(points)) for k in range(j + 1, len(points))]
    )
    a, b, c = (points[triples[:, n]] for n in range(3))
    normals = np.cross(b - a, c - a)
    proper = np.linalg.norm(normals, axis=1) > 1e-12
    triples, normals, a = triples[proper], normals[proper], a[proper]
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    inward = np.einsum("ij,ij->i", normals, a - middle) < 0
    normals[inward] *= -1
    triples[inward] = triples[inward][:, ::-1]
    distances = points @ normals.T - np.einsum("ij,ij->i", normals, a)
    return np.asarray(triples[(distances < 1e-6 + 1e-4 * np.ptp(points)).all(axis=0)])


def _surface_mesh(surface: SupportSurface) -> Mesh:
    outline = np.column_stack([surface.outline, np.full(len(surface.outline), surface.height + _LIFT)])
    triangles = np.array([[outline[0], p, q] for p, q in pairwise(outline[1:])])
    return _flat_shaded(triangles, _GREEN)


def _flat_shaded(corners: NDArray[np.float64], color: tuple[float, float, float]) -> Mesh:
    """Return (T, 3, 3) corners as a mesh of one colour with a normal a face."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-12)
    count = 3 * len(corners)
    return Mesh(
        np.ascontiguousarray(corners.reshape(-1, 3), np.float32),
        np.repeat(normals, 3, axis=0).astype(np.float32),
        np.zeros((count, 2), np.float32),
        np.arange(count, dtype=np.int32).reshape(-1, 3),
        np.zeros(len(corners), np.int32),
        (Material(color),),
    )
