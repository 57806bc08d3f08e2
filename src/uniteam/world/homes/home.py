"""A home: a stage of rooms, walls and doors, and the instances of models that stand in it.

The world frame has x to the east, y to the north and z up; the floor is z = 0. Whatever made a home (our generator, the
files of another scene data set), the camera, the physics and the measures know only what stands here.
"""

from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import Point2, Point3, pose_matrix
from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import Model
from uniteam.world.homes import polygon

Quaternion = tuple[float, float, float, float]


@dataclass(frozen=True)
class Light:
    """A room's light: where it hangs (m, world), its colour (linear RGB, about 1 is white) and ambient share."""

    position: Point3
    color: Point3
    ambient: float


@dataclass(frozen=True)
class Room:
    """A room: a stretch of the floor that the robot may stand on, with a floor, a ceiling and a light of its own.

    Attributes:
        name: unique in the home ("bedroom_2").
        kind: "living_room", "kitchen", "bedroom", "bathroom", "office", "hall", "dining_room", "laundry", ...
        outline: a simple polygon along the walls' centre lines, counter-clockwise (m, world).
        floor_texture: name of a texture of the library; None where the stage's mesh shows floor, ceiling and lamp.
        wall_texture: name of a texture of the library; None for plain paint.
        wall_tint: RGB in [0, 1] that multiplies the wall texture.
        light: its light.
    """

    name: str
    kind: str
    outline: polygon.Polygon
    floor_texture: str | None
    wall_texture: str | None
    wall_tint: Point3
    light: Light

    @cached_property
    def low(self) -> Point2:
        """The lower left corner of the smallest axis-aligned rectangle around the room (m, world)."""
        return polygon.bounds(self.outline)[0]

    @cached_property
    def high(self) -> Point2:
        """The upper right corner of that rectangle (m, world)."""
        return polygon.bounds(self.outline)[1]

    @property
    def area(self) -> float:
        """Of the floor between the walls' centre lines (m2)."""
        return polygon.area(self.outline)

    @property
    def middle(self) -> Point2:
        """A point well inside (m, world)."""
        return polygon.middle(self.outline)

    def contains(self, x: float, y: float) -> bool:
        """Say whether a point (m, world) lies in the room."""
        return polygon.contains(self.outline, x, y)


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
    """What does not move and is no model.

    Attributes:
        rooms: where the robot may be.
        walls: straight ones, with their openings.
        ceiling_height: of every room (m).
        mesh: a glTF binary of what else stands there for good (world frame, z up once it is read), such as slanted or
            round walls; None where there is nothing else. It is seen and collided with as it is. What of it reaches up
            to the ceiling is left out of views from above, as the ceiling is.
    """

    rooms: tuple[Room, ...]
    walls: tuple[Wall, ...]
    ceiling_height: float
    mesh: Path | None = None


@dataclass(frozen=True)
class Instance:
    """A model that stands somewhere.

    Attributes:
        name: unique in the home ("table_3").
        model: id in the home's library.
        category: as in the library.
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
    """A stage, what stands on it, and the library that says what that is.

    Two homes are equal where all of this is, the library too: the same names of other models are another home.

    Attributes:
        name: unique among the homes of a split.
        stage: rooms and walls.
        instances: the models that stand there.
        library: holds every model and texture that the home names.
        seed: which seed made it, if one did.
    """

    name: str
    stage: Stage
    instances: tuple[Instance, ...]
    library: Catalogue = field(hash=False, repr=False)
    seed: int | None = None

    @cached_property
    def by_name(self) -> dict[str, Instance]:
        """The instances by name."""
        return {instance.name: instance for instance in self.instances}

    def model_of(self, instance: Instance) -> Model:
        """Return an instance's model; raises UnknownNameError where the library lacks it."""
        return self.library[instance.model]

    def of_category(self, category: str) -> tuple[Instance, ...]:
        """Return the instances of a category, in the home's order."""
        return tuple(i for i in self.instances if i.category == category)
