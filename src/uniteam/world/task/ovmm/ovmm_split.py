"""A split of the challenge's files: its homes, and its episodes as they are played here.

An episode that does not fit its home, such as one whose goal nobody can see, is left out and said; a file that is
missing or damaged ends the reading.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from zlib import crc32

from uniteam.errors import DamagedFileError
from uniteam.geometry import BasePose, Point2
from uniteam.interface import Instruction
from uniteam.world.homes.home import Home
from uniteam.world.homes.readers.categories import clean
from uniteam.world.homes.readers.habitat_frame import Heading, point_to_world
from uniteam.world.homes.readers.hssd_scene import SCENE_SUFFIX, model_name
from uniteam.world.task.check_episode import episode_problems
from uniteam.world.task.episode import Candidate, Episode, Split
from uniteam.world.task.ovmm.episode_file import EPISODES, Goal, OvmmEpisode, OvmmFiles, read_ovmm_files
from uniteam.world.task.ovmm.layout import find_data
from uniteam.world.task.ovmm.ovmm_homes import OvmmHomes, instance_names, object_index, parent_of


@dataclass(frozen=True)
class OvmmSplit:
    """What became of a folder of episodes.

    Attributes:
        split: the episodes that can be played, and their homes.
        left_out: by the ids of the others, why.
    """

    split: Split
    left_out: dict[str, str]


def read_ovmm_split(folder: Path, label: str, heading: Heading) -> OvmmSplit:
    """Return the split of a folder of episodes, and what is left out of it.

    Args:
        folder: holds `episodes.json.gz` and its two arrays.
        label: the split's name.
        heading: how the start's rotation is to be read.

    Raises:
        DamagedFileError: a file is missing or damaged, or no episode can be played.
    """
    files = read_ovmm_files(folder)
    if not files.episodes:
        raise DamagedFileError(f"{folder / EPISODES} holds no episode; download it anew")
    homes = OvmmHomes(files, find_data(folder, files.episodes[0].scene_id))
    reader = _EpisodeReader(files, homes, heading)
    episodes: dict[str, Episode] = {}
    left_out: dict[str, str] = {}
    for entry in files.episodes:
        name = episode_id(entry)
        try:
            if name in episodes or name in left_out:
                raise ValueError("its id comes twice")
            episodes[name] = reader.read(entry)
        except ValueError as error:
            left_out[name] = str(error)
    if not episodes:
        name, reason = next(iter(left_out.items()))
        raise DamagedFileError(f"no episode of {folder / EPISODES} can be played; the first, '{name}': {reason}")
    split = Split(label, tuple(episodes.values()), reader.homes)
    return OvmmSplit(split, left_out)


def episode_id(episode: OvmmEpisode) -> str:
    """Return the name of an episode, as home-robot's results have it: "<scene>_<episode>"."""
    return f"{model_name(episode.scene_id).removesuffix(SCENE_SUFFIX)}_{episode.episode_id}"


class _EpisodeReader:
    """Reads episodes one by one, and keeps the homes in which they are played."""

    def __init__(self, files: OvmmFiles, homes: OvmmHomes, heading: Heading) -> None:
        self._files, self._homes, self._heading = files, homes, heading
        self._points: dict[tuple[int, ...], tuple[Point2, ...]] = {}
        self.homes: dict[str, Home] = {}

    def read(self, entry: OvmmEpisode) -> Episode:
        """Return an episode; raises ValueError where it makes no sense in its home, DamagedFileError for a file."""
        if sum(entry.start_position) == 0.0:
            raise ValueError("it has no start of its own, and Habitat would draw one at random")
        home = self._homes.of(entry)
        names = instance_names(model_name(name) for name, _ in entry.rigid_objs)
        episode = Episode(
            id=episode_id(entry),
            home=home.name,
            start=self._start(entry),
            instruction=Instruction(
                clean(entry.object_category), clean(entry.start_recep_category), clean(entry.goal_recep_category)
            ),
            objects=tuple(Candidate(_named(names, goal), self._points_of((goal,))) for goal in entry.candidate_objects),
            start_receptacles=_start_receptacles(entry, names),
            goal_receptacles=self._goal_receptacles(entry),
            unseen=False,
            seed=crc32(entry.episode_id.encode()),
        )
        problem = next(episode_problems(episode, home), None)
        if problem is not None:
            raise ValueError(problem)
        self.homes[home.name] = home
        return episode

    def _start(self, entry: OvmmEpisode) -> BasePose:
        x, y, _ = point_to_world(entry.start_position).tolist()
        return BasePose(x, y, self._heading(entry.start_rotation))

    def _goal_receptacles(self, entry: OvmmEpisode) -> tuple[Candidate, ...]:
        """Return the furniture of the goal class, with the view points of its surfaces, which the file names."""
        by_parent: dict[str, list[Goal]] = {}
        for goal in entry.candidate_goal_receps:
            by_parent.setdefault(parent_of(goal.object_name), []).append(goal)
        return tuple(Candidate(name, self._points_of(goals)) for name, goals in by_parent.items())

    def _points_of(self, goals: Iterable[Goal]) -> tuple[Point2, ...]:
        """Return the view points of goals, each once; the same rows give the same tuple, which many episodes share."""
        goals = tuple(goals)
        rows = tuple(point for goal in goals for point in goal.view_points if isinstance(point, int))
        if rows in self._points and len(rows) == sum(len(goal.view_points) for goal in goals):
            return self._points[rows]
        points = {(float(x), float(-z)): None for goal in goals for x, _, z in self._files.seen_from(goal)}
        return self._points.setdefault(rows, tuple(points)) if rows else tuple(points)


def _named(names: tuple[str, ...], goal: Goal) -> str:
    index = object_index(goal)
    if not 0 <= index < len(names):
        raise ValueError(f"candidate_objects: '{goal.object_id}' is no index of its {len(names)} rigid objects")
    return names[index]


def _start_receptacles(entry: OvmmEpisode, names: tuple[str, ...]) -> tuple[str, ...]:
    """Return the furniture on which candidate objects lie; all of the start class where the file does not say."""
    held = [entry.name_to_receptacle.get(_named(names, goal), "") for goal in entry.candidate_objects]
    on = [parent_of(name) for name in held if name] or [parent_of(g.object_name) for g in entry.candidate_start_receps]
    return tuple(dict.fromkeys(on))
