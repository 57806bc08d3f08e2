"""From a plan in centimetres to a stage in metres: each room with its own floor, wall paint and light."""

from collections.abc import Sequence
from dataclasses import dataclass

from numpy.random import Generator

from uniteam.geometry import Point3
from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.textures import TextureKind
from uniteam.world.generation.plan.openings import WALL_THICKNESS, PlannedWall
from uniteam.world.generation.plan.planned_room import FloorPlan, PlannedRoom
from uniteam.world.homes.home import Light, Opening, Room, Stage, Wall

_WOODEN = ("planks", "parquet", "wooden")
_CARPET = ("carpet",)
_FLOOR_TILES = ("tile", "linoleum", "marble")
_PAINT = ("paint", "plaster_white")
_WALLPAPER = ("wallpaper", "plaster", "paint")
_WALL_TILES = ("tile",)
_BRICKS = ("bricks",)

_FLOORS: dict[str, tuple[tuple[str, ...], ...]] = {
    "bathroom": (_FLOOR_TILES,), "laundry": (_FLOOR_TILES,), "kitchen": (_FLOOR_TILES, _FLOOR_TILES, _WOODEN),
    "hall": (_WOODEN, _FLOOR_TILES), "bedroom": (_WOODEN, _CARPET), "office": (_WOODEN, _CARPET),
}  # fmt: skip
"""Words of the textures' names that suit a room, one set of which is drawn; wood suits the others."""

_WALLS: dict[str, tuple[tuple[str, ...], ...]] = {
    "bathroom": (_WALL_TILES, _WALL_TILES, _PAINT), "kitchen": (_PAINT, _WALL_TILES, _WALLPAPER),
    "laundry": (_PAINT, _WALL_TILES),
}  # fmt: skip
_PLAIN_WALLS = (_PAINT, _PAINT, _PAINT, _PAINT, _PAINT, _WALLPAPER, _WALLPAPER, _WALLPAPER, _BRICKS)

_TINTS = (
    (1.0, 0.98, 0.94), (0.97, 0.97, 0.97), (0.95, 0.92, 0.84), (0.84, 0.9, 0.93), (0.86, 0.92, 0.84),
    (0.96, 0.88, 0.82), (0.9, 0.86, 0.92), (0.98, 0.94, 0.78), (0.82, 0.84, 0.86), (0.93, 0.85, 0.78),
    (0.78, 0.86, 0.85), (0.99, 0.91, 0.89),
)  # fmt: skip
_LIGHTS = (
    (1.08, 0.98, 0.84), (1.05, 1.0, 0.92), (1.0, 1.0, 1.0), (0.94, 0.99, 1.06), (1.15, 1.05, 0.9), (0.9, 0.86, 0.78),
)  # fmt: skip


@dataclass(frozen=True)
class Decorator:
    """Gives rooms their floors, paints and lights.

    Attributes:
        library: of the textures.
        rng: for every choice.
    """

    library: Catalogue
    rng: Generator

    def stage(self, plan: FloorPlan, walls: Sequence[PlannedWall], ceiling: int) -> Stage:
        """Return the stage of a plan; `ceiling` is its height (cm)."""
        tints = self.rng.permutation(len(_TINTS))
        common_floor = self._texture("floor", (_WOODEN,))
        rooms = tuple(self._room(room, _TINTS[tints[i]], common_floor, ceiling) for i, room in enumerate(plan))
        return Stage(rooms, tuple(_wall(wall) for wall in walls), ceiling / 100)

    def _texture(self, kind: TextureKind, choices: Sequence[Sequence[str]]) -> str:
        """Return a texture whose name holds a word of one of the choices; any, where the library has none such."""
        words = choices[int(self.rng.integers(len(choices)))]
        names = self.library.texture_names(kind)
        fitting = [name for name in names if any(word in name for word in words)] or names
        return fitting[int(self.rng.integers(len(fitting)))]

    def _room(self, room: PlannedRoom, tint: Point3, common_floor: str, ceiling: int) -> Room:
        own_floor = self._texture("floor", _FLOORS.get(room.kind, (_WOODEN,)))
        floor = common_floor if room.kind not in _FLOORS and self.rng.random() < 0.6 else own_floor
        wall = self._texture("wall", _WALLS.get(room.kind, _PLAIN_WALLS))
        outline = tuple((x / 100, y / 100) for x, y in room.floor.outline)
        heart = room.floor.heart
        x, y = (heart.x0 / 100 + heart.x1 / 100) / 2, (heart.y0 / 100 + heart.y1 / 100) / 2
        light = self._light((x, y, ceiling / 100 - 0.3))
        return Room(room.name, room.kind, outline, floor, wall, tint, light)

    def _light(self, position: Point3) -> Light:
        x, y, z = (round(value, 3) for value in position)
        color = _LIGHTS[int(self.rng.integers(len(_LIGHTS)))]
        return Light((x, y, z), color, round(float(self.rng.uniform(0.35, 0.55)), 3))


def _wall(wall: PlannedWall) -> Wall:
    across, start, end = wall.across / 100, wall.start / 100, wall.end / 100
    ends = ((start, across), (end, across)) if wall.horizontal else ((across, start), (across, end))
    openings = tuple(Opening(o.kind, o.start / 100, o.end / 100, o.bottom / 100, o.top / 100) for o in wall.openings)
    return Wall(*ends, WALL_THICKNESS / 100, openings)
