"""Leaves for doors: the entrance is closed, the others stand open, folded back out of the way."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from numpy.random import Generator

from uniteam.world.assets.model import Model
from uniteam.world.generation.furniture.piece import Piece
from uniteam.world.generation.plan.openings import WALL_THICKNESS, PlannedOpening, PlannedWall
from uniteam.world.generation.plan.planned_room import FloorPlan
from uniteam.world.generation.plan.rect import Rect

_FROM_WALL = 1
"""Handles keep a leaf this far from what it is folded against (cm)."""
_SUNK = 5
"""How deep the entrance's leaf stands in its wall (cm)."""
_BEFORE_ENTRANCE = 80
_NEAR = 40
"""A door so near to a corner opens against the wall beside it (cm)."""


@dataclass(frozen=True)
class Entrance:
    """The home's closed front door.

    Attributes:
        room: index of the room it leads into.
        leaf: where it is.
        free: the floor before it.
    """

    room: int
    leaf: Piece
    free: Rect


def draw_entrance(plan: FloorPlan, walls: Sequence[PlannedWall], model: Model, rng: Generator) -> Entrance | None:
    """Return a front door in an outer wall of the hall, or of the living room where there is no hall."""
    kinds = [room.kind for room in plan]
    room = kinds.index("hall" if "hall" in kinds else "living_room")
    half_width, half_thickness = Piece(model, 0, 0, 0).half_size
    spots = [
        (wall, along)
        for wall in walls
        if wall.is_exterior and room in wall.rooms
        for along in range(half_width + 20, wall.length - half_width - 20, 10)
        if all(along + half_width + 15 < o.start or o.end < along - half_width - 15 for o in wall.openings)
    ]
    if not spots:
        return None
    wall, along = spots[int(rng.integers(len(spots)))]
    away = 1 if room == wall.rooms[1] else -1
    across = wall.across + away * (WALL_THICKNESS // 2 + half_thickness - _SUNK)
    leaf = _leaf(wall, model, wall.start + along, across, _back_across(wall, -away))
    opening = PlannedOpening("door", along - half_width, along + half_width, 0, 0)
    return Entrance(room, leaf, wall.stretch(opening, _BEFORE_ENTRANCE))


def open_leaves(
    plan: FloorPlan, wall: PlannedWall, opening: PlannedOpening, model: Model, rng: Generator
) -> Iterator[tuple[int, Piece]]:
    """Yield (room index, leaf) for every way a door may stand open: out of the hall first, into the smaller room."""
    rooms = [room for room in wall.rooms if room is not None]
    sides = sorted(rooms, key=lambda room: (plan[room].kind == "hall", plan[room].rect.area))
    ends = (opening.start, opening.end) if rng.random() < 0.5 else (opening.end, opening.start)
    for room in sides:
        upward = room == wall.rooms[1]
        for hinge in ends:
            outward = -1 if hinge == opening.start else 1
            if _distance_to_corner(wall, hinge, outward, plan[room].rect) <= _NEAR:
                yield room, _along_side_wall(wall, model, hinge, outward, upward)
            yield room, _flat_on_wall(wall, model, hinge, outward, upward)


def _distance_to_corner(wall: PlannedWall, hinge: int, outward: int, room: Rect) -> int:
    """Return how far (cm) a hinge is from the room's corner on its side."""
    low, high = (room.x0, room.x1) if wall.horizontal else (room.y0, room.y1)
    return wall.start + hinge - low if outward < 0 else high - wall.start - hinge


def _along_side_wall(wall: PlannedWall, model: Model, hinge: int, outward: int, upward: bool) -> Piece:
    """Return the leaf opened by a right angle.

    Args:
        wall: with the door.
        model: of the leaf.
        hinge: where along the wall it hangs (cm).
        outward: the direction along the wall that leads away from the opening.
        upward: whether it opens to the wall's upper (or right) side.
    """
    half_width, half_thickness = Piece(model, 0, 0, 0).half_size
    along = wall.start + hinge + outward * (half_thickness + 1)
    across = wall.across + (1 if upward else -1) * (WALL_THICKNESS // 2 + half_width + 2)
    return _leaf(wall, model, along, across, _back_along(wall, outward))


def _flat_on_wall(wall: PlannedWall, model: Model, hinge: int, outward: int, upward: bool) -> Piece:
    """Return the leaf folded back all the way; arguments as of `_along_side_wall`."""
    half_width, half_thickness = Piece(model, 0, 0, 0).half_size
    away = 1 if upward else -1
    along = wall.start + hinge + outward * (half_width + 2)
    across = wall.across + away * (WALL_THICKNESS // 2 + half_thickness + _FROM_WALL)
    return _leaf(wall, model, along, across, _back_across(wall, -away))


def _leaf(wall: PlannedWall, model: Model, along: int, across: int, quarters: int) -> Piece:
    x, y = (along, across) if wall.horizontal else (across, along)
    return Piece(model, x, y, quarters)


def _back_along(wall: PlannedWall, direction: int) -> int:
    """Return the quarter turns that turn a model's back to one end of the wall."""
    if wall.horizontal:
        return 1 if direction < 0 else 3
    return 2 if direction < 0 else 0


def _back_across(wall: PlannedWall, direction: int) -> int:
    """Return the quarter turns that turn a model's back across the wall, to its lower or its upper side."""
    if wall.horizontal:
        return 2 if direction < 0 else 0
    return 1 if direction < 0 else 3


def fitting_leaves(models: Sequence[Model], opening: PlannedOpening) -> list[Model]:
    """Return the leaves that close an opening with a hand's breadth of frame at most."""
    width, height = opening.end - opening.start, opening.top
    return [m for m in models if width - 16 <= 100 * m.size[0] <= width + 2 and 100 * m.size[2] <= height + 2]
