"""Homes as data: the same bytes for the same home, and one sentence for every nonsense."""

import copy
import gzip
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from worlds.camera_scenes import two_rooms
from worlds.small_home import CUP, instance, small_home

from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.homes.home import Home, Instance
from uniteam.world.homes.serialization import (
    check_home,
    home_digest,
    home_from_data,
    home_to_data,
    read_home,
    write_home,
)
from uniteam.world.task.splits import SPLIT_DIRECTORY, SPLIT_NAMES, SUFFIX, load_split, write_split


def furnished() -> Home:
    model = load_catalogue().of_category("table")[0]
    return two_rooms(Instance("table_1", model.id, "table", False, (2.0, 2.0, 0.0), (1.0, 0.0, 0.0, 0.0), "west"))


def data_of(home: Home) -> dict[str, Any]:
    plain: dict[str, Any] = json.loads(json.dumps(home_to_data(home)))
    return plain


@pytest.mark.parametrize("name", SPLIT_NAMES)
def test_the_built_in_splits_are_read_and_written_back_to_the_byte(name: str, tmp_path: Path) -> None:
    path = tmp_path / f"{name}{SUFFIX}"
    write_split(load_split(name), path)
    built_in = (SPLIT_DIRECTORY / f"{name}{SUFFIX}").read_bytes()
    assert gzip.decompress(path.read_bytes()) == gzip.decompress(built_in)


def test_a_rectangle_is_written_by_two_corners_and_another_room_by_its_outline() -> None:
    home = furnished()
    west, east = home.stage.rooms
    cut = replace(east, outline=(*east.outline[:3], (5.0, 4.0), (4.0, 3.0)))
    changed = replace(home, stage=replace(home.stage, rooms=(west, cut)))
    first, second = data_of(changed)["stage"]["rooms"]
    assert (first["low"], first["high"], "outline" in first) == ([0.0, 0.0], [4.0, 4.0], False)
    assert ("low" in second, second["outline"][-1]) == (False, [4.0, 3.0])
    assert home_from_data(data_of(changed)) == changed


def test_a_home_of_the_pack_names_no_library_and_no_mesh() -> None:
    data = data_of(furnished())
    assert list(data) == ["name", "stage", "instances", "seed"]
    assert list(data["stage"]) == ["rooms", "walls", "ceiling_height"]


def test_a_home_of_a_library_made_in_memory_cannot_be_written() -> None:
    with pytest.raises(InvalidInputError, match="the library of home 'small' lies in no folder"):
        home_to_data(small_home(instance("cup_1", CUP, 1.0, 1.0)))


def test_a_home_comes_back_from_a_file_of_its_own(tmp_path: Path) -> None:
    write_home(furnished(), tmp_path / "home.json")
    assert read_home(tmp_path / "home.json") == furnished()


def test_homes_that_differ_in_anything_have_digests_that_differ() -> None:
    home = furnished()
    moved = replace(home.instances[0], position=(2.0, 2.001, 0.0))
    others = [
        replace(home, name="other"),
        replace(home, instances=(moved,)),
        replace(home, stage=replace(home.stage, walls=home.stage.walls[1:])),
        replace(home, library=replace(home.library, unseen_categories=frozenset())),
    ]
    assert len({home_digest(h) for h in (home, *others)}) == 5
    assert home_digest(furnished()) == home_digest(home)


def changed(**changes: Any) -> dict[str, Any]:
    """Return a home's data changed at paths whose parts two underscores join."""
    data = copy.deepcopy(data_of(furnished()))
    for path, value in changes.items():
        *way, key = (int(step) if step.isdigit() else step for step in path.split("__"))
        owner: Any = data
        for step in way:
            owner = owner[step]
        owner[key] = value
    return data


