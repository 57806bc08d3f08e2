"""Certified episodes of ours as the challenge's: `episodes.json.gz` with its two arrays."""

import gzip
import json
import math
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from worlds.ovmm_miniature.model_files import file_frame, model_hash
from worlds.ovmm_miniature.scene_files import CONFIG, SCENES, floor_point, handles

from uniteam.geometry import BasePose
from uniteam.world.assets.mesh import load_model_mesh
from uniteam.world.homes.home import Home, Instance
from uniteam.world.task.episode import Candidate, Episode

OBJECTS = "objects/train_val/uniteam/configs/objects"
_TO_HABITAT = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])


class EpisodeFiles:
    """Gathers episodes and the rows of the arrays to which they point."""

    def __init__(self) -> None:
        self._episodes: list[dict[str, Any]] = []
        self._transformations: list[NDArray[np.float64]] = []
        self._view_points: list[list[float]] = []

    def add(self, episode: Episode, home: Home) -> None:
        """Add an episode."""
        number, names = len(self._episodes), handles(home)
        objects = [instance for instance in home.instances if instance.movable]
        index = {instance.name: k for k, instance in enumerate(objects)}
        goals = [self._goal(home, candidate, str(index[candidate.name])) for candidate in episode.objects]
        for goal, candidate in zip(goals, episode.objects, strict=True):
            goal["object_name"] = f"{model_hash(home.model_of(home.by_name[candidate.name]))}.object_config.json"
        instruction = episode.instruction
        self._episodes.append(
            {
                "episode_id": str(number),
                "scene_id": f"data/hssd-hab/{SCENES}/{home.name}.scene_instance.json",
                "scene_dataset_config": f"data/hssd-hab/{CONFIG}",
                "additional_obj_config_paths": [f"data/{OBJECTS}"],
                "start_position": floor_point((episode.start.x, episode.start.y)),
                "start_rotation": start_rotation(episode.start),
                "ao_states": {},
                "rigid_objs": [self._rigid_object(home, instance) for instance in objects],
                "targets": {},
                "target_receptacles": [],
                "goal_receptacles": [],
                "markers": [],
                "name_to_receptacle": _held_by(episode, home, names),
                "info": {"object_labels": {}},
                "object_category": instruction.object_category.replace("_", " "),
                "start_recep_category": instruction.start_receptacle,
                "goal_recep_category": instruction.goal_receptacle,
                "candidate_objects": goals,
                "candidate_objects_hard": [],
                "candidate_start_receps": [_surface(names[name], 0) for name in episode.start_receptacles],
                "candidate_goal_receps": list(self._surfaces(home, episode.goal_receptacles, names)),
                "goals": [],
                "shortest_paths": None,
            }
        )

    def write(self, folder: Path) -> None:
        """Write the three files."""
        folder.mkdir(parents=True, exist_ok=True)
        classes = sorted({episode["object_category"] for episode in self._episodes})
        content = {"episodes": self._episodes, "obj_category_to_obj_category_id": {n: k for k, n in enumerate(classes)}}
        (folder / "episodes.json.gz").write_bytes(gzip.compress(json.dumps(content).encode(), mtime=0))
        np.save(folder / "transformations.npy", np.array(self._transformations))
        np.save(folder / "viewpoints.npy", np.array(self._view_points))

    def _rigid_object(self, home: Home, instance: Instance) -> tuple[str, int]:
        model = home.model_of(instance)
        frame, pose = file_frame(model), instance.model_to_world()
        center = frame.center_of_mass
        if center is None:
            vertices = load_model_mesh(model).vertices
            center = (vertices.min(axis=0) + vertices.max(axis=0)) / 2 + frame.shift
        at = pose[:3, 3] + pose[:3, :3] @ (center - frame.shift)
        rotation = _TO_HABITAT @ pose[:3, :3] @ _TO_HABITAT.T
        self._transformations.append(np.column_stack([rotation, _TO_HABITAT @ at]))
        return f"{model_hash(model)}.object_config.json", len(self._transformations) - 1

    def _goal(self, home: Home, candidate: Candidate, identifier: str) -> dict[str, Any]:
        x, y, z = home.by_name[candidate.name].position
        first = len(self._view_points)
        for at in candidate.view_points:
            turn = math.atan2(at[0] - x, y - at[1])  # habitat's agent looks along -z
            self._view_points.append([*floor_point(at), 0.0, math.sin(turn / 2), 0.0, math.cos(turn / 2), 0.1])
        rows = list(range(first, len(self._view_points)))
        return {"object_id": identifier, "position": [x, z, -y], "radius": None, "room_id": None, "view_points": rows}

    def _surfaces(self, home: Home, candidates: Iterable[Candidate], names: dict[str, str]) -> Iterable[dict[str, Any]]:
        """Yield an entry for each surface of furniture; the view points are dealt out among them."""
        for candidate in candidates:
            goal = self._goal(home, candidate, "7")
            count = max(1, len(home.model_of(home.by_name[candidate.name]).surfaces))
            for number in range(count):
                rows = goal["view_points"][number::count]
                yield {**goal, **_surface(names[candidate.name], number), "view_points": rows}


def start_rotation(start: BasePose) -> list[float]:
    """Return the quaternion (x, y, z, w) that the task reads as a start's heading: its yaw is the negative of it."""
    turn = -start.heading
    return [0.0, math.sin(turn / 2), 0.0, math.cos(turn / 2)]


def _surface(handle: str, number: int) -> dict[str, Any]:
    return {"object_id": "7", "object_name": f"{handle}|receptacle_mesh_{handle.partition('_:')[0]}.{number:04d}"}


def _held_by(episode: Episode, home: Home, names: dict[str, str]) -> dict[str, str]:
    """Return the receptacle below each candidate object: the nearest of the start class."""

    def nearest(name: str, receptacles: Sequence[str]) -> str:
        at = home.by_name[name].position
        return min(receptacles, key=lambda other: math.dist(at[:2], home.by_name[other].position[:2]))

    below = {c.name: nearest(c.name, episode.start_receptacles) for c in episode.objects}
    return {names[name]: _surface(names[other], 0)["object_name"] for name, other in below.items()}
