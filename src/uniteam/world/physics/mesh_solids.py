"""A mesh as convex solids: each triangle with a little depth behind it, so that walls of any form can be met."""

import numpy as np
from numpy.typing import NDArray

from uniteam.world.assets.mesh import Mesh

DEPTH = 0.02
"""How far a solid reaches behind its triangle (m)."""
FLOOR_LEVEL = 0.01
"""Triangles that lie lower are the floor, which every home has (m)."""

_THINNEST = 1e-3


def mesh_solids(mesh: Mesh) -> NDArray[np.float64]:
    """Return (N, 6, 3) corners (m) of a prism for each triangle: its corners, and the same behind it.

    Triangles of the floor, and slivers under a millimetre wide, have none.
    """
    corners = mesh.vertices[mesh.triangles].astype(np.float64)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    solid = (corners[..., 2].max(axis=1) > FLOOR_LEVEL) & (lengths > _THINNEST * longest)
    outwards = np.einsum("ij,ij->i", normals, mesh.normals[mesh.triangles].sum(axis=1)) >= 0.0
    behind = np.where(outwards, -DEPTH, DEPTH)[:, None] * normals / np.maximum(lengths, 1e-12)[:, None]
    return np.concatenate([corners, corners + behind[:, None]], axis=1)[solid]
