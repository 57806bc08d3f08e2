"""Homes as plain JSON data, and as files of their own.

A home's data names files (a library, a mesh) by their paths from the folder in which it stands, so that the folder can
be moved. The fields are those of `schema`.
"""

import json
import os
from dataclasses import asdict
from hashlib import sha256
from pathlib import Path, PurePosixPath
from typing import Any

import msgspec

from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.files import write_whole
from uniteam.world.assets.catalogue import Catalogue, load_catalogue, load_library
from uniteam.world.assets.reading import PACK_DIRECTORY, read_bytes, read_json
from uniteam.world.homes.check import home_problems
from uniteam.world.homes.home import Home, Instance, Light, Opening, Room, Stage, Wall
from uniteam.world.homes.polygon import Polygon, as_rectangle, rectangle
from uniteam.world.homes.schema import HomeData, InstanceData, RoomData, StageData, WallData

HERE = Path()
"""The present working directory."""


def home_to_data(home: Home, folder: Path = HERE) -> dict[str, Any]:
    """Return a home as plain JSON data that stands in a file in `folder`; the same home gives the same data.

    Raises:
        InvalidInputError: the home's library was made in memory, so that no data can name it.
    """
    data = _plain(home)
    if home.stage.mesh is not None:
        data["stage"]["mesh"] = _relative(home.stage.mesh, folder)
    if home.library.folder is None:
        raise InvalidInputError(
            f"the library of home '{home.name}' lies in no folder; write its catalogue.json and use load_library"
        )
    if home.library.folder != PACK_DIRECTORY:
        data["library"] = _relative(home.library.folder, folder)
    return data


def home_from_data(data: object, folder: Path = HERE) -> Home:
    """Return the home that data says, which stands in a file in `folder`.

    Raises:
        DamagedFileError: the data is no home, or names what there is not; the sentence names the home and the field.
    """
    name = data.get("name") if isinstance(data, dict) else None
    try:
        parsed = msgspec.convert(data, HomeData)
    except (msgspec.ValidationError, RecursionError) as error:
        raise _wrong(name, str(error)) from error
    library = load_catalogue() if parsed.library is None else load_library(folder / _inner(parsed.name, parsed.library))
    home = _home(parsed, library, folder)
    problem = next(home_problems(home), None)
    if problem is not None:
        raise _wrong(parsed.name, problem)
    return home


def check_home(home: Home) -> None:
    """Raise InvalidInputError where a home that a program made is not one that data could say; it names the field."""
    try:
        msgspec.convert(json.loads(json.dumps(_plain(home))), HomeData)
    except (msgspec.ValidationError, TypeError, ValueError) as error:
        raise InvalidInputError(f"home '{home.name}' cannot be used: {_field(str(error))}") from error
    problem = next(home_problems(home), None)
    if problem is not None:
        raise InvalidInputError(f"home '{home.name}' cannot be used: {problem}")


def read_home(path: Path) -> Home:
    """Return the home in a JSON file; raises DamagedFileError."""
    return home_from_data(read_json(path, "the home", dict[str, Any]), path.parent)


def write_home(home: Home, path: Path) -> None:
    """Write a home into a JSON file of its own; raises InvalidInputError, UnwritableError."""
    text = json.dumps(home_to_data(home, path.parent), separators=(",", ":")) + "\n"
    write_whole(path, text.encode())


def home_digest(home: Home) -> str:
    """Return a SHA-256 of all of a home that results depend on: its data, its library, and its stage's mesh."""
    mesh = b"" if home.stage.mesh is None else read_bytes(home.stage.mesh, "the model")
    parts = (json.dumps(_plain(home)), home.library.digest, sha256(mesh).hexdigest())
    return sha256(repr(parts).encode()).hexdigest()


def _plain(home: Home) -> dict[str, Any]:
    """Return a home's data but for the files that it names."""
    stage = home.stage
    return {
        "name": home.name,
        "stage": {
            "rooms": [_room_data(room) for room in stage.rooms],
            "walls": [asdict(wall) for wall in stage.walls],
            "ceiling_height": stage.ceiling_height,
        },
        "instances": [asdict(instance) for instance in home.instances],
        "seed": home.seed,
    }


def _room_data(room: Room) -> dict[str, Any]:
    corners = as_rectangle(room.outline)
    shape = {"outline": room.outline} if corners is None else {"low": corners[0], "high": corners[1]}
    rest = asdict(room)
    del rest["outline"]
    return {"name": rest.pop("name"), "kind": rest.pop("kind"), **shape, **rest}


def _relative(path: Path, folder: Path) -> str:
    return Path(os.path.relpath(path.resolve(), folder.resolve())).as_posix()


def _inner(name: str, path: str) -> Path:
    """Return a path that data names, relative as it must be; raises DamagedFileError."""
    if PurePosixPath(path).is_absolute() or Path(path).is_absolute():
        raise _wrong(name, f"the path '{path}' must lead from the folder of the home's own file")
    return Path(path)


def _wrong(name: object, reason: str) -> DamagedFileError:
    called = f"home {name[:100]!r}" if isinstance(name, str) else "a home without a name"
    return DamagedFileError(f"{called} cannot be used: {_field(reason)}; mend its data or write it anew")


def _field(reason: str) -> str:
    """Return msgspec's sentence with the field's plain path."""
    return reason.replace("`$.", "`")


def _home(data: HomeData, library: Catalogue, folder: Path) -> Home:
    instances = tuple(_instance(instance) for instance in data.instances)
    return Home(data.name, _stage(data.name, data.stage, folder), instances, library, data.seed)


def _stage(name: str, data: StageData, folder: Path) -> Stage:
    rooms = tuple(_room(name, room) for room in data.rooms)
    mesh = None if data.mesh is None else (folder / _inner(name, data.mesh)).resolve()
    return Stage(rooms, tuple(_wall(wall) for wall in data.walls), data.ceiling_height, mesh)


def _room(home: str, data: RoomData) -> Room:
    light = Light(data.light.position, data.light.color, data.light.ambient)
    outline = _outline(home, data)
    return Room(data.name, data.kind, outline, data.floor_texture, data.wall_texture, data.wall_tint, light)


def _outline(home: str, data: RoomData) -> Polygon:
    if data.outline is not None and data.low is None and data.high is None:
        return data.outline
    if data.outline is not None or data.low is None or data.high is None:
        raise _wrong(home, f"room '{data.name}': it needs either an outline, or low and high")
    if data.low[0] >= data.high[0] or data.low[1] >= data.high[1]:
        raise _wrong(home, f"room '{data.name}': low must be below and left of high")
    return rectangle(data.low, data.high)


def _wall(data: WallData) -> Wall:
    openings = tuple(Opening(o.kind, o.start, o.end, o.bottom, o.top) for o in data.openings)
    return Wall(data.start, data.end, data.thickness, openings)


def _instance(data: InstanceData) -> Instance:
    return Instance(**msgspec.structs.asdict(data))
