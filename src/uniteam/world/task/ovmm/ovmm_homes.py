"""The homes of the challenge's episodes: a scene's furniture, and the small objects as an episode lays them out.

Habitat moves a small object's frame to its centre of mass, so that the translation of its pose is where that is.
"""

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import Model
from uniteam.world.assets.reading import damaged
from uniteam.world.homes.check import home_problems
from uniteam.world.homes.home import Home, Instance
from uniteam.world.homes.readers.categories import clean, read_categories
from uniteam.world.homes.readers.habitat_frame import point_to_world, quaternion_of, rotation_to_world
from uniteam.world.homes.readers.hssd_models import ModelReader, PlacedModel
from uniteam.world.homes.readers.hssd_scene import MODELS_CSV, HssdScene, model_name, object_configs, read_scene
from uniteam.world.task.ovmm.episode_file import Goal, OvmmEpisode, OvmmFiles
from uniteam.world.task.ovmm.layout import DataFolder


@dataclass(frozen=True)
class _OpenScene:
    """A scene with a library for all of its episodes, and the homes that were made in it by how their objects lie."""

    scene: HssdScene
    models: dict[str, Model]
    library: Catalogue
    homes: dict[object, Home]


class OvmmHomes:
    """Makes homes of episodes; episodes whose objects lie alike share one."""

    def __init__(self, files: OvmmFiles, data: DataFolder) -> None:
        """Take the episodes, whose words say what models are called, and the folder that they call `data/`."""
        self._files, self._data = files, data
        hssd = data.file(files.episodes[0].scene_id).parent.parent
        tables = [read_categories(hssd / MODELS_CSV), *(read_categories(path) for path in data.receptacle_tables())]
        tables.append(furniture_classes(files.episodes))
        told = {name: kind for table in tables for name, kind in table.items()}
        self._furniture = ModelReader(object_configs(hssd / "objects"), told)
        folders = sorted({path for episode in files.episodes for path in episode.additional_obj_config_paths})
        configs = {name: path for folder in folders for name, path in object_configs(data.file(folder)).items()}
        self._objects = ModelReader(configs, object_classes(files.episodes))
        self._scenes: dict[str, _OpenScene] = {}

    def scene(self, scene_id: str) -> HssdScene:
        """Return a scene without small objects; raises DamagedFileError."""
        return self._opened(scene_id).scene

    def of(self, episode: OvmmEpisode) -> Home:
        """Return the home of an episode.

        Raises:
            DamagedFileError: a file is missing or cannot be read, or the home is none; the sentence says which.
            ValueError: an object's pose is not to be had.
        """
        opened = self._opened(episode.scene_id)
        poses = [self._files.pose(transform) for _, transform in episode.rigid_objs]
        names = [model_name(name) for name, _ in episode.rigid_objs]
        layout = (tuple(names), np.array(poses).tobytes())
        if layout not in opened.homes:
            objects = self._lying(names, poses, opened)
            scene = opened.scene
            name = f"{scene.name}-{len(opened.homes)}"
            home = Home(name, scene.stage, (*scene.furniture, *objects), opened.library)
            problem = next(home_problems(home), None)
            if problem is not None:
                raise damaged(self._data.file(episode.scene_id), "the home of", problem)
            opened.homes[layout] = home
        return opened.homes[layout]

    def _opened(self, scene_id: str) -> _OpenScene:
        if scene_id not in self._scenes:
            scene = read_scene(self._data.file(scene_id), self._furniture)
            models = dict(scene.models)
            for name in self._objects_in(scene_id):
                model = self._objects.small_object(name).model
                models[model.id] = model
            library = Catalogue(models, frozenset())
            self._scenes[scene_id] = _OpenScene(scene, models, library, {})
        return self._scenes[scene_id]

    def _objects_in(self, scene_id: str) -> list[str]:
        episodes = (episode for episode in self._files.episodes if episode.scene_id == scene_id)
        return sorted({model_name(name) for episode in episodes for name, _ in episode.rigid_objs})

    def _lying(self, names: list[str], poses: list[NDArray[np.float64]], opened: _OpenScene) -> Iterable[Instance]:
        for name, model, pose in zip(instance_names(names), names, poses, strict=True):
            yield _lying(name, self._objects.small_object(model), pose, opened.scene)


def instance_names(models: Iterable[str]) -> tuple[str, ...]:
    """Return what the simulator calls instances of models that are added in this order: "<model>_:0000"."""
    counts: Counter[str] = Counter()
    names = []
    for model in models:
        names.append(f"{model}_:{counts[model]:04d}")
        counts[model] += 1
    return tuple(names)


def parent_of(receptacle: str) -> str:
    """Return the instance of furniture that a receptacle's unique name tells: "<instance>|<receptacle>"."""
    return receptacle.partition("|")[0].rpartition("/")[2]


def furniture_classes(episodes: Iterable[OvmmEpisode]) -> Mapping[str, str]:
    """Return the classes of furniture's models that episodes ask for; their word goes before that of a table."""
    return _most_said(
        (parent_of(goal.object_name).partition("_:")[0], category)
        for episode in episodes
        for goals, category in (
            (episode.candidate_start_receps, episode.start_recep_category),
            (episode.candidate_goal_receps, episode.goal_recep_category),
        )
        for goal in goals
    )


def object_classes(episodes: Iterable[OvmmEpisode]) -> Mapping[str, str]:
    """Return the classes of small objects' models that episodes ask for; of others the files say nothing."""
    return _most_said(
        (model_name(episode.rigid_objs[index][0]), episode.object_category)
        for episode in episodes
        for index in map(object_index, episode.candidate_objects)
        if 0 <= index < len(episode.rigid_objs)
    )


def _most_said(words: Iterable[tuple[str, str]]) -> Mapping[str, str]:
    """Return for each model the class that most episodes give it, the first of those that as many do."""
    counts: dict[str, Counter[str]] = {}
    for model, category in words:
        counts.setdefault(model, Counter())[clean(category)] += 1
    return {model: count.most_common(1)[0][0] for model, count in counts.items()}


def object_index(goal: Goal) -> int:
    """Return the index of a candidate object in `rigid_objs`; -1 where it has none."""
    return int(goal.object_id) if goal.object_id.isdecimal() else -1


def _lying(name: str, placed: PlacedModel, pose: NDArray[np.float64], scene: HssdScene) -> Instance:
    rotation = rotation_to_world(pose[:, :3])
    x, y, z = (point_to_world(pose[:, 3]) + rotation @ (placed.origin - placed.center_of_mass)).tolist()
    model = placed.model
    return Instance(name, model.id, model.category, True, (x, y, z), quaternion_of(rotation), scene.room_at(x, y))
