"""Whether a folder of the challenge's data can be played: what is there, missing, what it costs, what is odd."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from uniteam.errors import UniteamError
from uniteam.stretch import BASE_RADIUS
from uniteam.world.assets.mesh_cost import mesh_cost
from uniteam.world.homes.home import Home
from uniteam.world.homes.readers.hssd_rooms import BETWEEN
from uniteam.world.homes.readers.hssd_scene import MODELS_CSV, SCENE_SUFFIX
from uniteam.world.physics.navigable_floor import NavigableFloor
from uniteam.world.task.episode import Episode, Split
from uniteam.world.task.ovmm.episode_file import EPISODES, FILES, OvmmFiles, read_ovmm_files
from uniteam.world.task.ovmm.layout import DataFolder, find_data
from uniteam.world.task.ovmm.ovmm_name import OvmmName
from uniteam.world.task.ovmm.ovmm_split import OvmmSplit

Kind = Literal["there", "missing", "cost", "odd"]


@dataclass(frozen=True)
class Finding:
    """One thing that was found.

    Attributes:
        kind: "there", "missing", "cost" (in memory), or "odd": it does not fit, or cannot be told.
        sentence: about it.
        is_fatal: whether nothing can be played as long as it is so.
    """

    kind: Kind
    sentence: str
    is_fatal: bool = False


def episode_folders(folder: Path) -> list[Path]:
    """Return the folders of episodes in or below a folder."""
    return [folder] if (folder / EPISODES).is_file() else sorted(p.parent for p in folder.rglob(EPISODES))


def check_episodes(folder: Path) -> Iterator[Finding]:
    """Yield what is found of a folder of episodes; it ends with the first thing for which nothing can be played."""
    try:
        files = read_ovmm_files(folder)
        yield _files(files)
        yield from _missing_arrays(files)
        data = find_data(folder, files.episodes[0].scene_id)
        missing = list(_missing_scenes(files, data))
        yield from missing
        yield from _tables(files, data)
        if not missing:
            yield from _split(OvmmName("ovmm", folder).read())
    except UniteamError as error:
        yield Finding("odd", str(error), is_fatal=True)
    except IndexError:
        yield Finding("odd", f"{folder / EPISODES} holds no episode.", is_fatal=True)


def _files(files: OvmmFiles) -> Finding:
    megabytes = sum((files.folder / name).stat().st_size for name in FILES if (files.folder / name).exists()) / 1e6
    scenes = len({episode.scene_id for episode in files.episodes})
    rows = f"{len(files.view_points)} view points and {len(files.transformations)} poses"
    return Finding("there", f"{len(files.episodes)} episodes in {scenes} scenes, with {rows} ({megabytes:.1f} MB).")


def _missing_arrays(files: OvmmFiles) -> Iterator[Finding]:
    for name in FILES:
        if not (files.folder / name).exists():
            yield Finding("missing", f"{name}: episodes that point to its rows cannot be played.")


def _missing_scenes(files: OvmmFiles, data: DataFolder) -> Iterator[Finding]:
    named = sorted({episode.scene_id for episode in files.episodes})
    absent = [scene for scene in named if not data.file(scene).is_file()]
    yield from _some("missing", "scenes", absent, len(named), data)
    folders = sorted({path for episode in files.episodes for path in episode.additional_obj_config_paths})
    lacking = [path for path in folders if not data.file(path).is_dir()]
    yield from _some("missing", "folders of small objects", lacking, len(folders), data)


def _some(kind: Kind, what: str, absent: list[str], count: int, data: DataFolder) -> Iterator[Finding]:
    if absent:
        yield Finding(kind, f"{len(absent)} of {count} {what}; the first is {data.file(absent[0])}.", is_fatal=True)


def _tables(files: OvmmFiles, data: DataFolder) -> Iterator[Finding]:
    scenes = sorted({episode.scene_id for episode in files.episodes})
    hssd = data.file(scenes[0]).parent.parent
    if not (hssd / MODELS_CSV).exists():
        yield Finding("missing", f"{hssd / MODELS_CSV}: furniture that no episode asks for is called a thing.")
    if not data.receptacle_tables():
        yield Finding("missing", "hssd-receptacles.csv: receptacles are those that episodes or objects.csv name.")
    names = [data.file(scene).name.removesuffix(SCENE_SUFFIX) for scene in scenes]
    bare = [n for n in names if not (hssd / "semantics" / "scenes" / f"{n}.semantic_config.json").exists()]
    if bare:
        yield Finding("missing", f"the rooms of {len(bare)} scenes, such as {bare[0]}: each is one room to us.")


def _split(read: OvmmSplit) -> Iterator[Finding]:
    split = read.split
    yield Finding("there", f"{len(split.episodes)} episodes that can be played, in {len(split.homes)} homes.")
    if read.left_out:
        name, reason = next(iter(read.left_out.items()))
        yield Finding("odd", f"{len(read.left_out)} episodes are left out; the first, {name}: {reason}.")
    yield _cost(split.homes.values())
    yield from _starts(split)
    yield from _classes(split.homes.values())
    yield Finding(
        "odd",
        "nothing in the files tells the sign of a start's heading: ovmm: reads it as the challenge's task does, "
        "ovmm-as-written: as the quaternion says.",
    )


def _cost(homes: Iterable[Home]) -> Finding:
    """Say what the dearest home takes in memory, of which a worker keeps one."""
    known: dict[Path, int] = {}

    def of(path: Path) -> int:
        if path not in known:
            known[path] = mesh_cost(path).in_memory
        return known[path]

    costs = {}
    for home in homes:
        models = {home.model_of(instance).path for instance in home.instances}
        costs[home.name] = sum(of(path) for path in (*models, home.stage.mesh) if path is not None)
    name = max(costs, key=costs.__getitem__)
    return Finding(
        "cost",
        f"models and textures take about {costs[name] / 1e6:.0f} MB for the largest home, {name}, in each worker.",
    )


def _starts(split: Split) -> Iterator[Finding]:
    """Yield how many starts our floor does not know, from the obstacles as we read them."""
    floors = {name: NavigableFloor(home) for name, home in split.homes.items()}
    blocked = [e.id for e in split.episodes if floors[e.home].clearance(e.start.x, e.start.y) < BASE_RADIUS]
    if blocked:
        count = f"{len(blocked)} of {len(split.episodes)} episodes"
        yield Finding("odd", f"in {count} the robot would start in something; the first is {blocked[0]}.")
    apart = [e.id for e in split.episodes if e.id not in blocked and not _is_connected(e, floors[e.home])]
    if apart:
        count = f"{len(apart)} of {len(split.episodes)} episodes"
        yield Finding("odd", f"{count} start apart from the largest free floor; the first is {apart[0]}.")


def _is_connected(episode: Episode, floor: NavigableFloor) -> bool:
    return bool(floor.largest_component[floor.to_cell(episode.start.x, episode.start.y)])


def _classes(homes: Iterable[Home]) -> Iterator[Finding]:
    homes = tuple(homes)
    for what, movable in (("small objects", True), ("pieces of furniture", False)):
        models = {i.model: i.category for home in homes for i in home.instances if i.movable == movable}
        unnamed = [name for name, category in models.items() if category == "thing"]
        if unnamed:
            count = f"{len(unnamed)} of {len(models)} models of {what}"
            yield Finding("odd", f"{count} have no class, and are called things.")
    roomless = [home.name for home in homes if [room.name for room in home.stage.rooms] == [BETWEEN]]
    if roomless:
        yield Finding("odd", f"{len(roomless)} homes have no room with a name, such as {roomless[0]}.")
