"""A home as plain JSON data: its fields, their types and their bounds.

    {"name": "loft", "stage": {"rooms": [...], "walls": [...], "ceiling_height": 2.6}, "instances": [...], "seed": null}

A room has an `outline`, a list of (x, y), or for a rectangle the short form `low` and `high`, two opposite corners.
`stage.mesh` names a glTF binary and `library` the folder of a library, both by their paths from the folder in which the
data itself stands; where `library` is left out it is the package's own pack.
"""

from typing import Annotated, Literal

import msgspec

Name = Annotated[str, msgspec.Meta(pattern=r"^[^\x00-\x1f\x7f-\x9f]+\Z", max_length=200)]
"""A name that can be printed."""
RoomName = Annotated[str, msgspec.Meta(pattern=r"^\w[\w .-]*\Z", max_length=100)]
"""A name that can be a file's, as the picture of a room has it."""
RelativePath = Annotated[str, msgspec.Meta(pattern=r"^[^\x00-\x1f\x7f-\x9f]+\Z", max_length=1000)]
Coordinate = Annotated[float, msgspec.Meta(ge=-1_000.0, le=1_000.0)]
Share = Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]
Brightness = Annotated[float, msgspec.Meta(ge=0.0, le=10.0)]
Height = Annotated[float, msgspec.Meta(ge=-1.0, le=20.0)]
Corner = tuple[Coordinate, Coordinate]
Part = Annotated[float, msgspec.Meta(ge=-1.01, le=1.01)]


class LightData(msgspec.Struct, forbid_unknown_fields=True):
    """A `Light`."""

    position: tuple[Coordinate, Coordinate, Height]
    color: tuple[Brightness, Brightness, Brightness]
    ambient: Share


class RoomData(msgspec.Struct, forbid_unknown_fields=True):
    """A `Room`, with its outline or with the two corners of a rectangle."""

    name: RoomName
    kind: Name
    floor_texture: Name | None
    wall_texture: Name | None
    wall_tint: tuple[Share, Share, Share]
    light: LightData
    low: Corner | None = None
    high: Corner | None = None
    outline: Annotated[tuple[Corner, ...], msgspec.Meta(min_length=3, max_length=200)] | None = None


class OpeningData(msgspec.Struct, forbid_unknown_fields=True):
    """An `Opening`."""

    kind: Literal["door", "passage", "window"]
    start: Coordinate
    end: Coordinate
    bottom: Height
    top: Height


class WallData(msgspec.Struct, forbid_unknown_fields=True):
    """A `Wall`."""

    start: Corner
    end: Corner
    thickness: Annotated[float, msgspec.Meta(ge=0.01, le=2.0)]
    openings: Annotated[tuple[OpeningData, ...], msgspec.Meta(max_length=100)] = ()


class StageData(msgspec.Struct, forbid_unknown_fields=True):
    """A `Stage`."""

    rooms: Annotated[tuple[RoomData, ...], msgspec.Meta(min_length=1, max_length=200)]
    walls: Annotated[tuple[WallData, ...], msgspec.Meta(max_length=2_000)]
    ceiling_height: Annotated[float, msgspec.Meta(ge=1.5, le=20.0)]
    mesh: RelativePath | None = None


class InstanceData(msgspec.Struct, forbid_unknown_fields=True):
    """An `Instance`."""

    name: Name
    model: Name
    category: Name
    movable: bool
    position: tuple[Coordinate, Coordinate, Height]
    quaternion: tuple[Part, Part, Part, Part]
    room: RoomName


class HomeData(msgspec.Struct, forbid_unknown_fields=True):
    """A `Home`."""

    name: Name
    stage: StageData
    instances: Annotated[tuple[InstanceData, ...], msgspec.Meta(max_length=2_000)]
    seed: Annotated[int, msgspec.Meta(ge=0, le=2**53)] | None = None
    library: RelativePath | None = None
