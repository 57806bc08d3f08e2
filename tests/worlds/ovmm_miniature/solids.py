"""Collision shapes and surfaces as meshes, for colliders and receptacles."""

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

from uniteam.world.assets.material import Material
from uniteam.world.assets.mesh import Mesh
from uniteam.world.assets.model import CollisionShape, SupportSurface
from uniteam.world.physics.collision_shapes import shape_vertices


def solid(shape: CollisionShape) -> Mesh:
    """Return a shape's surface as a mesh."""
    points = shape_vertices(shape)
    spread = np.ptp(points, axis=0)
    if spread.min() < 1e-6:
        points = np.concatenate([points, points + 1e-4 * (spread < 1e-6)])
    return _mesh(points, ConvexHull(points).simplices)


def flat(surface: SupportSurface) -> Mesh:
    """Return a surface as a mesh, a fan of triangles."""
    points = np.array([(x, y, surface.height) for x, y in surface.outline])
    return _mesh(points, np.array([(0, k, k + 1) for k in range(1, len(points) - 1)]))


def _mesh(points: NDArray[np.float64], triangles: NDArray[np.integer]) -> Mesh:
    normals = np.tile(np.array([0.0, 0.0, 1.0], np.float32), (len(points), 1))
    uvs, kinds = np.zeros((len(points), 2), np.float32), np.zeros(len(triangles), np.int32)
    white = (Material((1.0, 1.0, 1.0)),)
    return Mesh(points.astype(np.float32), normals, uvs, triangles.astype(np.int32), kinds, white)
