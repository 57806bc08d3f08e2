"""A mesh made ready for the rasteriser: windings that agree with the normals, mip chains, texel areas."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from uniteam.world.assets.mesh import Mesh, load_model_mesh
from uniteam.world.assets.model import Model
from uniteam.world.assets.reading import damaged, modified
from uniteam.world.rendering.kernels.texture_atlas import WHITE, MipChain, build_mip_chain

Float32Array = NDArray[np.float32]

_LARGEST_MISFIT = 0.02
"""By how much a model's bounding box may differ from the library's word (m)."""


@dataclass(frozen=True)
class RenderMesh:
    """What the rasteriser needs of a mesh.

    Attributes:
        vertices, normals: (V, 3) float32, model frame (m).
        uvs: (V, 2) float32.
        triangles: (T, 3) int32, counter-clockwise seen from the side that the normals point to.
        triangle_materials: (T,) int32.
        texel_areas: (T,) float32, twice the area of the triangle in texels of level 0.
        colors: (M, 3) float32 sRGB in [0, 1], a material.
        textures: (M,) mip chains.
        low, high: (3,) float32 corners of the bounding box.
    """

    vertices: Float32Array
    normals: Float32Array
    uvs: Float32Array
    triangles: NDArray[np.int32]
    triangle_materials: NDArray[np.int32]
    texel_areas: Float32Array
    colors: Float32Array
    textures: tuple[MipChain, ...]
    low: Float32Array
    high: Float32Array


def make_render_mesh(mesh: Mesh, mip_chain: Callable[[NDArray[np.uint8]], MipChain] = build_mip_chain) -> RenderMesh:
    """Prepare a mesh; `mip_chain` makes a texture's pyramid, or remembers it where meshes share textures."""
    vertices = np.ascontiguousarray(mesh.vertices, dtype=np.float32)
    normals = np.ascontiguousarray(mesh.normals, dtype=np.float32)
    textures = tuple(WHITE if m.texture is None else mip_chain(m.texture) for m in mesh.materials)
    triangle_materials = np.ascontiguousarray(mesh.triangle_materials, dtype=np.int32)
    triangles = _wind_with_normals(vertices, normals, mesh.triangles)
    return RenderMesh(
        vertices=vertices,
        normals=normals,
        uvs=np.ascontiguousarray(mesh.uvs, dtype=np.float32),
        triangles=triangles,
        triangle_materials=triangle_materials,
        texel_areas=_texel_areas(mesh.uvs, triangles, triangle_materials, textures),
        colors=np.array([m.color for m in mesh.materials], dtype=np.float32).reshape(-1, 3),
        textures=textures,
        low=vertices.min(axis=0),
        high=vertices.max(axis=0),
    )


def load_render_mesh(model: Model) -> RenderMesh:
    """Read and prepare a model, once a process as long as its file does not change.

    Raises:
        DamagedFileError: the file is not a mesh, or not of the size that the library says.
    """
    return _load(model, modified(model.path))


@lru_cache(maxsize=512)
def _load(model: Model, *_: object) -> RenderMesh:
    mesh, size = make_render_mesh(load_model_mesh(model)), model.size
    low, high = np.array([-size[0] / 2, -size[1] / 2, 0.0]), np.array([size[0] / 2, size[1] / 2, size[2]])
    if max(np.abs(mesh.low - low).max(), np.abs(mesh.high - high).max()) > _LARGEST_MISFIT:
        found = " x ".join(f"{length:.3g}" for length in mesh.high - mesh.low)
        said = " x ".join(f"{length:.3g}" for length in size)
        reason = f"its bounding box is {found} m and must be {said} m, its floor's centre at the origin"
        raise damaged(model.path, "the model", reason)
    return mesh


def _wind_with_normals(
    vertices: Float32Array, normals: Float32Array, triangles: NDArray[np.integer]
) -> NDArray[np.int32]:
    a, b, c = (vertices[triangles[:, k]] for k in range(3))
    face = np.cross(b - a, c - a)
    agrees = np.einsum("ij,ij->i", face, normals[triangles].sum(axis=1)) >= 0.0
    flipped = triangles[:, [0, 2, 1]]
    return np.ascontiguousarray(np.where(agrees[:, None], triangles, flipped), dtype=np.int32)


def _texel_areas(
    uvs: Float32Array, triangles: NDArray[np.int32], materials: NDArray[np.int32], textures: tuple[MipChain, ...]
) -> Float32Array:
    a, b, c = (uvs[triangles[:, k]].astype(np.float64) for k in range(3))
    uv_areas = np.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    texels = np.array([float(1 << (t.log2_width + t.log2_height)) for t in textures])
    return (uv_areas * texels[materials]).astype(np.float32)
