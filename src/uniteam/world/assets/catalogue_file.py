"""The file `catalogue.json` of a library: what it must hold, and the models that it becomes.

    {"models": [{"id": "my_mug", "role": "object", "category": "cup", "size": [0.09, 0.08, 0.1], "mass": 0.3,
                 "shapes": [{"center": [0, 0, 0.05], "size": [0.09, 0.08, 0.1]}]}]}

A model's file is `models/ID.glb` beside it. A shape is a box (`center`, `size`) or a convex hull (`hull`: its corners).
Everything that may be left out has a default below.
"""

import math
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Annotated

import msgspec

from uniteam.geometry import Point2
from uniteam.world.assets.model import (
    RECEPTACLE_CATEGORIES,
    Box,
    CollisionShape,
    Hull,
    Model,
    Pool,
    Role,
    SupportSurface,
)
from uniteam.world.assets.reading import damaged, read_json

Identifier = Annotated[str, msgspec.Meta(pattern=r"^[A-Za-z0-9][A-Za-z0-9_-]*\Z", max_length=100)]
"""A name that is also a file's: no path leads out of the library's folder."""
Word = Annotated[str, msgspec.Meta(pattern=r"^[^\x00-\x1f\x7f-\x9f]+\Z", max_length=200)]
"""A name that can be printed."""
Text = Annotated[str, msgspec.Meta(pattern=r"^[^\x00-\x1f\x7f-\x9f]*\Z", max_length=1000)]
Coordinate = Annotated[float, msgspec.Meta(ge=-100.0, le=100.0)]
Length = Annotated[float, msgspec.Meta(gt=0.0, le=100.0)]
Height = Annotated[float, msgspec.Meta(ge=0.0, le=100.0)]
Corner = tuple[Coordinate, Coordinate, Coordinate]
Extents = tuple[Length, Length, Length]

_FLAT = 1e-6
_WHAT = "the catalogue of models"


class _Shape(msgspec.Struct, forbid_unknown_fields=True):
    center: Corner | None = None
    size: Extents | None = None
    hull: Annotated[tuple[Corner, ...], msgspec.Meta(min_length=4, max_length=32)] | None = None


class _Surface(msgspec.Struct, forbid_unknown_fields=True):
    height: Height
    outline: Annotated[tuple[tuple[Coordinate, Coordinate], ...], msgspec.Meta(min_length=3, max_length=100)]
    clearance: Length


class _Model(msgspec.Struct, forbid_unknown_fields=True):
    id: Identifier
    role: Role
    category: Word
    size: Extents
    mass: Annotated[float, msgspec.Meta(gt=0.0, le=10_000.0)]
    shapes: Annotated[tuple[_Shape, ...], msgspec.Meta(max_length=100)] = ()
    surfaces: Annotated[tuple[_Surface, ...], msgspec.Meta(max_length=100)] = ()
    name: Text = ""
    pool: Pool = "test"
    source: Text = ""
    source_id: Text = ""
    creator: Text = ""
    licence: Text = ""
    checksum: Text = ""


class CatalogueFile(msgspec.Struct, forbid_unknown_fields=True):
    """The whole file.

    Attributes:
        models: as they stand in the file.
        unseen_categories: object classes that no training home holds.
        adds_to_pack: whether the library has the models and textures of the package's own pack besides.
    """

    models: Annotated[tuple[_Model, ...], msgspec.Meta(max_length=20_000)]
    unseen_categories: tuple[Word, ...] = ()
    adds_to_pack: bool = False


def read_catalogue_file(folder: Path) -> tuple[dict[str, Model], CatalogueFile]:
    """Return a library's own models by id, and the file itself.

    Raises:
        DamagedFileError: the file is missing or is no catalogue; the sentence names the model and the field.
    """
    path = folder / "catalogue.json"
    content = read_json(path, _WHAT, CatalogueFile)
    models: dict[str, Model] = {}
    for entry in content.models:
        problem = "there are two of them" if entry.id in models else next(_problems(entry), None)
        if problem is not None:
            raise damaged(path, _WHAT, f"model '{entry.id}': {problem}")
        models[entry.id] = _model(entry, folder)
    return models, content


def _problems(entry: _Model) -> Iterator[str]:
    """Yield what is wrong with a model beyond its fields' types and bounds."""
    is_receptacle_class = entry.category in RECEPTACLE_CATEGORIES
    if entry.role == "receptacle" and not is_receptacle_class:
        yield f"category '{entry.category}' of a receptacle must be one of {', '.join(RECEPTACLE_CATEGORIES)}"
    if entry.role == "object" and is_receptacle_class:
        yield f"category '{entry.category}' of an object is a class of receptacles"
    if entry.role in ("receptacle", "object") and not entry.shapes:
        yield f"a model whose role is {entry.role} needs collision shapes"
    if any((shape.hull is None) == (shape.center is None or shape.size is None) for shape in entry.shapes):
        yield "each of its shapes must have either a center and a size, or a hull"
    if not all(_is_convex(surface.outline) for surface in entry.surfaces):
        yield "the outline of each surface must be a convex polygon, counter-clockwise"


def _is_convex(outline: tuple[Point2, ...]) -> bool:
    """Say whether a polygon turns left at every corner, and once around in all."""
    edges = [(x1 - x0, y1 - y0) for (x0, y0), (x1, y1) in pairwise((*outline, outline[0]))]
    edges = [edge for edge in edges if math.hypot(*edge) > _FLAT]
    turns = [math.atan2(ax * by - ay * bx, ax * bx + ay * by) for (ax, ay), (bx, by) in pairwise((*edges, *edges[:1]))]
    return all(turn > -1e-3 for turn in turns) and abs(sum(turns) - 2.0 * math.pi) < 1e-3


def _model(entry: _Model, folder: Path) -> Model:
    return Model(
        id=entry.id,
        role=entry.role,
        category=entry.category,
        name=entry.name or entry.category.replace("_", " "),
        size=entry.size,
        mass=entry.mass,
        pool=entry.pool,
        shapes=tuple(_shape(shape) for shape in entry.shapes),
        surfaces=tuple(SupportSurface(s.height, s.outline, s.clearance) for s in entry.surfaces),
        source=entry.source,
        source_id=entry.source_id,
        creator=entry.creator,
        licence=entry.licence,
        checksum=entry.checksum,
        path=folder / "models" / f"{entry.id}.glb",
    )


def _shape(shape: _Shape) -> CollisionShape:
    if shape.hull is not None:
        return Hull(shape.hull)
    assert shape.center is not None and shape.size is not None, "checked before"
    return Box(shape.center, shape.size)
