"""A home of our generator as a scene of HSSD: stage, furniture and rooms; small objects are an episode's."""

import json
from collections import Counter
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import numpy as np
from worlds.ovmm_miniature.glb_file import write_glb
from worlds.ovmm_miniature.ktx2_pictures import Ktx2Pictures
from worlds.ovmm_miniature.model_files import file_frame, model_hash, write_model

from uniteam.geometry import Point2, quaternion_to_matrix
from uniteam.world.assets.mesh import Mesh
from uniteam.world.homes.home import Home, Instance, Room
from uniteam.world.rendering.meshes.stage_mesh import StagePart, stage_parts

SCENES, CONFIG = "scenes-uncluttered", "hssd-hab-uncluttered.scene_dataset_config.json"


def write_scene(home: Home, folder: Path, pictures: Ktx2Pictures) -> None:
    """Write a scene into the folder `hssd-hab`, and what it shows beside it."""
    furniture = [instance for instance in home.instances if not instance.movable]
    for name in sorted({instance.model for instance in furniture}):
        model = home.library[name]
        write_model(model, folder / "objects" / model_hash(model)[0], pictures)
    write_glb(folder / "stages" / f"{home.name}.glb", stage_meshes(home), pictures)
    _write(folder / "stages" / f"{home.name}.stage_config.json", {"render_asset": f"{home.name}.glb"})
    scene = {
        "stage_instance": {"template_name": f"stages/{home.name}"},
        "default_lighting": "",
        "translation_origin": "asset_local",
        "object_instances": [_entry(home, instance) for instance in furniture],
        "articulated_object_instances": [],
        "semantic_scene_instance": "hssd_ssd_map",
        "user_defined": {"scene_filter_file": f"scene_filter_files/{home.name}.rec_filter.json"},
    }
    _write(folder / SCENES / f"{home.name}.scene_instance.json", scene)
    regions = {"region_annotations": [_region(room, home.stage.ceiling_height) for room in home.stage.rooms]}
    _write(folder / "semantics" / "scenes" / f"{home.name}.semantic_config.json", regions)


def stage_meshes(home: Home) -> list[Mesh]:
    """Return the meshes of floors, walls and ceilings; what shines by itself is of materials that are not lit."""
    return [_shining(part) for part in stage_parts(home.stage, home.library)]


def write_tables(homes: Iterable[Home], data: Path) -> None:
    """Write the tables of classes, and the data set's own config."""
    models = {m.id: m for home in homes for m in (home.model_of(i) for i in home.instances if not i.movable)}
    lines = [f"{model_hash(m)},{m.name.replace(',', '')},{m.category}" for m in models.values()]
    table = "\n".join(["id,name,main_category", *lines]) + "\n"
    (data / "hssd-hab" / "semantics" / "objects.csv").write_text(table)
    receptacles = [f"{model_hash(m)},{m.category.replace('_', ' ')}" for m in models.values() if m.role == "receptacle"]
    (data / "objects" / "hssd-receptacles.csv").write_text("\n".join(receptacles) + "\n")
    _write(data / "hssd-hab" / CONFIG, {"stages": {"paths": {".json": ["stages/*.stage_config.json"]}}})


def handles(home: Home) -> dict[str, str]:
    """Return what the simulator calls each instance of a home: furniture in its order, small objects in theirs."""
    counts: Counter[str] = Counter()
    names = {}
    for instance in home.instances:
        name = model_hash(home.model_of(instance))
        names[instance.name] = f"{name}_:{counts[name]:04d}"
        counts[name] += 1
    return names


def floor_point(point: Point2) -> list[float]:
    """Return a point of the floor in Habitat's world."""
    x, y = point
    return [x, 0.0, -y]


def _entry(home: Home, instance: Instance) -> dict[str, object]:
    frame = file_frame(home.model_of(instance))
    shift = quaternion_to_matrix(np.array(instance.quaternion)) @ frame.shift
    x, y, z = (np.array(instance.position) - shift).tolist()
    w, qx, qy, qz = instance.quaternion
    sx, sy, sz = frame.stretch.tolist()
    entry: dict[str, object] = {"template_name": model_hash(home.model_of(instance)), "motion_type": "STATIC"}
    entry |= {"translation": [x, z, -y], "rotation": [w, qx, qz, -qy]}
    return entry if np.allclose(frame.stretch, 1.0) else entry | {"non_uniform_scale": [sx, sz, sy]}


def _region(room: Room, ceiling: float) -> dict[str, object]:
    loop = [floor_point(corner) for corner in room.outline]
    return {
        "name": room.name, "label": room.kind, "poly_loop": loop, "floor_height": 0.0, "extrusion_height": ceiling,
        "min_bounds": np.min(loop, axis=0).tolist(), "max_bounds": np.max(loop, axis=0).tolist(),
    }  # fmt: skip


def _shining(part: StagePart) -> Mesh:
    materials = tuple(replace(m, is_lit=not part.is_glowing) for m in part.mesh.materials)
    return replace(part.mesh, materials=materials)


def _write(path: Path, content: object) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(content))
