"""Cutting large triangles into smaller ones: light is computed at corners only, and changes within metres."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.world.assets.mesh import Mesh

MOST_TRIANGLES = 400_000
"""A mesh that has so many is not cut further."""


@dataclass(frozen=True)
class _Edges:
    """The sides of a mesh's triangles.

    Attributes:
        ends: (E, 2) vertices of each side, once however many triangles share it.
        of_triangle: (T, 3) its sides, the k-th from corner k to the next.
    """

    ends: NDArray[np.int64]
    of_triangle: NDArray[np.int64]


def refined(mesh: Mesh, longest: float) -> Mesh:
    """Return the mesh with every side at most `longest` (m), as far as `MOST_TRIANGLES` allows.

    A side is halved by its length alone, so that the triangles on both its sides agree and no gap opens.
    """
    while len(mesh.triangles) < MOST_TRIANGLES:
        edges = _edges(mesh.triangles.astype(np.int64))
        lengths = np.linalg.norm(mesh.vertices[edges.ends[:, 0]] - mesh.vertices[edges.ends[:, 1]], axis=1)
        if not (lengths > longest).any():
            break
        mesh = _halved(mesh, edges, lengths > longest)
    return mesh


def _edges(triangles: NDArray[np.int64]) -> _Edges:
    sides = np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1).reshape(-1, 2)
    ends, of_side = np.unique(np.sort(sides, axis=1), axis=0, return_inverse=True)
    return _Edges(ends, of_side.reshape(-1, 3))


def _halved(mesh: Mesh, edges: _Edges, is_long: NDArray[np.bool_]) -> Mesh:
    """Return the mesh with a vertex in the middle of each long side."""
    a, b = edges.ends[is_long].T
    middle = np.full(len(is_long), -1, np.int64)
    middle[is_long] = len(mesh.vertices) + np.arange(len(a))
    normals = mesh.normals[a] + mesh.normals[b]
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), np.float32(1e-6))
    triangles, owners = _split(mesh.triangles.astype(np.int64), middle[edges.of_triangle])
    half = np.float32(0.5)
    return Mesh(
        np.concatenate([mesh.vertices, half * (mesh.vertices[a] + mesh.vertices[b])]),
        np.concatenate([mesh.normals, normals]),
        np.concatenate([mesh.uvs, half * (mesh.uvs[a] + mesh.uvs[b])]),
        triangles.astype(np.int32),
        mesh.triangle_materials[owners],
        mesh.materials,
    )


def _split(triangles: NDArray[np.int64], middles: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return triangles cut at the middles (T, 3) of sides, -1 for a whole side, and which triangle each is part of."""
    cut, owners = [], []
    for count in range(4):
        chosen = np.flatnonzero((middles >= 0).sum(axis=1) == count)
        corners, inner = _turned(triangles[chosen], middles[chosen], count)
        (a, b, c), (ab, bc, ca) = corners.T, inner.T
        parts = {
            0: [(a, b, c)],
            1: [(a, ab, c), (ab, b, c)],
            2: [(ab, b, bc), (a, ab, bc), (a, bc, c)],
            3: [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)],
        }[count]
        cut += [np.stack(part, axis=1) for part in parts]
        owners += [chosen] * len(parts)
    return np.concatenate(cut), np.concatenate(owners)


def _turned(
    corners: NDArray[np.int64], middles: NDArray[np.int64], count: int
) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return triangles turned so that the sides to be cut come first."""
    first = np.zeros(len(corners), np.int64)
    if count == 1:
        first = (middles >= 0).argmax(axis=1)
    elif count == 2:
        first = ((middles < 0).argmax(axis=1) + 1) % 3
    order = (first[:, None] + np.arange(3)) % 3
    return np.take_along_axis(corners, order, axis=1), np.take_along_axis(middles, order, axis=1)
