"""Converting one model: from its source to a glTF binary, collision shapes and support surfaces."""

import hashlib
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from assets_build.drawn import Drawn
from assets_build.geometry import Geometry, decimate, split_by_crease, to_model_frame, weld
from assets_build.glb import OutputMaterial, write_glb
from assets_build.hollow import hollow_hulls
from assets_build.images import as_opaque, encode_jpeg, read_texture
from assets_build.masses import estimate_mass
from assets_build.primitives import Drawing
from assets_build.sampling import sample_surface
from assets_build.selection import Entry
from assets_build.shapes import Shape, hull, merged_boxes, with_flat_bottom
from assets_build.sources import SourceModel
from assets_build.surfaces import Surface, find_surfaces, is_usable, seat_box
from assets_build.voxels import voxelise
from assets_build.wavefront import SourceMesh, read_obj

BUDGETS = {"receptacle": 2600, "object": 900, "decor": 2600, "door": 1500}
TEXTURES = {"receptacle": 512, "object": 256, "decor": 512, "door": 512}
INVISIBLE = 0.04
SOLID = frozenset(
    (
        "bathtub",
        "bed",
        "chest_of_drawers",
        "couch",
        "filing_cabinet",
        "hamper",
        "sink",
        "toilet",
        "trunk",
        "washer_dryer",
    )
)
EVERY_HEIGHT = (0.03, 2.5)
HEIGHTS = {"chair": (0.2, 0.6), "couch": (0.2, 0.62), "stool": (0.25, 0.9), "table": (0.09, 1.2), "toilet": (0.2, 1.0)}
VESSELS = frozenset(("bathtub", "sink"))
BOXES = {
    "shelves": 18,
    "cabinet": 14,
    "sink": 16,
    "bathtub": 18,
    "wardrobe": 14,
    "couch": 10,
    "bed": 8,
    "plant": 6,
    "toilet": 8,
}


@dataclass(frozen=True)
class Built:
    """A model of the model frame, ready to be written: its mesh at full detail and what it is made of."""

    mesh: SourceMesh
    materials: list[OutputMaterial]


@lru_cache(maxsize=512)
def _texture(path: Path, limit: int) -> NDArray[np.uint8] | None:
    return read_texture(path, limit)


def output_materials(mesh: SourceMesh, limit: int) -> list[OutputMaterial]:
    """Return what the source's materials become: opaque colours and small JPEGs."""
    result = []
    for material in mesh.materials:
        image = _texture(material.texture, limit) if material.texture else None
        if image is None:
            result.append(OutputMaterial(as_opaque(material.color, material.opacity or 1.0), None))
        elif max(image.shape[:2]) <= 4:
            r, g, b = (float(v) / 255 for v in image.reshape(-1, 3).mean(0))
            result.append(OutputMaterial((r, g, b), None))
        else:
            result.append(OutputMaterial((1.0, 1.0, 1.0), encode_jpeg(image)))
    return result


def prepared(model: SourceModel, entry: Entry) -> Built:
    """Return the source's model in the model frame at its real size."""
    size = entry.size or tuple(s * entry.scale for s in model.size)
    model = SourceModel(**{**model.__dict__, "size": size})
    mesh = to_model_frame(read_obj(model.obj_path), model, entry.turn)
    return Built(mesh, output_materials(mesh, entry.texture or TEXTURES[entry.role]))


def reduced_geometry(built: Built, budget: int) -> Geometry:
    """Return the welded and decimated geometry of the visible materials (all, where none claims to be visible)."""
    visible = np.array([m.opacity > INVISIBLE for m in built.mesh.materials])
    if not visible[built.mesh.triangle_materials].any():
        visible[:] = True
    textured = np.array([m.jpeg is not None for m in built.materials])
    return decimate(weld(built.mesh, visible[built.mesh.triangle_materials], textured), budget)


def stand_on_origin(geometry: Geometry) -> tuple[float, ...]:
    """Move a geometry so that it stands on the origin, and return its size along x, y and z (m)."""
    middle = (geometry.positions.min(0) + geometry.positions.max(0)) / 2
    middle[2] = geometry.positions[:, 2].min()
    geometry.positions -= middle
    return tuple(round(float(v), 4) for v in np.ptp(geometry.positions, axis=0))


