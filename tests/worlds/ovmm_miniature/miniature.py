"""Two small homes of the pack and two certified episodes of each, as the challenge's data."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from worlds.ovmm_miniature.episode_files import OBJECTS, EpisodeFiles
from worlds.ovmm_miniature.ktx2_pictures import Ktx2Pictures
from worlds.ovmm_miniature.model_files import write_model
from worlds.ovmm_miniature.scene_files import write_scene, write_tables

from uniteam.world.homes.home import Home
from uniteam.world.task.episode import Episode
from uniteam.world.task.splits import load_split

SPLIT = "val"
EPISODES = ("test-2018-1", "test-2018-2", "test-2016-1", "test-2016-4")


@dataclass(frozen=True)
class Original:
    """What a miniature is made of.

    Attributes:
        homes: by their names.
        episodes: in the miniature's order.
    """

    homes: Mapping[str, Home]
    episodes: Sequence[Episode]


def original() -> Original:
    """Return the homes and the episodes."""
    split = load_split(SPLIT)
    by_id = {episode.id: episode for episode in split.episodes}
    episodes = [by_id[name] for name in EPISODES]
    return Original({episode.home: split.homes[episode.home] for episode in episodes}, episodes)


def write_miniature(made_of: Original, folder: Path, pictures: Ktx2Pictures) -> Path:
    """Write the data below a folder, and return the folder of its episodes."""
    data = folder / "data"
    (data / "objects").mkdir(parents=True, exist_ok=True)
    for home in made_of.homes.values():
        write_scene(home, data / "hssd-hab", pictures)
        for name in sorted({instance.model for instance in home.instances if instance.movable}):
            write_model(home.library[name], data / OBJECTS, pictures)
    write_tables(made_of.homes.values(), data)
    files = EpisodeFiles()
    for episode in made_of.episodes:
        files.add(episode, made_of.homes[episode.home])
    episodes = data / "datasets" / "ovmm" / "minival"
    files.write(episodes)
    return episodes
