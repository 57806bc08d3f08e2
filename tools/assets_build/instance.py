"""One instance of a drawn or generated family, ready to be written: nearly as drawn, with shapes and its real mass."""

import hashlib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from assets_build.convert import collision_shapes, stand_on_origin, supporting
from assets_build.geometry import decimate, split_by_crease, weld
from assets_build.glb import write_small_glb
from assets_build.primitives import Drawing
from assets_build.selection import Entry
from assets_build.surfaces import Surface
from assets_build.variation import Pool

MOST_TRIANGLES = {"object": 800, "receptacle": 1200}
FLATNESS = 0.0012
"""Triangles are joined where that changes the shape by less than this share of its size: what is flat or straight."""
MASSES = {"object": (0.01, 2.5), "receptacle": (2.0, 150.0)}


@dataclass(frozen=True)
class Piece:
    """What becomes a model.

    Attributes:
        drawing: its triangles and finishes.
        entry: its role, category, name and kind of collision; `source` is the model's id.
        density: kg for each m3 of its bounding box, within what its role may weigh.
        provenance: the catalogue's source, source_id, creator and licence.
        pool: which homes may hold it.
    """

    drawing: Drawing
    entry: Entry
    density: float
    provenance: dict[str, str]
    pool: Pool

    def key(self) -> str:
        """Return what the model depends on, short."""
        content = hashlib.sha256()
        for array in (*self.drawing.corners, *self.drawing.uvs):
            content.update(array.tobytes())
        content.update(repr((self.drawing.finishes, self.entry, self.density, self.provenance, self.pool)).encode())
        return f"{self.entry.source} {content.hexdigest()}"

    def write(self, folder: Path) -> dict[str, Any]:
        """Write the model's file and return its catalogue entry."""
        entry, mesh, materials = self.entry, self.drawing.mesh(), self.drawing.materials()
        textured = np.array([material.jpeg is not None for material in materials])
        everything = np.ones(len(mesh.positions), dtype=bool)
        geometry = decimate(weld(mesh, everything, textured), MOST_TRIANGLES[entry.role], FLATNESS)
        size = stand_on_origin(geometry)
        shapes = collision_shapes(geometry, entry)
        surfaces: list[Surface] = []
        if entry.role == "receptacle":
            shapes, surfaces = supporting(shapes, geometry, size, entry.category)
        split, normals = split_by_crease(geometry)
        path = folder / f"{entry.source}.glb"
        write_small_glb(path, split, normals, materials)
        low, high = MASSES[entry.role]
        return {
            "id": entry.source,
            "role": entry.role,
            "category": entry.category,
            "name": entry.name,
            **self.provenance,
            "size": list(size),
            "mass": round(min(max(self.density * float(np.prod(size)), low), high), 3),
            "shapes": shapes,
            "surfaces": surfaces,
            "checksum": hashlib.sha256(path.read_bytes()).hexdigest(),
            "pool": self.pool,
        }
