"""A scene of HSSD as the parts of a home: a stage with a mesh, and the furniture that stands in it.

Habitat's file format is described at https://aihabitat.org/docs/habitat-sim/attributesJSON.html, the data set in
Khanna et al. 2023 (arXiv 2306.11290). Doors and windows are objects like others; articulated objects are not read.
"""

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from uniteam.geometry import Point2, yaw_quaternion
from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.mesh import load_geometry
from uniteam.world.assets.model import Model
from uniteam.world.assets.reading import damaged, read_json
from uniteam.world.homes.check import OUTSIDE, home_problems
from uniteam.world.homes.home import Home, Instance, Room, Stage
from uniteam.world.homes.readers.categories import read_categories
from uniteam.world.homes.readers.habitat_frame import from_wxyz, is_upright, point_to_world
from uniteam.world.homes.readers.hssd_models import SUFFIX, ModelReader
from uniteam.world.homes.readers.hssd_rooms import ceiling_height, read_regions, rooms_of
from uniteam.world.homes.readers.hssd_schema import ObjectInstance, SceneInstance, StageConfig, StageInstance

SCENE_SUFFIX = ".scene_instance.json"
MODELS_CSV = Path("semantics/objects.csv")

_WHAT = "the scene instance"


@dataclass(frozen=True)
class HssdScene:
    """A scene without small objects.

    Attributes:
        name: its id.
        stage: rooms, and the mesh of walls, floors and ceilings.
        furniture: what stands there, named "<model>_:0000" as the simulator does.
        models: of the furniture, by id.
        left_out: names of instances that stand more than ten metres outside of the rooms.
    """

    name: str
    stage: Stage
    furniture: tuple[Instance, ...]
    models: Mapping[str, Model]
    left_out: tuple[str, ...] = ()

    def room_at(self, x: float, y: float) -> str:
        """Return the name of the room that holds a point (m, world), or of the nearest."""
        rooms = self.stage.rooms
        return next((room for room in rooms if room.contains(x, y)), min(rooms, key=lambda r: _gap(r, x, y))).name


def read_hssd_home(path: Path) -> Home:
    """Return the home of a `*.scene_instance.json`, which lies in a folder of HSSD's own; no small objects are in it.

    Raises:
        DamagedFileError: the file, or one that it names, is missing or cannot be read; or it is no home.
        UnavailableError: the extra `hssd` is not installed; raised once textures are looked at.
    """
    root = path.resolve().parent.parent
    scene = read_scene(path, ModelReader(object_configs(root / "objects"), read_categories(root / MODELS_CSV)))
    return home_of(scene, scene.name, (), {}, path)


def home_of(
    scene: HssdScene, name: str, objects: Sequence[Instance], models: Mapping[str, Model], source: Path
) -> Home:
    """Return a scene with small objects as a home with a library of its own.

    Args:
        scene: stage and furniture.
        name: of the home.
        objects: that lie in it.
        models: of the objects, by id.
        source: the file to blame.

    Raises:
        DamagedFileError: it is no sound home; the sentence says why.
    """
    home = Home(name, scene.stage, (*scene.furniture, *objects), Catalogue({**scene.models, **models}, frozenset()))
    problem = next(home_problems(home), None)
    if problem is not None:
        raise damaged(source, "the home of", problem)
    return home


@lru_cache(maxsize=16)
def object_configs(folder: Path) -> Mapping[str, Path]:
    """Return the object configs below a folder by their names without the ending; the first of two that share one."""
    paths = sorted(folder.rglob(f"*{SUFFIX}"), reverse=True)
    return {path.name.removesuffix(SUFFIX): path for path in paths}


def read_scene(path: Path, models: ModelReader) -> HssdScene:
    """Return the scene of a `*.scene_instance.json`.

    Raises:
        DamagedFileError: the file, or one that it names, is missing or cannot be read.
    """
    content = read_json(path, _WHAT, SceneInstance)
    name, root = path.name.removesuffix(SCENE_SUFFIX), path.resolve().parent.parent
    mesh_path = _stage_mesh(root, content.stage_instance, path)
    mesh = load_geometry(mesh_path)
    regions = read_regions(root / "semantics" / "scenes" / f"{name}.semantic_config.json")
    ceiling = ceiling_height(regions, mesh)
    stage = Stage(rooms_of(regions, mesh, ceiling), (), ceiling, mesh_path)
    bare = HssdScene(name, stage, (), {})
    counts: Counter[str] = Counter()
    furniture, own, left_out = [], {}, []
    for entry in content.object_instances:
        template = model_name(entry.template_name)
        number = counts[template]
        counts[template] += 1
        instance, model = _placed(f"{template}_:{number:04d}", entry, content.translation_origin, bare, models)
        if _is_near(stage, instance.position[:2]):
            furniture.append(instance)
            own[model.id] = model
        else:
            left_out.append(instance.name)
    return HssdScene(name, stage, tuple(furniture), own, tuple(left_out))


def model_name(template: str) -> str:
    """Return the name of an object config that a template's name or path stands for."""
    return template.replace("\\", "/").rpartition("/")[2].removesuffix(SUFFIX)


def _stage_mesh(root: Path, stage: StageInstance, scene: Path) -> Path:
    moved = not np.allclose(stage.translation, 0.0, atol=1e-6) or not np.allclose(stage.rotation[1:], 0.0, atol=1e-6)
    if moved:
        raise damaged(scene, _WHAT, "its stage does not stand at the origin, which is not read")
    config = root / f"{stage.template_name}.stage_config.json"
    if config.exists():
        return (config.parent / read_json(config, "the stage config", StageConfig).render_asset).resolve()
    return root / f"{stage.template_name}.glb"


def _placed(
    name: str, entry: ObjectInstance, origin: str, scene: HssdScene, models: ModelReader
) -> tuple[Instance, Model]:
    """Return an instance of furniture and its model; what of its rotation is not about z goes into the model."""
    rotation = from_wxyz(entry.rotation)
    upright = is_upright(rotation)
    sx, sy, sz = entry.non_uniform_scale or (1.0, 1.0, 1.0)
    stretch = (sx * entry.uniform_scale, sy * entry.uniform_scale, sz * entry.uniform_scale)
    placed = models.furniture(model_name(entry.template_name), stretch, np.eye(3) if upright else rotation)
    turn = rotation if upright else np.eye(3)
    offset = placed.origin
    if (entry.translation_origin or origin).lower() == "com":
        offset = placed.origin - placed.center_of_mass
    x, y, z = (point_to_world(entry.translation) + turn @ offset).tolist()
    yaw = math.atan2(turn[1, 0], turn[0, 0])
    model = placed.model
    room = scene.room_at(x, y)
    return Instance(name, model.id, model.category, False, (x, y, z), yaw_quaternion(yaw), room), model


def _is_near(stage: Stage, point: Point2) -> bool:
    around = stage.rooms[-1]
    return _gap(around, *point) <= OUTSIDE


def _gap(room: Room, x: float, y: float) -> float:
    """Return how far (m) a point is outside of the rectangle around a room; 0 within."""
    (x0, y0), (x1, y1) = room.low, room.high
    return math.hypot(max(x0 - x, x - x1, 0.0), max(y0 - y, y - y1, 0.0))
