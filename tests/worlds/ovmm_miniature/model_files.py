"""Models of the pack as files of a data set: moved and stretched in their files, which their configs make good."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from hashlib import sha1
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from worlds.ovmm_miniature.glb_file import write_glb
from worlds.ovmm_miniature.ktx2_pictures import Ktx2Pictures
from worlds.ovmm_miniature.solids import flat, solid

from uniteam.world.assets.mesh import Mesh, load_model_mesh
from uniteam.world.assets.model import Model

Vector = NDArray[np.float64]


@dataclass(frozen=True)
class FileFrame:
    """How a model lies in its file: scale * config scale * stretch * point_of_file = point_of_model + shift (z up).

    Attributes:
        shift: (3,) m.
        config_scale, stretch: (3,) of the config, and of each instance.
        center_of_mass: (3,) of the scaled file; None where the config says nothing, so that it is the box's middle.
    """

    shift: Vector
    config_scale: Vector
    stretch: Vector
    center_of_mass: Vector | None

    def in_file(self, mesh: Mesh) -> Mesh:
        """Return a mesh of the model's frame as it stands in the file."""
        points = (mesh.vertices + self.shift) / (self.config_scale * self.stretch)
        normals = mesh.normals * (self.config_scale * self.stretch)
        normals = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-9)
        return replace(mesh, vertices=points.astype(np.float32), normals=normals.astype(np.float32))


def file_frame(model: Model) -> FileFrame:
    """Return a frame that differs from model to model: all are moved, some scaled, stretched or weighted."""
    number = int(model_hash(model), 16)
    is_object = model.role == "object"
    shift = np.array([0.31, -0.17, 0.07]) * (1 + number % 3)
    config_scale = np.array([[1.0, 1.0, 1.0], [0.5, 0.5, 0.5], [2.0, 1.0, 0.5]][number % 3])
    stretch = np.ones(3) if is_object or number % 5 else np.array([1.25, 0.8, 1.6])
    return FileFrame(shift, config_scale, stretch, shift + 0.01 if is_object and number % 2 else None)


def model_hash(model: Model) -> str:
    """Return the name of a model's files."""
    return sha1(model.id.encode()).hexdigest()


def write_model(model: Model, folder: Path, pictures: Ktx2Pictures) -> None:
    """Write a model's config, mesh, collider and receptacles into a folder."""
    name, frame = model_hash(model), file_frame(model)
    write_glb(folder / f"{name}.glb", [frame.in_file(load_model_mesh(model))], pictures)
    config: dict[str, Any] = {"render_asset": f"{name}.glb", "mass": model.mass, "up": [0, 1, 0]}
    config["scale"] = _y_up(frame.config_scale)
    if model.shapes:
        write_glb(folder / f"{name}.collider.glb", [frame.in_file(solid(s)) for s in model.shapes], pictures)
        config |= {"collision_asset": f"{name}.collider.glb", "join_collision_meshes": model.role == "object"}
    else:
        config["is_collidable"] = False
    if frame.center_of_mass is not None:
        x, y, z = frame.center_of_mass / frame.config_scale
        config["COM"] = [x, z, -y]
    config["user_defined"] = dict(_receptacles(model, frame, folder, pictures))
    (folder / f"{name}.object_config.json").write_text(json.dumps(config))


def _receptacles(model: Model, frame: FileFrame, folder: Path, pictures: Ktx2Pictures) -> Mapping[str, Any]:
    name = model_hash(model)
    entries = {}
    for number, surface in enumerate(model.surfaces):
        file = f"{name}.filteredSupportSurface{number}.glb"
        write_glb(folder / file, [frame.in_file(flat(surface))], pictures)
        entry = {"name": f"receptacle_mesh_{name}", "parent_object": name, "position": [0, 0, 0]}
        more = {"rotation": [1, 0, 0, 0], "scale": [1, 1, 1], "up": [0, 1, 0], "mesh_filepath": file}
        entries[f"receptacle_mesh_{name}.{number:04d}"] = entry | more
    return entries


def _y_up(scale: Vector) -> list[float]:
    x, y, z = scale.tolist()
    return [x, z, y]
