"""A home of two rooms with a door between them, furnished from a catalogue of four models made of boxes and hulls."""

import math
from pathlib import Path

from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import Box, CollisionShape, Hull, Model, Role
from uniteam.world.homes.home import Home, Instance, Light, Opening, Room, Stage, Wall
from uniteam.world.homes.polygon import rectangle

SINK_FLOOR = 0.70
TABLE_HEIGHT = 0.75


def _model(id_: str, role: Role, size: tuple[float, float, float], mass: float, *shapes: CollisionShape) -> Model:
    return Model(id_, role, id_, id_, size, mass, "test", shapes, (), "", "", "", "CC0", "", Path(f"{id_}.glb"))


def _ball(radius: float) -> Hull:
    """A sphere of 32 vertices that touches the model's floor: the golden spiral."""
    points = []
    for k in range(32):
        z = 1.0 - (2 * k + 1) / 32
        ring, turn = math.sqrt(1 - z * z), k * math.pi * (3 - math.sqrt(5))
        points.append((radius * ring * math.cos(turn), radius * ring * math.sin(turn), radius * (1 + z)))
    return Hull(tuple(points))


TABLE = _model(
    "table", "receptacle", (1.2, 0.8, 0.75), 20.0, Box((0.0, 0.0, 0.73), (1.2, 0.8, 0.04)),
    *(Box((x, y, 0.355), (0.06, 0.06, 0.71)) for x in (-0.55, 0.55) for y in (-0.35, 0.35)),
)  # fmt: skip
SINK = _model(
    "sink", "receptacle", (0.6, 0.5, 0.9), 20.0, Box((0.0, 0.0, 0.35), (0.6, 0.5, 0.7)),
    Box((-0.28, 0.0, 0.8), (0.04, 0.5, 0.2)), Box((0.28, 0.0, 0.8), (0.04, 0.5, 0.2)),
    Box((0.0, -0.23, 0.8), (0.6, 0.04, 0.2)), Box((0.0, 0.23, 0.8), (0.6, 0.04, 0.2)),
)  # fmt: skip
CUP = _model("cup", "object", (0.08, 0.08, 0.1), 0.2, Box((0.0, 0.0, 0.05), (0.08, 0.08, 0.1)))
BALL = _model("ball", "object", (0.1, 0.1, 0.1), 0.3, _ball(0.05))

CATALOGUE = Catalogue({m.id: m for m in (TABLE, SINK, CUP, BALL)}, frozenset())


def instance(name: str, model: Model, x: float, y: float, z: float = 0.0, yaw: float = 0.0) -> Instance:
    """Return an instance of one of the models above."""
    quaternion = (math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2))
    return Instance(name, model.id, model.category, model.role == "object", (x, y, z), quaternion, "west")


def small_home(*instances: Instance, library: Catalogue = CATALOGUE) -> Home:
    """Return rooms "west" (x 0 to 4) and "east" (4 to 8), y 0 to 4, with a door 0.9 m wide at y 1.5 to 2.4."""
    light = Light((2.0, 2.0, 2.4), (1.0, 1.0, 1.0), 0.4)
    rooms = tuple(
        Room(name, "living_room", rectangle((x, 0.0), (x + 4.0, 4.0)), None, None, (1.0, 1.0, 1.0), light)
        for name, x in (("west", 0.0), ("east", 4.0))
    )
    outer = [((0.0, 0.0), (8.0, 0.0)), ((8.0, 0.0), (8.0, 4.0)), ((8.0, 4.0), (0.0, 4.0)), ((0.0, 4.0), (0.0, 0.0))]
    walls = tuple(Wall(start, end, 0.1) for start, end in outer)
    inner = Wall((4.0, 0.0), (4.0, 4.0), 0.1, (Opening("door", 1.5, 2.4, 0.0, 2.0),))
    return Home("small", Stage(rooms, (*walls, inner), 2.5), instances, library)
