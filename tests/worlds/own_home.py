"""An L-shaped room with a mesh for a stage, furnished from a folder of glTF files outside of the package."""

import json
import math
from itertools import pairwise
from pathlib import Path

from worlds.glb import box, upright, write_glb

from uniteam.world.assets.catalogue import load_library
from uniteam.world.homes.home import Home, Instance, Light, Room, Stage, Wall

OUTLINE = ((0.0, 0.0), (6.0, 0.0), (6.0, 3.0), (3.0, 3.0), (3.0, 6.0), (0.0, 6.0))
HEIGHT = 2.6
SLANT = ((4.6, 0.0), (6.0, 1.4))
"""A wall across the south-eastern corner, from one point to the other (m)."""
TABLE_HEIGHT = 0.7

_LEGS = [(x, y) for x in (-0.44, 0.4) for y in (-0.29, 0.25)]
_TABLE = [box((-0.5, -0.35, 0.66), (0.5, 0.35, 0.7)), *(box((x, y, 0.0), (x + 0.04, y + 0.04, 0.66)) for x, y in _LEGS)]
_CUP = [box((-0.04, -0.04, 0.0), (0.04, 0.04, 0.1), (0.8, 0.1, 0.1))]
_CATALOGUE = {
    "adds_to_pack": True,
    "models": [
        {
            "id": "own_table", "role": "receptacle", "category": "table", "size": [1.0, 0.7, 0.7], "mass": 18.0,
            "shapes": [{"center": [0, 0, 0.35], "size": [1.0, 0.7, 0.7]}],
            "surfaces": [{"height": 0.7, "outline": [[-0.5, -0.35], [0.5, -0.35], [0.5, 0.35], [-0.5, 0.35]],
                          "clearance": 1.9}],
        },
        {
            "id": "own_cup", "role": "object", "category": "cup", "size": [0.08, 0.08, 0.1], "mass": 0.2,
            "shapes": [{"center": [0, 0, 0.05], "size": [0.08, 0.08, 0.1]}],
        },
    ],
}  # fmt: skip


def write_library(folder: Path) -> None:
    """Write a library of two models, which adds them to the pack."""
    write_glb(folder / "models" / "own_table.glb", *_TABLE)
    write_glb(folder / "models" / "own_cup.glb", *_CUP)
    (folder / "catalogue.json").write_text(json.dumps(_CATALOGUE))


def write_stage(path: Path) -> None:
    """Write the stage's mesh: the slanted wall and a round column, which no straight wall can be."""
    turns = [2.0 * math.pi * k / 16 for k in range(17)]
    column = [(1.5 + 0.25 * math.cos(turn), 4.0 - 0.25 * math.sin(turn)) for turn in reversed(turns)]
    write_glb(path, upright(tuple(reversed(SLANT)), HEIGHT, (0.7, 0.6, 0.5)), upright(column, HEIGHT, (0.5, 0.5, 0.6)))


def own_home(folder: Path) -> Home:
    """Return the home, with its library and its mesh in a folder that `write_library` and `write_stage` have filled."""
    library = load_library(folder / "library")
    light = Light((2.0, 2.0, 2.3), (1.0, 0.97, 0.93), 0.45)
    room = Room("loft_1", "living_room", OUTLINE, "planks_oak", "plaster_white", (0.95, 0.93, 0.88), light)
    walls = tuple(Wall(start, end, 0.1) for start, end in pairwise((*OUTLINE, OUTLINE[0])))
    chest = library.of_category("chest_of_drawers")[0]
    instances = (
        _standing("table_1", "own_table", "table", (4.0, 2.5, 0.0)),
        _standing("chest_1", chest.id, chest.category, (0.8, 5.7, 0.0)),
        _standing("cup_1", "own_cup", "cup", (3.8, 2.4, TABLE_HEIGHT + 0.001)),
    )
    return Home("loft", Stage((room,), walls, HEIGHT, folder / "stage.glb"), instances, library)


def made_home(folder: Path) -> Home:
    """Write library and mesh into a folder and return the home made of them."""
    write_library(folder / "library")
    write_stage(folder / "stage.glb")
    return own_home(folder)


def _standing(name: str, model: str, category: str, position: tuple[float, float, float]) -> Instance:
    return Instance(name, model, category, category == "cup", position, (1.0, 0.0, 0.0, 0.0), "loft_1")