def collision_shapes(geometry: Geometry, entry: Entry) -> list[Shape]:
    """Return the shapes of the kind that the entry asks for, or that suits its role and category."""
    kind = entry.collision or ("hull" if entry.role == "object" else "solid" if entry.category in SOLID else "boxes")
    if kind == "none":
        return []
    if kind == "hull":
        return [hull(with_flat_bottom(geometry.positions))]
    if kind == "hollow":
        return hollow_hulls(geometry)
    extent = float(np.ptp(geometry.positions, axis=0).max())
    step = 0.03 if entry.category in VESSELS else 0.04 if extent > 1.2 else 0.03 if extent > 0.5 else 0.015
    samples = sample_surface(geometry.corners, step / 5)
    fill = 0.985 if entry.category in VESSELS else 0.88
    return merged_boxes(voxelise(samples, step, kind == "solid"), entry.boxes or BOXES.get(entry.category, 14), fill)


def supporting(
    shapes: list[Shape], geometry: Geometry, size: tuple[float, ...], category: str
) -> tuple[list[Shape], list[Surface]]:
    """Return a receptacle's shapes and surfaces; where a robot could use none of them, its widest level becomes one."""
    samples = sample_surface(geometry.corners, 0.008)
    surfaces = find_surfaces(shapes, samples, size, HEIGHTS.get(category, EVERY_HEIGHT))
    if any(is_usable(s) for s in surfaces):
        return shapes, surfaces
    seat = seat_box(samples, shapes)
    shapes = [*shapes, seat] if seat else shapes
    return shapes, find_surfaces(shapes, samples, size, HEIGHTS.get(category, EVERY_HEIGHT))


def build_model(model: SourceModel, entry: Entry, folder: Path) -> dict[str, Any]:
    """Write the model's file and return its catalogue entry (without its pool)."""
    built = prepared(model, entry)
    provenance = {
        "name": entry.name or model.name.lower(),
        "source": model.source,
        "source_id": model.source_id,
        "creator": model.creator,
        "licence": model.licence,
    }
    return write_model(built, entry, entry.id, provenance, folder)


def write_model(built: Built, entry: Entry, model_id: str, provenance: dict[str, str], folder: Path) -> dict[str, Any]:
    """Decimate, find shapes and surfaces, write the file, and return the catalogue entry."""
    geometry = reduced_geometry(built, entry.budget or BUDGETS[entry.role])
    size = stand_on_origin(geometry)
    shapes = collision_shapes(geometry, entry)
    surfaces: list[Surface] = []
    if entry.role == "receptacle":
        shapes, surfaces = supporting(shapes, geometry, size, entry.category)
    elif entry.role == "decor" and shapes:
        surfaces = find_surfaces(shapes, sample_surface(geometry.corners, 0.01), size, EVERY_HEIGHT)
    split, normals = split_by_crease(geometry)
    path = folder / f"{model_id}.glb"
    write_glb(path, split, normals, built.materials)
    return {
        "id": model_id,
        "role": entry.role,
        "category": entry.category,
        **provenance,
        "size": list(size),
        "mass": entry.mass or estimate_mass(entry.role, entry.category, size),
        "shapes": shapes,
        "surfaces": surfaces,
        "checksum": hashlib.sha256(path.read_bytes()).hexdigest(),
    }


def build_drawn(drawn: Drawn, folder: Path) -> dict[str, Any]:
    """Write the file of a model that is drawn here and return its catalogue entry (without its pool)."""
    drawing = Drawing()
    drawn.draw(drawing)
    model_id = f"{drawn.category}_{drawn.slug}"
    provenance = {
        "name": drawn.name,
        "source": "drawn",
        "source_id": model_id,
        "creator": "uniteam",
        "licence": "CC0-1.0",
    }
    entry = Entry(
        drawn.slug,
        drawn.role,
        drawn.category,
        collision=drawn.collision,
        boxes=drawn.boxes,
        mass=drawn.mass,
        budget=drawn.budget,
    )
    return write_model(Built(drawing.mesh(), drawing.materials()), entry, model_id, provenance, folder)
