"""Flat rectangles and boxes gathered into meshes: what floors, walls and frames are built from."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import Point2
from uniteam.world.assets.mesh import Material, Mesh
from uniteam.world.homes.polygon import triangles

Vector = NDArray[np.float64]


GRID = 0.5
"""Light is computed at the corners of a grid of about this size (m)."""


@dataclass(frozen=True)
class Surface:
    """How a rectangle looks: its material, and how many metres one tile of the texture covers."""

    material: Material
    tile_size: float = 1.0


@dataclass(frozen=True)
class Plane:
    """Where a rectangle lies: point (u, v) of the rectangle is at `origin + u * right + v * up` and faces `normal`."""

    origin: Vector
    right: Vector
    up: Vector
    normal: Vector


def grid_cuts(low: float, high: float, edges: Sequence[float] = ()) -> list[float]:
    """Return the borders of a grid: both ends, the edges that lie between, and steps of about `GRID` (m)."""
    fixed = sorted({low, high, *(e for e in edges if low < e < high)})
    cuts = [low]
    for a, b in pairwise(fixed):
        count = max(1, round((b - a) / GRID))
        cuts += [a + (b - a) * (k + 1) / count for k in range(count)]
    return cuts


def _box_template() -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.int64]]:
    """Return the 24 corners of a unit box's six faces, their normals, and the faces' triangles."""
    corners, normals, triangles = [], [], []
    for axis in range(3):
        for end in (0.0, 1.0):
            for u, v in ((0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)):
                corners.append(np.roll([end, u, v], axis))
                normals.append(np.roll([2.0 * end - 1.0, 0.0, 0.0], axis))
            first = len(corners) - 4
            triangles += [[first, first + 1, first + 2], [first, first + 2, first + 3]]
    return np.array(corners), np.array(normals), np.array(triangles)


_BOX_CORNERS, _BOX_NORMALS, _BOX_TRIANGLES = _box_template()


class MeshBuilder:
    """Gathers rectangles of several surfaces into one mesh."""

    def __init__(self) -> None:
        self._vertices: list[NDArray[np.float32]] = []
        self._normals: list[NDArray[np.float32]] = []
        self._uvs: list[NDArray[np.float32]] = []
        self._triangles: list[NDArray[np.int32]] = []
        self._triangle_materials: list[NDArray[np.int32]] = []
        self._surfaces: list[Surface] = []
        self._count = 0

    def add_rectangle(
        self, plane: Plane, cuts: tuple[Sequence[float], Sequence[float]], surface: Surface, kept: NDArray | None = None
    ) -> None:
        """Add the grid between the cuts along u and v (m); `kept` (len(u) - 1, len(v) - 1) bool leaves holes."""
        u, v = (np.asarray(c, dtype=np.float64) for c in cuts)
        grid_u, grid_v = np.meshgrid(u, v, indexing="ij")
        points = plane.origin + grid_u[..., None] * plane.right + grid_v[..., None] * plane.up
        corner = np.arange(grid_u.size).reshape(grid_u.shape)
        a, b, c, d = corner[:-1, :-1], corner[1:, :-1], corner[1:, 1:], corner[:-1, 1:]
        quads = np.stack([a, b, c, a, c, d], axis=-1)
        chosen = (quads if kept is None else quads[kept]).reshape(-1, 3)
        self._append(points.reshape(-1, 3), plane.normal, np.stack([grid_u, -grid_v], axis=-1), chosen, surface)

    def add_polygon(self, plane: Plane, polygon: Sequence[Point2], surface: Surface) -> None:
        """Add a simple polygon of (u, v) corners (m), counter-clockwise, in as few triangles as it takes."""
        uv = np.array(polygon, dtype=np.float64)
        points = plane.origin + uv[:, :1] * plane.right + uv[:, 1:] * plane.up
        self._append(points, plane.normal, uv * (1.0, -1.0), np.array(triangles(tuple(polygon))), surface)

    def add_box(self, low: Vector, high: Vector, frame: NDArray[np.float64], surface: Surface) -> None:
        """Add an axis-aligned box of a frame in one colour; `frame` (4, 4) takes it to the world."""
        rotation = frame[:3, :3]
        points = (low + _BOX_CORNERS * (np.asarray(high) - low)) @ rotation.T + frame[:3, 3]
        self._append(points, _BOX_NORMALS @ rotation.T, np.zeros((len(points), 2)), _BOX_TRIANGLES, surface)

    def build(self) -> Mesh:
        """Return everything added as one mesh."""
        return Mesh(
            vertices=np.concatenate(self._vertices),
            normals=np.concatenate(self._normals),
            uvs=np.concatenate(self._uvs),
            triangles=np.concatenate(self._triangles),
            triangle_materials=np.concatenate(self._triangle_materials),
            materials=tuple(surface.material for surface in self._surfaces),
        )

    def _append(self, points: Vector, normal: Vector, uv: Vector, triangles: NDArray, surface: Surface) -> None:
        material = self._index_of(surface)
        self._vertices.append(points.astype(np.float32))
        self._normals.append(np.broadcast_to(normal, points.shape).astype(np.float32))
        self._uvs.append((uv.reshape(-1, 2) / surface.tile_size).astype(np.float32))
        self._triangles.append((triangles + self._count).astype(np.int32))
        self._triangle_materials.append(np.full(len(triangles), material, dtype=np.int32))
        self._count += len(points)

    def _index_of(self, surface: Surface) -> int:
        for index, known in enumerate(self._surfaces):
            if known is surface:
                return index
        self._surfaces.append(surface)
        return len(self._surfaces) - 1
