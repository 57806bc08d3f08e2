"""A house of ProcTHOR as its JSON has it, as far as it is read; the rest is passed over.

The fields are those of `procthor/utils/types.py` of https://github.com/allenai/procthor, in the schema 0.0.1 of what
the generator writes and in 1.0.0, to which `upgrade_house_version.py` there brings it. Metres and degrees, in Unity's
frame.
"""

from typing import Annotated

import msgspec

Coordinate = Annotated[float, msgspec.Meta(ge=-1_000.0, le=1_000.0)]
Degrees = Annotated[float, msgspec.Meta(ge=-3_600.0, le=3_600.0)]
Share = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
Word = Annotated[str, msgspec.Meta(max_length=200)]


class Vector(msgspec.Struct):
    """A point (m)."""

    x: Coordinate
    z: Coordinate = 0.0
    y: Coordinate = 0.0


class Rotation(msgspec.Struct, frozen=True):
    """Euler angles (degrees)."""

    x: Degrees = 0.0
    y: Degrees = 0.0
    z: Degrees = 0.0


class Color(msgspec.Struct):
    """RGB."""

    r: Share
    g: Share
    b: Share


class Material(msgspec.Struct):
    """A material, and the colour that it is painted in."""

    name: Word | None = None
    color: Color | None = None


class RoomEntry(msgspec.Struct, rename="camel"):
    """A room."""

    id: Word
    room_type: Word
    floor_polygon: Annotated[list[Vector], msgspec.Meta(min_length=3, max_length=200)]
    floor_material: Material | Word | None = None


class WallEntry(msgspec.Struct, rename="camel"):
    """One side of a wall: two corners on the floor, two at the ceiling. An `empty` one is open."""

    id: Word
    polygon: Annotated[list[Vector], msgspec.Meta(min_length=4, max_length=4)]
    room_id: Word = ""
    empty: bool = False
    material: Material | Word | None = None
    color: Color | None = None


class BoundingBox(msgspec.Struct):
    """Two corners of a hole, in the schema 0.0.1."""

    min: Vector
    max: Vector


class HoleEntry(msgspec.Struct, rename="camel"):
    """A door or a window: x along `wall0` from the first of its floor corners, y above the floor."""

    id: Word
    wall0: Word
    wall1: Word | None = None
    asset_id: Word = ""
    hole_polygon: Annotated[list[Vector], msgspec.Meta(min_length=2, max_length=100)] | None = None
    bounding_box: BoundingBox | None = None


class ObjectEntry(msgspec.Struct, rename="camel"):
    """An asset: the middle of its bounding box, how it is turned, and what lies on it."""

    id: Word
    asset_id: Word
    position: Vector
    rotation: Rotation = Rotation()
    children: "Annotated[list[ObjectEntry], msgspec.Meta(max_length=2_000)]" = []


class House(msgspec.Struct, rename="camel"):
    """A house."""

    rooms: Annotated[list[RoomEntry], msgspec.Meta(min_length=1, max_length=200)]
    walls: Annotated[list[WallEntry], msgspec.Meta(max_length=2_000)]
    doors: Annotated[list[HoleEntry], msgspec.Meta(max_length=1_000)] = []
    windows: Annotated[list[HoleEntry], msgspec.Meta(max_length=1_000)] = []
    objects: Annotated[list[ObjectEntry], msgspec.Meta(max_length=2_000)] = []


class AssetEntry(msgspec.Struct, rename="camel"):
    """An asset of `asset-database.json`: its class, and how large it is (m)."""

    asset_id: Word
    object_type: Word
    bounding_box: Vector