ROOM = "stage__rooms__0__"
WALL = "stage__walls__4__"
THING = "instances__0__"


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (None, "Expected `object`, got `null`"),
        ({}, "missing required field `name`"),
        (changed(seed=-1), "`seed`"),
        (changed(seed=1.5), "`seed`"),
        (changed(colour="red"), "unknown field `colour`"),
        (changed(stage__rooms=[]), "`stage.rooms`"),
        (changed(stage__ceiling_height="2.5"), "Expected `float`, got `str` - at `stage.ceiling_height`"),
        (changed(stage__ceiling_height=float("nan")), "`stage.ceiling_height`"),
        (changed(**{ROOM + "name": "../west"}), r"`stage.rooms\[0\].name`"),
        (changed(**{ROOM + "name": "east"}), "two are named room 'east'"),
        (changed(**{ROOM + "low": [4.0, 0.0]}), "room 'west': low must be below and left of high"),
        (changed(**{ROOM + "low": [-400.0, 0.0]}), "its rooms reach over 408 m, more than 100 m"),
        (changed(**{ROOM + "low": [-1e6, 0.0]}), r"`stage.rooms\[0\].low\[0\]`"),
        (
            changed(**{ROOM + "outline": [[0, 0], [1, 0], [1, 1]]}),
            "room 'west': it needs either an outline, or low",
        ),
        (changed(**{ROOM + "floor_texture": "plank_oak"}), "room 'west': unknown texture 'plank_oak': did you mean"),
        (changed(**{ROOM + "wall_tint": [1.0, 1.0, 2.0]}), r"`stage.rooms\[0\].wall_tint\[2\]`"),
        (changed(**{WALL + "end": [4.0, 0.0]}), "wall 4: it is shorter than a centimetre"),
        (changed(**{WALL + "openings__0__end": 9.0}), "wall 4: its door does not lie within it"),
        (changed(**{WALL + "openings__0__kind": "gate"}), "Invalid enum value 'gate'"),
        (changed(**{THING + "model": "tabel_et_table"}), "instance 'table_1': unknown model 'tabel_et_table'"),
        (changed(**{THING + "category": "sink"}), "its category is 'sink', but 'table' that of its model"),
        (changed(**{THING + "room": "north"}), "it stands in room 'north', which there is not"),
        (changed(**{THING + "position": [90.0, 2.0, 0.0]}), "more than 10 m away from the rooms"),
        (changed(**{THING + "quaternion": [1.0, 1.0, 0.0, 0.0]}), "its quaternion is not of unit length"),
        (changed(**{THING + "quaternion": [0.8, 0.6, 0.0, 0.0]}), "a receptacle must stand upright"),
        (changed(**{THING + "name": "wall_0"}), "its name is one that the stage or the robot has"),
        (changed(**{THING + "name": "a\x1b[2J"}), r"`instances\[0\].name`"),
        (changed(instances=2 * data_of(furnished())["instances"]), "two are named instance 'table_1'"),
        (changed(instances=2001 * data_of(furnished())["instances"]), "length <= 2000"),
        (changed(stage__mesh="nothing.glb"), r"nothing\.glb cannot be read"),
        (changed(stage__mesh="/etc/passwd"), "the path '/etc/passwd' must lead from the folder"),
        (changed(library="nowhere"), r"nowhere/catalogue\.json cannot be read"),
        (changed(library="/"), "the path '/' must lead from the folder"),
    ],
)
def test_nonsense_is_answered_with_the_home_and_the_field(data: Any, reason: str) -> None:
    with pytest.raises(DamagedFileError, match=reason):
        home_from_data(data)


@pytest.mark.parametrize(
    ("outline", "reason"),
    [
        (((0.0, 0.0), (0.0, 4.0), (4.0, 4.0)), "clockwise or holds less than"),
        (((0.0, 0.0), (4.0, 4.0), (4.0, 0.0), (0.0, 4.0)), "crosses or touches itself"),
        (((0.0, 0.0), (0.1, 0.0), (0.1, 0.1)), "clockwise or holds less than"),
        (((0.0, 0.0), (float("nan"), 0.0), (4.0, 4.0)), r"outline\[1\]\[0\]"),
    ],
)
def test_a_home_made_by_a_program_is_checked_as_data_is(outline: Any, reason: str) -> None:
    home = furnished()
    room = replace(home.stage.rooms[0], outline=outline)
    with pytest.raises(InvalidInputError, match=reason):
        check_home(replace(home, stage=replace(home.stage, rooms=(room, home.stage.rooms[1]))))


def test_a_file_that_is_no_home_is_named(tmp_path: Path) -> None:
    path = tmp_path / "home.json"
    for content in (b"", b"[1, 2]", b"[" * 100_000, b"\xff", b'{"name": "x"}'):
        path.write_bytes(content)
        with pytest.raises(DamagedFileError, match=r"home\.json|home 'x'"):
            read_home(path)


def test_a_file_in_which_a_field_comes_twice_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "home.json"
    write_home(furnished(), path)
    path.write_text(path.read_text().replace('"movable":', '"movable":true,"movable":', 1))
    with pytest.raises(DamagedFileError, match=r"home\.json cannot be read \(the field 'movable' comes twice\)"):
        read_home(path)
