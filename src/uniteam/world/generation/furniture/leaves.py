"""How the leaves of a home's doors stand: all folded back, or as people leave them."""

import math
from collections.abc import Callable, Iterable, Iterator, Sequence

import numpy as np
from numpy.random import Generator

from uniteam.world.assets.model import Model
from uniteam.world.generation.furniture.doors import fitting_leaves, open_leaves
from uniteam.world.generation.furniture.piece import Piece
from uniteam.world.generation.furniture.room_floor import RoomFloor
from uniteam.world.generation.plan.openings import WALL_THICKNESS, PlannedOpening, PlannedWall
from uniteam.world.generation.plan.planned_room import FloorPlan

HangDoors = Callable[
    [FloorPlan, Sequence[PlannedWall], Sequence[RoomFloor], Sequence[Model], Generator], list[list[Piece]]
]
"""Returns the leaves in each room, from a plan, its walls, its floors (which are taken from) and the models."""

_Way = tuple[int, Piece]

SHUT_CHANCE = 0.10
HALF_OPEN_CHANCE = 0.45
"""Of a door with a leaf, in a home that is lived in; the others are folded back."""
_HALF_OPEN = (62, 128)
_ALMOST_SHUT = (8, 40)
"""Degrees."""
_MAY_BE_SHUT = {"bedroom", "bathroom", "office", "laundry"}


def fold_back(
    plan: FloorPlan,
    walls: Sequence[PlannedWall],
    floors: Sequence[RoomFloor],
    models: Sequence[Model],
    rng: Generator,
) -> list[list[Piece]]:
    """Return every leaf folded back out of the way; a door whose leaf would be in the way has none."""
    leaves: list[list[Piece]] = [[] for _ in plan]
    for wall, opening, model in _doors(walls, models, rng):
        _hang_first_fitting(open_leaves(plan, wall, opening, model, rng), floors, leaves)
    return leaves


def leave_as_used(
    plan: FloorPlan,
    walls: Sequence[PlannedWall],
    floors: Sequence[RoomFloor],
    models: Sequence[Model],
    rng: Generator,
) -> list[list[Piece]]:
    """Return leaves as people leave them: most folded back, many standing half open, a few shut or almost."""
    leaves: list[list[Piece]] = [[] for _ in plan]
    for wall, opening, model in _doors(walls, models, rng):
        draw = rng.random()
        folded = list(open_leaves(plan, wall, opening, model, rng))
        room = folded[0][0]
        if draw < SHUT_CHANCE and plan[room].kind in _MAY_BE_SHUT:
            degrees = 0 if rng.random() < 0.5 else int(rng.integers(*_ALMOST_SHUT))
            leaves[room].append(_turned_leaf(wall, opening, model, room, degrees))
            continue
        if draw < SHUT_CHANCE + HALF_OPEN_CHANCE:
            leaf = _turned_leaf(wall, opening, model, room, int(rng.integers(*_HALF_OPEN)))
            if _stands_clear(leaf, floors[room], leaves[room]):
                _hang((room, leaf), floors, leaves)
                continue
        _hang_first_fitting(folded, floors, leaves)
    return leaves


def _doors(
    walls: Sequence[PlannedWall], models: Sequence[Model], rng: Generator
) -> Iterator[tuple[PlannedWall, PlannedOpening, Model]]:
    """Yield every door with the leaf that it has; doors of one width have leaves of one kind."""
    style = rng.permutation(1000)
    for wall in walls:
        for opening in wall.openings:
            fitting = fitting_leaves(models, opening) if opening.kind == "door" else []
            if fitting:
                yield wall, opening, fitting[int(style[len(fitting)]) % len(fitting)]


def _hang_first_fitting(ways: Iterable[_Way], floors: Sequence[RoomFloor], leaves: list[list[Piece]]) -> None:
    """Hang a door's leaf in the first way in which it is in nobody's way, if there is one."""
    found = next(((room, leaf) for room, leaf in ways if _has_space(floors[room], leaf)), None)
    if found is not None:
        _hang(found, floors, leaves)


def _hang(way: _Way, floors: Sequence[RoomFloor], leaves: list[list[Piece]]) -> None:
    room, leaf = way
    floors[room].take(leaf.volume, ())
    leaves[room].append(leaf)


def _has_space(floor: RoomFloor, leaf: Piece) -> bool:
    row = np.array([leaf.volume.as_row()], dtype=np.int64)
    return bool(floor.unobstructed(row)[0]) and floor.stays_passable(leaf.volume, ())


def _turned_leaf(wall: PlannedWall, opening: PlannedOpening, model: Model, room: int, degrees: int) -> Piece:
    """Return a leaf that hangs at the opening's start and is turned from shut into a room (degrees)."""
    half_width = 50.0 * model.size[0]
    away = 1 if room == wall.rooms[1] else -1
    along = wall.start + opening.start + math.cos(math.radians(degrees)) * half_width
    out = math.sin(math.radians(degrees)) * half_width + (WALL_THICKNESS / 2 if degrees else 0.0)
    across = wall.across + away * out
    x, y = (along, across) if wall.horizontal else (across, along)
    heading = away * degrees if wall.horizontal else 90 - away * degrees
    quarters = round(heading / 90)
    return Piece(model, round(x), round(y), quarters % 4, 0.0, heading - 90 * quarters)


def _stands_clear(leaf: Piece, floor: RoomFloor, others: Sequence[Piece]) -> bool:
    """Say whether a half-open leaf stands in its room, meets no other, and leaves a way to the other doors."""
    meets = any(leaf.rect.overlaps(other.rect) for other in others)
    cut = any(leaf.rect.overlaps(cut) for cut in floor.shape.cuts)
    return not meets and not cut and floor.inner.grown(12).contains(leaf.rect) and floor.stays_passable(leaf.volume, ())
