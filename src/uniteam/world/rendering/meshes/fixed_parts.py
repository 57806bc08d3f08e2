"""The mesh of a stage as parts that are lit by their rooms or by themselves, hidden with the ceiling where so high."""

from collections.abc import Callable, Iterator
from itertools import product

import numpy as np
from numpy.typing import NDArray

from uniteam.world.assets.mesh import Mesh
from uniteam.world.rendering.meshes.refine import refined

LONGEST_SIDE = 0.75
"""Of the triangles at whose corners light is computed (m)."""

_CEILING_DEPTH = 0.05
_OUTWARDS = 0.05


def fixed_parts(
    mesh: Mesh, ceiling_height: float, room_at: Callable[[float, float], int | None]
) -> Iterator[tuple[str, Mesh, int | None, bool]]:
    """Yield parts of a stage's mesh: "stage" or "ceiling", triangles, the room that lights them, and whether they glow.

    Args:
        mesh: world frame.
        ceiling_height: m; triangles no lower than 5 cm below it belong to the ceiling.
        room_at: index of the room at a point of the floor (m, world).
    """
    mesh = refined(mesh, LONGEST_SIDE)
    corners = mesh.vertices[mesh.triangles]
    is_ceiling = corners[..., 2].min(axis=1) > ceiling_height - _CEILING_DEPTH
    outwards = mesh.normals[mesh.triangles].mean(axis=1)
    before = corners.mean(axis=1) + np.float32(_OUTWARDS) * outwards
    found = [room_at(float(x), float(y)) for x, y in before[:, :2]]
    rooms = np.array([-1 if room is None else room for room in found])
    glowing = np.array([not material.is_lit for material in mesh.materials])[mesh.triangle_materials]
    for name, of_name in (("stage", ~is_ceiling), ("ceiling", is_ceiling)):
        for room, glows in product(np.unique(rooms), (False, True)):
            chosen = of_name & (rooms == room) & (glowing == glows)
            if chosen.any():
                yield name, _chosen(mesh, chosen), None if room < 0 else int(room), glows


def _chosen(mesh: Mesh, triangles: NDArray[np.bool_]) -> Mesh:
    """Return some triangles of a mesh, with the vertices and the materials that they need."""
    used, corners = np.unique(mesh.triangles[triangles], return_inverse=True)
    kinds, materials = np.unique(mesh.triangle_materials[triangles], return_inverse=True)
    return Mesh(
        mesh.vertices[used],
        mesh.normals[used],
        mesh.uvs[used],
        corners.reshape(-1, 3).astype(np.int32),
        materials.astype(np.int32),
        tuple(mesh.materials[kind] for kind in kinds),
    )
