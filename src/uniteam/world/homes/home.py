"""A home: a stage of rooms, walls and doors, and the instances of models that stand in it.

The world frame has x to the east, y to the north and z up; the floor is z = 0. Whatever made a home (our generator, the
files of another scene data set), the camera, the physics and the measures know only what stands here.
"""

from dataclasses import asdict, dataclass, field
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import pose_matrix
from uniteam.world.assets.catalogue import Point2, Point3

Quaternion = tuple[float, float, float, float]


@dataclass(frozen=True)
class Light:
    """A room's light: where it hangs (m, world), its colour (linear RGB, about 1 is white) and ambient share."""

    position: Point3
    color: Point3
    ambient: float


@dataclass(frozen=True)
class Room:
    """A rectangular room.

    Attributes:
        name: unique in the home ("bedroom_2").
        kind: "living_room", "kitchen", "bedroom", "bathroom", "office", "hall", "dining_room", "laundry", ...
        low, high: corners of the rectangle between the walls' centre lines (m, world).
        floor_texture, wall_texture: names of textures of the pack.
        wall_tint: RGB in [0, 1] that multiplies the wall texture.
        light: its light.
    """

    name: str
    kind: str
    low: Point2
    high: Point2
    floor_texture: str
    wall_texture: str
    wall_tint: Point3
    light: Light


@dataclass(frozen=True)
class Opening:
    """A hole in a wall: from `start` to `end` along it (m), from `bottom` to `top` above the floor (m).

    A door reaches the floor and stands open; a passage is a wide opening without a leaf; a window does not reach it.
    """

    kind: Literal["door", "passage", "window"]
    start: float
    end: float
    bottom: float
    top: float


@dataclass(frozen=True)
class Wall:
    """A straight wall along its centre line from `start` to `end` (m, world), `thickness` wide, up to the ceiling."""

    start: Point2
    end: Point2
    thickness: float
    openings: tuple[Opening, ...] = ()


@dataclass(frozen=True)
class Stage:
    """What does not move and is no model: rooms, walls with their openings, the ceiling's height (m)."""

    rooms: tuple[Room, ...]
    walls: tuple[Wall, ...]
    ceiling_height: float


@dataclass(frozen=True)
class Instance:
    """A model that stands somewhere.

    Attributes:
        name: unique in the home ("table_3").
        model: id in the catalogue.
        category: as in the catalogue.
        movable: whether physics moves it (a graspable object) or it is fixed (furniture, decor).
        position: of the model's origin (m, world).
        quaternion: (w, x, y, z), model to world.
        room: name of the room it stands in.
    """

    name: str
    model: str
    category: str
    movable: bool
    position: Point3
    quaternion: Quaternion
    room: str

    def model_to_world(self) -> NDArray[np.float64]:
        """Return the (4, 4) transform."""
        return pose_matrix(np.array(self.position), np.array(self.quaternion))


@dataclass(frozen=True)
class Home:
    """A stage and its instances; `seed` says which seed made it, if one did."""

    name: str
    stage: Stage
    instances: tuple[Instance, ...]
    seed: int | None = field(default=None)

    @cached_property
    def by_name(self) -> dict[str, Instance]:
        """The instances by name."""
        return {instance.name: instance for instance in self.instances}

    def of_category(self, category: str) -> tuple[Instance, ...]:
        """Return the instances of a category, in the home's order."""
        return tuple(i for i in self.instances if i.category == category)


def home_to_data(home: Home) -> dict[str, Any]:
    """Return the home as plain JSON data."""
    return asdict(home)


def home_from_data(data: dict[str, Any]) -> Home:
    """Return the home that `home_to_data` wrote; raises KeyError, TypeError or ValueError where the data is not one."""
    stage = data["stage"]
    rooms = tuple(
        Room(**{**r, "low": tuple(r["low"]), "high": tuple(r["high"]), "wall_tint": tuple(r["wall_tint"]),
                "light": Light(tuple(r["light"]["position"]), tuple(r["light"]["color"]), r["light"]["ambient"])})
        for r in stage["rooms"]
    )  # fmt: skip
    walls = tuple(
        Wall(tuple(w["start"]), tuple(w["end"]), w["thickness"], tuple(Opening(**o) for o in w["openings"]))
        for w in stage["walls"]
    )
    instances = tuple(
        Instance(**{**i, "position": tuple(i["position"]), "quaternion": tuple(i["quaternion"])})
        for i in data["instances"]
    )
    return Home(data["name"], Stage(rooms, walls, stage["ceiling_height"]), instances, data["seed"])
