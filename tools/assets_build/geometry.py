"""From a source's corners to a welded, decimated mesh of the model frame with creased normals."""

from dataclasses import dataclass

import meshoptimizer
import numpy as np
from numpy.typing import NDArray

from assets_build.sources import SourceModel
from assets_build.wavefront import SourceMesh

CREASE_COSINE = float(np.cos(np.radians(42.0)))


@dataclass
class Geometry:
    """Welded corners: positions (V, 3), uvs (V, 2) with v down, materials (V,) of each vertex, triangles (T, 3)."""

    positions: NDArray[np.float32]
    uvs: NDArray[np.float32]
    vertex_materials: NDArray[np.int32]
    triangles: NDArray[np.int64]

    @property
    def triangle_materials(self) -> NDArray[np.int32]:
        """The material of each triangle: that of its corners."""
        return self.vertex_materials[self.triangles[:, 0]]

    @property
    def corners(self) -> NDArray[np.float32]:
        """(T, 3, 3) positions of the triangles' corners."""
        return self.positions[self.triangles]


def to_model_frame(mesh: SourceMesh, model: SourceModel, turn: float = 0.0) -> SourceMesh:
    """Rotate, scale to the real size, make z up, and put the origin at the centre of the bottom.

    `turn` (degrees, about z) mends a model whose front the catalogue has wrong.
    """
    points = mesh.positions @ model.rotation.T
    points = np.stack([points[..., 0], -points[..., 2], points[..., 1]], axis=-1)
    flat = points.reshape(-1, 3)
    low, high = flat.min(0), flat.max(0)
    points = (points - (low + high) / 2) * (np.array(model.size) / np.maximum(high - low, 1e-9))
    c, s = round(np.cos(np.radians(turn)), 12), round(np.sin(np.radians(turn)), 12)
    points = points @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]).T
    return SourceMesh(centred(points), mesh.uvs, mesh.triangle_materials, mesh.materials)


def centred(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Move points so that the bounding box's bottom centre is the origin."""
    flat = points.reshape(-1, 3)
    low, high = flat.min(0), flat.max(0)
    return points - np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])


def weld(mesh: SourceMesh, keep: NDArray[np.bool_], textured: NDArray[np.bool_]) -> Geometry:
    """Join equal corners (0.1 mm, 1e-4 in uv) of the triangles to keep; uvs of untextured materials are zeroed."""
    points = mesh.positions[keep].reshape(-1, 3)
    materials = np.repeat(mesh.triangle_materials[keep], 3)
    uvs = mesh.uvs[keep].reshape(-1, 2).copy()
    uvs[:, 1] = 1.0 - uvs[:, 1]
    uvs[~textured[materials]] = 0.0
    key = np.column_stack([np.round(points / 1e-4), np.round(uvs / 1e-4), materials]).astype(np.int64)
    _, first, inverse = np.unique(key, axis=0, return_index=True, return_inverse=True)
    triangles = inverse.reshape(-1, 3)
    triangles = triangles[_is_proper(points[first], triangles)]
    return _compact(points[first].astype(np.float32), uvs[first].astype(np.float32), materials[first], triangles)


def _is_proper(points: NDArray[np.floating], triangles: NDArray[np.int64]) -> NDArray[np.bool_]:
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) > 1e-10


def _compact(positions, uvs, materials, triangles) -> Geometry:  # type: ignore[no-untyped-def]
    used, inverse = np.unique(triangles, return_inverse=True)
    return Geometry(positions[used], uvs[used], materials[used].astype(np.int32), inverse.reshape(-1, 3))


def decimate(geometry: Geometry, budget: int, error: float = 0.005) -> Geometry:
    """Collapse edges while the shape changes by less than `error` of its size, and further where the budget asks it.

    Quadric edge collapse onto existing vertices (meshoptimizer), so that texture coordinates stay true; sloppy vertex
    clustering only for meshes whose many parts cannot be collapsed.
    """
    result = _simplify(geometry, min(budget, len(geometry.triangles)) // 4, error, 0)
    for allowed in (0.01, 0.02, 0.05, 0.1, 1.0):
        if len(result.triangles) <= budget:
            break
        result = _simplify(geometry, budget, allowed, meshoptimizer.SIMPLIFY_PRUNE)
    is_whole = (
        np.ptp(result.positions, axis=0) > 0.97 * np.ptp(geometry.positions, axis=0) if len(result.triangles) else False
    )
    return result if len(result.triangles) <= budget and np.all(is_whole) else _sloppy(geometry, budget)


def _simplify(geometry: Geometry, target: int, error: float, options: int) -> Geometry:
    indices = np.ascontiguousarray(geometry.triangles.reshape(-1), dtype=np.uint32)
    out = np.zeros(len(indices), dtype=np.uint32)
    positions = np.ascontiguousarray(geometry.positions, dtype=np.float32)
    count = meshoptimizer.simplify(
        out, indices, positions, len(indices), len(positions), 12, max(3, 3 * target), error, options
    )
    return _compact(
        geometry.positions, geometry.uvs, geometry.vertex_materials, out[:count].reshape(-1, 3).astype(np.int64)
    )


def _sloppy(geometry: Geometry, target: int) -> Geometry:
    indices = np.ascontiguousarray(geometry.triangles.reshape(-1), dtype=np.uint32)
    out = np.zeros(len(indices), dtype=np.uint32)
    positions = np.ascontiguousarray(geometry.positions, dtype=np.float32)
    count = meshoptimizer.simplify_sloppy(out, indices, positions, len(indices), len(positions), 12, 3 * target, 1.0)
    return _compact(
        geometry.positions, geometry.uvs, geometry.vertex_materials, out[:count].reshape(-1, 3).astype(np.int64)
    )


def face_normals(corners: NDArray[np.floating]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the (T, 3) unit normals and (T,) areas (m2) of triangles."""
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]).astype(np.float64)
    length = np.linalg.norm(cross, axis=1)
    return cross / np.maximum(length, 1e-15)[:, None], length / 2


def split_by_crease(geometry: Geometry) -> tuple[Geometry, NDArray[np.float32]]:
    """Return the geometry with vertices split where it creases, and its (V, 3) smooth normals."""
    normals, areas = face_normals(geometry.corners)
    spots = np.unique(np.round(geometry.positions / 1e-4).astype(np.int64), axis=0, return_inverse=True)[1].reshape(-1)
    corner_spot = spots[geometry.triangles].reshape(-1)
    order = np.argsort(corner_spot, kind="stable")
    starts = np.flatnonzero(np.diff(corner_spot[order], prepend=-1))
    smooth = np.empty((len(order), 3))
    for group in np.split(order, starts[1:]):
        faces = group // 3
        close = (normals[faces] @ normals[faces].T) >= CREASE_COSINE
        smooth[group] = close @ (normals[faces] * areas[faces, None])
    length = np.linalg.norm(smooth, axis=1)
    smooth = np.where(
        length[:, None] > 1e-12, smooth / np.maximum(length, 1e-12)[:, None], np.repeat(normals, 3, axis=0)
    )
    smooth[np.linalg.norm(smooth, axis=1) < 0.5] = (0.0, 0.0, 1.0)
    key = np.column_stack([geometry.triangles.reshape(-1), np.round(smooth * 50).astype(np.int64)])
    _, first, inverse = np.unique(key, axis=0, return_index=True, return_inverse=True)
    vertex = geometry.triangles.reshape(-1)[first]
    split = Geometry(
        geometry.positions[vertex], geometry.uvs[vertex], geometry.vertex_materials[vertex], inverse.reshape(-1, 3)
    )
    return split, smooth[first].astype(np.float32)
