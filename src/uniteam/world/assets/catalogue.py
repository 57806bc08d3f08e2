"""What the pack of models holds: a model's name, size, collision shapes and the surfaces that can hold things.

The model frame has its origin at the centre of the bounding box's floor: x right, y back (the front faces -y), z up,
metres, at real size.
"""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any, Literal

from uniteam.errors import DamagedFileError, UnknownNameError

PACK_DIRECTORY = Path(__file__).parent / "pack"

RECEPTACLE_CATEGORIES = (
    "bathtub", "bed", "bench", "cabinet", "chair", "chest_of_drawers", "couch", "counter", "filing_cabinet", "hamper",
    "serving_cart", "shelves", "shoe_rack", "sink", "stand", "stool", "table", "toilet", "trunk", "wardrobe",
    "washer_dryer",
)  # fmt: skip

Role = Literal["receptacle", "object", "decor", "door"]
Pool = Literal["train", "test"]
Point2 = tuple[float, float]
Point3 = tuple[float, float, float]


@dataclass(frozen=True)
class Box:
    """An axis-aligned box of the model frame: centre and full extents (m)."""

    center: Point3
    size: Point3


@dataclass(frozen=True)
class Hull:
    """A convex hull of at most 32 vertices (m, model frame)."""

    vertices: tuple[Point3, ...]


CollisionShape = Box | Hull


@dataclass(frozen=True)
class SupportSurface:
    """A flat region that can hold a thing.

    Attributes:
        height: m above the model's floor.
        outline: a convex polygon (x, y), counter-clockwise (m, model frame).
        clearance: free height above it (m); large where it is open to the air.
    """

    height: float
    outline: tuple[Point2, ...]
    clearance: float


@dataclass(frozen=True)
class Model:
    """One model of the pack.

    Attributes:
        id: unique in the catalogue, and the stem of its file.
        role: what it is for: a receptacle, a graspable object, decor, or a door.
        category: one of the receptacle classes, an object class, or a kind of decor ("refrigerator").
        name: what a person would call it.
        size: (x, y, z) extents of the bounding box (m).
        mass: kg.
        pool: whether training homes may use it, or only the others.
        shapes: what it collides as; empty for what cannot be touched (a rug).
        surfaces: where it can hold things.
        source, source_id, creator, licence: where it is from and whom to thank.
        checksum: SHA-256 of its file.
    """

    id: str
    role: Role
    category: str
    name: str
    size: Point3
    mass: float
    pool: Pool
    shapes: tuple[CollisionShape, ...]
    surfaces: tuple[SupportSurface, ...]
    source: str
    source_id: str
    creator: str
    licence: str
    checksum: str

    @property
    def path(self) -> Path:
        """The model's glTF binary."""
        return PACK_DIRECTORY / "models" / f"{self.id}.glb"


@dataclass(frozen=True)
class Catalogue:
    """Every model of the pack by id, and the object categories that no training home holds."""

    models: Mapping[str, Model]
    unseen_categories: frozenset[str]

    def __getitem__(self, model_id: str) -> Model:
        try:
            return self.models[model_id]
        except KeyError:
            raise UnknownNameError("model", model_id, self.models) from None

    @cached_property
    def object_categories(self) -> tuple[str, ...]:
        """Every class of graspable object, sorted."""
        return tuple(sorted({m.category for m in self.models.values() if m.role == "object"}))

    def of_category(self, category: str, pool: Pool | None = None) -> tuple[Model, ...]:
        """Return the models of a category, of one pool or of both, sorted by id."""
        found = [m for m in self.models.values() if m.category == category and pool in (None, m.pool)]
        return tuple(sorted(found, key=lambda model: model.id))


def _shape(data: dict[str, Any]) -> CollisionShape:
    if "hull" in data:
        return Hull(tuple(_point(p) for p in data["hull"]))
    return Box(_point(data["center"]), _point(data["size"]))


def _point(values: list[float]) -> Point3:
    x, y, z = values
    return (x, y, z)


def _model(data: dict[str, Any]) -> Model:
    shapes = tuple(_shape(s) for s in data["shapes"])
    surfaces = tuple(
        SupportSurface(s["height"], tuple((x, y) for x, y in s["outline"]), s["clearance"]) for s in data["surfaces"]
    )
    return Model(**{**data, "size": _point(data["size"]), "shapes": shapes, "surfaces": surfaces})


@lru_cache(maxsize=1)
def load_catalogue() -> Catalogue:
    """Read the pack's catalogue.

    Raises:
        DamagedFileError: the file is missing or is not a catalogue.
    """
    path = PACK_DIRECTORY / "catalogue.json"
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        models = {m["id"]: _model(m) for m in data["models"]}
        return Catalogue(models, frozenset(data["unseen_categories"]))
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise DamagedFileError(f"the model catalogue {path} cannot be read ({error}); reinstall uniteam") from error
