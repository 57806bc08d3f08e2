"""A model: what it is called, weighs and measures, what it collides as, and the surfaces that can hold things.

The model frame has its origin at the centre of the bounding box's floor: x right, y back (the front faces -y), z up,
metres, at real size.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from uniteam.geometry import Point2, Point3

RECEPTACLE_CATEGORIES = (
    "bathtub", "bed", "bench", "cabinet", "chair", "chest_of_drawers", "couch", "counter", "filing_cabinet", "hamper",
    "serving_cart", "shelves", "shoe_rack", "sink", "stand", "stool", "table", "toilet", "trunk", "wardrobe",
    "washer_dryer",
)  # fmt: skip

Affine = tuple[tuple[float, float, float, float], ...]
"""The four rows of a (4, 4) transform that may stretch and mirror."""

Role = Literal["receptacle", "object", "decor", "door"]
Pool = Literal["train", "test"]


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
    """One model of a library.

    Attributes:
        id: unique in the library.
        role: what it is for: a receptacle, a graspable object, decor, or a door.
        category: one of the receptacle classes, an object class, or a kind of decor ("refrigerator").
        name: what a person would call it.
        size: (x, y, z) extents of the bounding box (m).
        mass: kg.
        pool: whether training homes may use it, or only the others.
        shapes: what it collides as; empty for what cannot be touched (a rug).
        surfaces: where it can hold things.
        source, source_id, creator, licence: where it is from and who made it.
        checksum: SHA-256 of its file; empty where nobody wrote one down.
        path: its glTF binary.
        file_to_model: from the file's frame, once it has z up, to the model's; None where they are the same.
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
    path: Path
    file_to_model: Affine | None = None
