"""Rooms and walls of a house.

AI2-THOR's walls have two sides without thickness, one a room; they become one wall of ours. It measures a hole from the
first of `wall0`'s floor corners (`polygonWallToSimpleWall` in its `ProceduralTools.cs`).
"""

import math
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import Literal

from uniteam.geometry import Point2, Point3
from uniteam.world.homes import polygon
from uniteam.world.homes.home import Light, Opening, Room, Stage, Wall
from uniteam.world.homes.readers.procthor.schema import Color, HoleEntry, House, Material, RoomEntry, WallEntry
from uniteam.world.homes.readers.procthor.unity_frame import floor_point

WALL_THICKNESS = 0.05
"""m; the houses' furniture keeps 0.05 m from the walls."""
AMBIENT = 0.45
LAMP_DEPTH = 0.3
"""How far below the ceiling a room's light hangs (m)."""
LOWEST_CEILING, HIGHEST_CEILING = 1.5, 20.0
_LINTEL = 0.02
"""Every opening ends at least so far below the ceiling (m)."""
_SHORTEST = 0.05
"""No opening or wall is shorter (m)."""
_SAME_LINE = 0.01
_EXTERIOR = "exterior"

_KINDS = {"Kitchen": "kitchen", "LivingRoom": "living_room", "Bedroom": "bedroom", "Bathroom": "bathroom"}
_FLOORS = (("carpet", "carpet_grey"), ("rug", "carpet_grey"), ("wood", "planks_oak"), ("marble", "linoleum"))
_TILES = "tiles_white_square"
_PAINT = "paint_matt"
_WHITE = (1.0, 1.0, 1.0)

Ends = tuple[Point2, Point2]
Kind = Literal["door", "passage", "window"]


@dataclass(frozen=True)
class Hole:
    """A door or window in the world: its two ends on the floor, and from where to where it reaches up (m)."""

    kind: Kind
    ends: Ends
    bottom: float
    top: float


class UnknownWallError(ValueError):
    """A hole in a wall that there is not."""


def stage_of(house: House) -> Stage:
    """Return the stage of a house; raises UnknownWallError."""
    height = max((corner.y for wall in house.walls for corner in wall.polygon), default=2.5)
    ceiling = min(max(height, LOWEST_CEILING), HIGHEST_CEILING)
    holes = list(_holes(house, ceiling))
    walls = tuple(_with_openings(wall, holes) for wall in _merged(house.walls))
    return Stage(tuple(_rooms(house, ceiling)), walls, ceiling)


def floor_ends(wall: WallEntry) -> Ends:
    """Return the two corners of a wall on the floor, the one first from which holes are measured (m, world)."""
    first, second = sorted(wall.polygon, key=lambda corner: corner.y)[:2]
    return floor_point(first), floor_point(second)


def _merged(walls: Iterable[WallEntry]) -> Iterator[Wall]:
    """Yield one wall for all that run between the same two corners; none where any of them is open."""
    found: dict[frozenset[tuple[int, int]], Ends] = {}
    opened = set()
    for wall in walls:
        ends = floor_ends(wall)
        key = frozenset((round(1_000 * x), round(1_000 * y)) for x, y in ends)
        found.setdefault(key, ends)
        if wall.empty:
            opened.add(key)
    for key, (start, end) in found.items():
        if key not in opened and math.dist(start, end) >= _SHORTEST:
            yield Wall(start, end, WALL_THICKNESS)


def _holes(house: House, ceiling: float) -> Iterator[Hole]:
    """Yield windows, and the doors between two rooms; those that lead outside stay shut."""
    walls = {wall.id: wall for wall in house.walls}
    for entry in house.doors:
        if _EXTERIOR not in (entry.wall0 + (entry.wall1 or _EXTERIOR)):
            yield _hole("passage" if entry.asset_id.startswith("Doorframe") else "door", entry, walls, ceiling)
    for entry in house.windows:
        yield _hole("window", entry, walls, ceiling)


def _hole(kind: Kind, entry: HoleEntry, walls: dict[str, WallEntry], ceiling: float) -> Hole:
    if entry.wall0 not in walls:
        raise UnknownWallError(f"'{entry.id}' is in the wall '{entry.wall0}', which there is not")
    (x0, y0), (x1, y1) = floor_ends(walls[entry.wall0])
    length = math.dist((x0, y0), (x1, y1))
    along = [0.0, 0.0] if length < _SHORTEST else [(x1 - x0) / length, (y1 - y0) / length]
    box = entry.bounding_box
    corners = entry.hole_polygon or ([box.min, box.max] if box is not None else [])
    if not corners:
        raise UnknownWallError(f"'{entry.id}' has neither a holePolygon nor a boundingBox")
    xs, ys = [corner.x for corner in corners], [corner.y for corner in corners]
    ends = [(x0 + s * along[0], y0 + s * along[1]) for s in (max(min(xs), 0.0), min(max(xs), length))]
    return Hole(
        kind, (ends[0], ends[1]), max(min(ys), 0.0) if kind == "window" else 0.0, min(max(ys), ceiling - _LINTEL)
    )


def _with_openings(wall: Wall, holes: Iterable[Hole]) -> Wall:
    """Return a wall with what of the holes lies on its line; of two that overlap the first."""
    kept: list[Opening] = []
    for opening in (_cut(wall, hole) for hole in holes):
        if opening is not None and all(opening.end <= o.start or o.end <= opening.start for o in kept):
            kept.append(opening)
    return replace(wall, openings=tuple(sorted(kept, key=lambda opening: opening.start)))


def _cut(wall: Wall, hole: Hole) -> Opening | None:
    length = math.dist(wall.start, wall.end)
    dx, dy = (wall.end[0] - wall.start[0]) / length, (wall.end[1] - wall.start[1]) / length
    offsets = [(x - wall.start[0], y - wall.start[1]) for x, y in hole.ends]
    if any(abs(dx * y - dy * x) > _SAME_LINE for x, y in offsets):
        return None
    low, high = sorted(dx * x + dy * y for x, y in offsets)
    start, end = max(low, 0.0), min(high, length)
    if end - start < _SHORTEST or hole.top - hole.bottom < _SHORTEST:
        return None
    return Opening(hole.kind, start, end, hole.bottom, hole.top)


def _rooms(house: House, ceiling: float) -> Iterator[Room]:
    numbers: Counter[str] = Counter()
    paints = {wall.room_id: _paint(wall) for wall in reversed(house.walls)}
    for entry in house.rooms:
        kind = _KINDS.get(entry.room_type, "room")
        numbers[kind] += 1
        outline = tuple(floor_point(corner) for corner in entry.floor_polygon)
        outline = outline if polygon.area(outline) > 0.0 else outline[::-1]
        tint = paints.get(entry.id, _WHITE)
        yield _room(f"{kind}_{numbers[kind]}", kind, outline, _floor(entry), tint, ceiling)


def _room(name: str, kind: str, outline: polygon.Polygon, floor: str, tint: Point3, ceiling: float) -> Room:
    x, y = polygon.middle(outline)
    return Room(name, kind, outline, floor, _PAINT, tint, Light((x, y, ceiling - LAMP_DEPTH), _WHITE, AMBIENT))


def _floor(entry: RoomEntry) -> str:
    material = entry.floor_material
    name = (material.name if isinstance(material, Material) else material) or ""
    return next((texture for word, texture in _FLOORS if word in name.lower()), _TILES)


def _paint(wall: WallEntry) -> Point3:
    color: Color | None = wall.material.color if isinstance(wall.material, Material) else wall.color
    return _WHITE if color is None else (color.r, color.g, color.b)
