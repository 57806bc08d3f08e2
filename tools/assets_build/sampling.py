"""Points on a mesh's surface, from which collision shapes and support surfaces are found."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from assets_build.geometry import face_normals


@dataclass(frozen=True)
class SurfaceSamples:
    """(N, 3) points and unit normals, and (N,) the area (m2) each stands for."""

    points: NDArray[np.float64]
    normals: NDArray[np.float64]
    areas: NDArray[np.float64]


def sample_surface(corners: NDArray[np.floating], spacing: float) -> SurfaceSamples:
    """Return points on triangles (T, 3, 3), one for each `spacing`**2 of area and at least one a triangle.

    Within a triangle they follow the R2 low-discrepancy sequence, folded from the unit square.
    """
    corners = np.asarray(corners, dtype=np.float64)
    normals, areas = face_normals(corners)
    counts = np.maximum(1, np.round(areas / spacing**2)).astype(int)
    owner = np.repeat(np.arange(len(corners)), counts)
    order = np.arange(len(owner)) - np.repeat(np.cumsum(counts) - counts, counts)
    u, v = (0.5 + order * 0.7548776662466927) % 1.0, (0.5 + order * 0.5698402909980532) % 1.0
    folded = u + v > 1.0
    u, v = np.where(folded, 1.0 - u, u), np.where(folded, 1.0 - v, v)
    triangles = corners[owner]
    points = triangles[:, 0] * (1 - u - v)[:, None] + triangles[:, 1] * u[:, None] + triangles[:, 2] * v[:, None]
    return SurfaceSamples(points, normals[owner], areas[owner] / counts[owner])
