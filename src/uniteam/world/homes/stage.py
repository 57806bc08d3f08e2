"""From a plan in centimetres to a stage in metres: each room with its own floor, wall paint and light."""

from collections.abc import Sequence

from numpy.random import Generator

from uniteam.world.assets.textures import texture_names
from uniteam.world.homes.floor_plan import FloorPlan, PlannedRoom
from uniteam.world.homes.home import Light, Opening, Room, Stage, Wall
from uniteam.world.homes.openings import WALL_THICKNESS, PlannedWall

_TILED = ("bathroom", "laundry", "kitchen")
_TILE_WORDS = ("tile", "stone", "marble", "ceramic", "terracotta", "concrete")
_BATHROOM_WALL_WORDS = ("tile", "ceramic", "mosaic")
_TINTS = (
    (1.0, 0.98, 0.94), (0.97, 0.97, 0.97), (0.95, 0.92, 0.84), (0.84, 0.9, 0.93), (0.86, 0.92, 0.84),
    (0.96, 0.88, 0.82), (0.9, 0.86, 0.92), (0.98, 0.94, 0.78), (0.82, 0.84, 0.86), (0.93, 0.85, 0.78),
    (0.78, 0.86, 0.85), (0.99, 0.91, 0.89),
)  # fmt: skip
_LIGHTS = (
    (1.08, 0.98, 0.84), (1.05, 1.0, 0.92), (1.0, 1.0, 1.0), (0.94, 0.99, 1.06), (1.15, 1.05, 0.9), (0.9, 0.86, 0.78),
)  # fmt: skip


def build_stage(plan: FloorPlan, walls: Sequence[PlannedWall], ceiling: int, rng: Generator) -> Stage:
    """Return the stage of a plan; `ceiling` is its height (cm)."""
    tints = rng.permutation(len(_TINTS))
    wooden = str(rng.choice(_textures("floor", (), _TILE_WORDS)))
    rooms = tuple(_room(room, _TINTS[tints[i]], wooden, ceiling, rng) for i, room in enumerate(plan))
    return Stage(rooms, tuple(_wall(wall) for wall in walls), ceiling / 100)


def _textures(kind: str, wanted: Sequence[str], unwanted: Sequence[str]) -> list[str]:
    """Return the textures whose names hold a wanted word (any, where none is given) and no unwanted one, or all."""
    names = texture_names("floor" if kind == "floor" else "wall")
    fitting = [
        name
        for name in names
        if (not wanted or any(word in name for word in wanted)) and not any(word in name for word in unwanted)
    ]
    return fitting or list(names)


def _room(room: PlannedRoom, tint: tuple[float, float, float], common_floor: str, ceiling: int, rng: Generator) -> Room:
    if room.kind in _TILED:
        floor = str(rng.choice(_textures("floor", _TILE_WORDS, ())))
    else:
        own = str(rng.choice(_textures("floor", (), _TILE_WORDS)))
        floor = common_floor if rng.random() < 0.5 else own
    tiled_wall = room.kind == "bathroom" and rng.random() < 0.5
    wall = str(rng.choice(_textures("wall", _BATHROOM_WALL_WORDS if tiled_wall else (), ())))
    low, high = (room.rect.x0 / 100, room.rect.y0 / 100), (room.rect.x1 / 100, room.rect.y1 / 100)
    position = (round((low[0] + high[0]) / 2, 3), round((low[1] + high[1]) / 2, 3), round(ceiling / 100 - 0.3, 3))
    light = Light(position, _LIGHTS[int(rng.integers(len(_LIGHTS)))], round(float(rng.uniform(0.35, 0.55)), 3))
    return Room(room.name, room.kind, low, high, floor, wall, tint, light)


def _wall(wall: PlannedWall) -> Wall:
    across, start, end = wall.across / 100, wall.start / 100, wall.end / 100
    ends = ((start, across), (end, across)) if wall.horizontal else ((across, start), (across, end))
    openings = tuple(Opening(o.kind, o.start / 100, o.end / 100, o.bottom / 100, o.top / 100) for o in wall.openings)
    return Wall(*ends, WALL_THICKNESS / 100, openings)
