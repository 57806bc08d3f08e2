"""What of a home can be seen, as meshes by name: each model once, the stage in a few pieces, without the ceiling."""

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from uniteam.world.assets.mesh import Material, Mesh, load_model_mesh
from uniteam.world.homes.home import Home, Instance
from uniteam.world.rendering.meshes.stage_mesh import StagePart, stage_parts


@dataclass(frozen=True)
class Visible:
    """A home's meshes.

    Attributes:
        stage: floor and walls by name, in the world's frame (m).
        models: of the instances, by their id, in the model's frame (m).
        instances: what stands where.
    """

    stage: dict[str, Mesh]
    models: dict[str, Mesh]
    instances: tuple[Instance, ...]


def visible(home: Home) -> Visible:
    """Return the meshes of a home.

    Raises:
        DamagedFileError: a file of the home's library, or the stage's mesh, cannot be read.
        UnknownNameError: the home names a model or a texture that its library lacks.
    """
    parts = sorted((p for p in stage_parts(home.stage, home.library) if p.name != "ceiling"), key=lambda p: p.name)
    stage = {name: _joined(of_name) for name, of_name in groupby(parts, key=lambda part: part.name)}
    models = {name: load_model_mesh(home.library[name]) for name in sorted({i.model for i in home.instances})}
    return Visible(stage, models, home.instances)


def by_material(mesh: Mesh) -> list[tuple[Material, Mesh]]:
    """Return a mesh's triangles of each material as a mesh of their own, with the vertices that they need."""
    pieces = []
    for k in np.unique(mesh.triangle_materials):
        used, corners = np.unique(mesh.triangles[mesh.triangle_materials == k], return_inverse=True)
        triangles = corners.reshape(-1, 3).astype(np.int32)
        material = mesh.materials[k]
        own = (mesh.vertices[used], mesh.normals[used], mesh.uvs[used], triangles, np.zeros(len(triangles), np.int32))
        pieces.append((material, Mesh(*own, (material,))))
    return pieces


def _joined(parts: Iterable[StagePart]) -> Mesh:
    """Return meshes of the world's frame as one."""
    meshes = [part.mesh for part in parts]
    vertices = np.cumsum([0, *(len(mesh.vertices) for mesh in meshes)])
    materials = np.cumsum([0, *(len(mesh.materials) for mesh in meshes)])

    def together(arrays: Iterable[NDArray[np.float32]]) -> NDArray[np.float32]:
        return np.concatenate(list(arrays)).astype(np.float32)

    return Mesh(
        together(mesh.vertices for mesh in meshes),
        together(mesh.normals for mesh in meshes),
        together(mesh.uvs for mesh in meshes),
        np.concatenate([m.triangles + start for m, start in zip(meshes, vertices, strict=False)]).astype(np.int32),
        np.concatenate([m.triangle_materials + k for m, k in zip(meshes, materials, strict=False)]).astype(np.int32),
        tuple(material for mesh in meshes for material in mesh.materials),
    )
