"""The arrays of a scene: the vertices, triangles and textures of all its parts laid end to end."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError
from uniteam.world.rendering.kernels.scene_buffers import SceneBuffers
from uniteam.world.rendering.kernels.texture_atlas import AtlasBuilder
from uniteam.world.rendering.meshes.floor_shade import FloorShade
from uniteam.world.rendering.meshes.render_mesh import RenderMesh

MOST_TRIANGLES = 20_000_000
"""Of a home and all that stands in it: more would fill the memory."""


@dataclass(frozen=True)
class ScenePart:
    """One piece of a scene before it is packed; `room` is None where it takes the light of where it stands."""

    name: str
    mesh: RenderMesh
    label: int
    is_stage: bool = False
    is_glowing: bool = False


def corners_of(mesh: RenderMesh) -> NDArray[np.float64]:
    """Return the (8, 3) corners of a mesh's box (m, its own frame)."""
    choice = np.array([[(k >> axis) & 1 for axis in range(3)] for k in range(8)])
    return np.where(choice == 1, mesh.high.astype(np.float64), mesh.low.astype(np.float64))


def packed(parts: list[ScenePart], shade: FloorShade) -> SceneBuffers:
    """Lay the parts' arrays end to end; world vertices and light are filled in when the parts get their poses."""
    meshes = [part.mesh for part in parts]
    triangle_count = sum(len(mesh.triangles) for mesh in meshes)
    if triangle_count > MOST_TRIANGLES:
        raise InvalidInputError(f"a home may show {MOST_TRIANGLES} triangles, this one has {triangle_count}")
    vertex_ends = np.cumsum([len(d.vertices) for d in meshes])
    triangle_ends = np.cumsum([len(d.triangles) for d in meshes])
    vertex_starts, triangle_starts = (np.concatenate([[0], ends[:-1]]) for ends in (vertex_ends, triangle_ends))
    atlas = AtlasBuilder()
    bases, colors, textures = _pack_materials(meshes, atlas)
    textures_of_all = atlas.build()
    vertex_count, part_count = int(vertex_ends[-1]), len(parts)
    return SceneBuffers(
        vertices=np.zeros((vertex_count, 3), dtype=np.float32),
        light=np.ones((vertex_count, 2), dtype=np.float32),
        uvs=np.concatenate([d.uvs for d in meshes]),
        triangles=np.concatenate([d.triangles + np.int32(s) for d, s in zip(meshes, vertex_starts, strict=True)]),
        triangle_parts=np.repeat(np.arange(part_count, dtype=np.int32), [len(d.triangles) for d in meshes]),
        triangle_materials=np.concatenate(
            [d.triangle_materials + np.int32(b) for d, b in zip(meshes, bases, strict=True)]
        ),
        texel_areas=np.concatenate([d.texel_areas for d in meshes]),
        material_colors=colors,
        material_textures=textures,
        texture_layout=textures_of_all.layout,
        texels=textures_of_all.texels,
        part_ranges=np.stack([vertex_starts, vertex_ends, triangle_starts, triangle_ends], axis=1).astype(np.int32),
        part_boxes=np.zeros((part_count, 8, 3), dtype=np.float32),
        part_labels=np.array([part.label for part in parts], dtype=np.int16),
        part_tints=np.ones((part_count, 3), dtype=np.float32),
        part_visible=np.ones(part_count, dtype=bool),
        part_is_stage=np.array([part.is_stage for part in parts], dtype=bool),
        floor_shade=shade.values,
        floor_frame=shade.frame,
    )


def _pack_materials(
    meshes: list[RenderMesh], atlas: AtlasBuilder
) -> tuple[list[int], NDArray[np.float32], NDArray[np.int32]]:
    """Return where each mesh's materials begin, and the colours and textures of all of them."""
    base_of: dict[int, int] = {}
    colors: list[NDArray[np.float32]] = []
    textures: list[int] = []
    bases = []
    for mesh in meshes:
        if id(mesh) not in base_of:
            base_of[id(mesh)] = len(textures)
            colors.append(mesh.colors)
            textures += [atlas.add(chain) for chain in mesh.textures]
        bases.append(base_of[id(mesh)])
    return bases, np.concatenate(colors), np.array(textures, dtype=np.int32)
