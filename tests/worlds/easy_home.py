"""Two plain rooms with a table, a bed and two objects: a home in which an agent should succeed."""

from dataclasses import replace
from pathlib import Path

from worlds.glb import box, write_glb
from worlds.small_home import BALL, CUP, TABLE, TABLE_HEIGHT, instance, small_home

from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import Box, Model, SupportSurface
from uniteam.world.homes.home import Home

BED_HEIGHT = 0.5


BESIDE_THE_DOOR, IN_THE_CORNER = (5.0, 0.55), (1.2, 3.4)
"""Where the table stands (m): in the bed's room, or in the other one."""


def easy_home(folder: Path, table_at: tuple[float, float]) -> Home:
    """Return the home with a table somewhere; the meshes of its models are written into a folder."""
    x, y = table_at
    towards_middle = 0.25 if y < 2.0 else -0.25
    table = _with_top(TABLE, folder)
    size = (2.0, 1.6, BED_HEIGHT)
    bed = _with_top(replace(TABLE, id="bed", category="bed", size=size, shapes=(Box((0.0, 0.0, 0.25), size),)), folder)
    cup, ball = (_with_mesh(replace(model, shapes=(_as_box(model),)), folder) for model in (CUP, BALL))
    return small_home(
        instance("table", table, x, y),
        instance("bed", bed, 6.8, 3.1),
        instance("cup", cup, x + 0.1, y + towards_middle, TABLE_HEIGHT),
        instance("ball", ball, 6.4, 2.5, BED_HEIGHT),
        library=Catalogue({model.id: model for model in (table, bed, cup, ball)}, frozenset()),
    )


def _as_box(model: Model) -> Box:
    return Box((0.0, 0.0, model.size[2] / 2), model.size)


def _with_top(model: Model, folder: Path) -> Model:
    width, depth, height = model.size
    corners = ((-width / 2, -depth / 2), (width / 2, -depth / 2), (width / 2, depth / 2), (-width / 2, depth / 2))
    return _with_mesh(replace(model, surfaces=(SupportSurface(height, corners, 1.5),)), folder)


def _with_mesh(model: Model, folder: Path) -> Model:
    """Return the model with a mesh of its shapes."""
    path = folder / f"{model.id}.glb"
    write_glb(path, *(box(*_corners(shape)) for shape in model.shapes if isinstance(shape, Box)))
    return replace(model, path=path)


def _corners(shape: Box) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
    (x, y, z), (width, depth, height) = shape.center, shape.size
    return (x - width / 2, y - depth / 2, z - height / 2), (x + width / 2, y + depth / 2, z + height / 2)
