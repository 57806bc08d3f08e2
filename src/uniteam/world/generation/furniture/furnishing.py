"""Furnish a planned home: apply each room's rules on its floor, keeping its doors and its things within reach."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice

import numpy as np
from numpy.random import Generator

from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import Model, Pool
from uniteam.world.generation.furniture.doors import Entrance, draw_entrance
from uniteam.world.generation.furniture.kinds import models_of_kind
from uniteam.world.generation.furniture.leaves import HangDoors
from uniteam.world.generation.furniture.piece import Piece, Site
from uniteam.world.generation.furniture.room_floor import RoomFloor, Volume, standing_strip
from uniteam.world.generation.furniture.rules import Rule
from uniteam.world.generation.plan.openings import WALL_THICKNESS, PlannedWall
from uniteam.world.generation.plan.planned_room import FloorPlan, PlannedRoom
from uniteam.world.generation.plan.rect import Rect

_TRIES = 12
_OPEN_SIDED = {"bed", "table", "chair", "stool", "bench", "hamper", "trunk", "bathtub", "serving_cart", "stand"}
"""Classes that can be used from any side; the others only from their front."""

_USED_FROM_FRONT = {"refrigerator", "oven", "dishwasher", "shower", "fireplace", "piano", "radiator"}
"""Decor that must not be walled in."""

Sides = Callable[[Piece], tuple[Rect, ...]]
"""Where the robot may stand to get at a piece; one of these places is kept free."""


@dataclass(frozen=True)
class FurnishedRoom:
    """A room and what stands in it, in the order it was put there."""

    room: PlannedRoom
    pieces: tuple[Piece, ...]


@dataclass(frozen=True)
class FurnitureShop:
    """Where models come from: the catalogue, one pool of it."""

    catalogue: Catalogue
    pool: Pool

    @property
    def doors(self) -> tuple[Model, ...]:
        """The leaves of doors, sorted by id."""
        return self.catalogue.of_category("door", self.pool) or self.catalogue.of_category("door")

    def choose(self, kind: str, rng: Generator) -> Model | None:
        """Return a model of a kind, or None where the catalogue has none."""
        models = models_of_kind(self.catalogue, kind, self.pool)
        return models[int(rng.integers(len(models)))] if models else None


@dataclass(frozen=True)
class FurnishingStyle:
    """How rooms are furnished.

    Attributes:
        rules: of each kind of room.
        door_depth: how deep the floor before a door is kept free (cm).
        hang_doors: how the leaves of doors stand.
        is_kept_in_reach: draws whether one side of a piece that holds things must stay within the robot's reach.
    """

    rules: Mapping[str, tuple[Rule, ...]]
    door_depth: int
    hang_doors: HangDoors
    is_kept_in_reach: Callable[[Generator], bool]


@dataclass(frozen=True)
class HomeFurnisher:
    """Furnishes the rooms of a plan.

    Attributes:
        style: how.
        shop: where the models come from.
        ceiling: its height (cm).
        rng: for every choice.
    """

    style: FurnishingStyle
    shop: FurnitureShop
    ceiling: int
    rng: Generator

    def furnish(self, plan: FloorPlan, walls: Sequence[PlannedWall]) -> tuple[FurnishedRoom, ...]:
        """Return every room with its furniture, after its doors have their leaves."""
        doors, rng = self.shop.doors, self.rng
        entrance = draw_entrance(plan, walls, doors[int(rng.integers(len(doors)))], rng) if doors else None
        depth = self.style.door_depth
        floors = [bare_floor(index, room, walls, depth, entrance) for index, room in enumerate(plan)]
        leaves = self.style.hang_doors(plan, walls, floors, doors, rng)
        if entrance is not None:
            leaves[entrance.room].append(entrance.leaf)
        return tuple(
            FurnishedRoom(room, (*leaves[index], *_RoomFurnisher(room, floors[index], self).furnish()))
            for index, room in enumerate(plan)
        )


def bare_floor(
    index: int, room: PlannedRoom, walls: Sequence[PlannedWall], door_depth: int, entrance: Entrance | None
) -> RoomFloor:
    """Return the floor of a room, with the strips before its doors (`door_depth` cm) and its windows kept free."""
    shape = room.floor.shrunk(WALL_THICKNESS // 2)
    inner = shape.rect
    doors, windows = [], []
    for wall in walls:
        for opening in wall.openings if index in wall.rooms else ():
            if opening.kind == "window":
                windows.append(Volume(wall.stretch(opening, 25), opening.bottom, opening.top))
            else:
                doors.append(wall.stretch(opening, door_depth).clipped(inner))
    if entrance is not None and entrance.room == index:
        doors.append(entrance.free.clipped(inner))
    return RoomFloor(shape, doors, windows)


class _RoomFurnisher:
    """Furnishes one room."""

    def __init__(self, room: PlannedRoom, floor: RoomFloor, home: HomeFurnisher) -> None:
        self._room, self._floor, self._style = room, floor, home.style
        self._shop, self._ceiling, self._rng = home.shop, home.ceiling, home.rng
        self._standing: list[tuple[str, Piece]] = []

    def furnish(self) -> Iterator[Piece]:
        """Apply the room's rules in order and yield what stands at the end."""
        for rule in self._style.rules[self._room.kind]:
            if self._rng.random() < rule.chance and self._room.rect.area >= rule.min_area:
                self._apply(rule)
        return (piece for _, piece in self._standing)

    def _apply(self, rule: Rule) -> None:
        if rule.only_if_none and any(kind in rule.kinds for kind, _ in self._standing):
            return
        wanted = int(self._rng.integers(rule.count[0], rule.count[1] + 1))
        for kind in rule.kinds:
            count = 0
            model = self._shop.choose(kind, self._rng)
            for _ in range(wanted):
                if model is not None and self._put(rule, kind, model):
                    count += 1
                if not rule.one_model:
                    model = self._shop.choose(kind, self._rng)
            if count:
                return

    def _put(self, rule: Rule, kind: str, model: Model) -> bool:
        for anchor in self._anchors(rule):
            site = Site(self._floor.shape, self._ceiling, self._floor.windows, anchor, self._rng)
            sides = _sides if self._style.is_kept_in_reach(self._rng) else _no_sides
            piece = self._first_fitting(list(rule.arrange(site, model)), rule, sides)
            if piece is not None:
                if not _is_flat(model):
                    self._floor.take(piece.volume, sides(piece))
                self._standing.append((kind, piece))
                return True
        return False

    def _anchors(self, rule: Rule) -> list[Piece | None]:
        if not rule.anchors:
            return [None]
        return [piece for kind, piece in self._standing if kind in rule.anchors]

    def _first_fitting(self, pieces: list[Piece], rule: Rule, sides: Sides) -> Piece | None:
        if not pieces:
            return None
        if _is_flat(pieces[0].model):
            return next((p for p in pieces if self._floor.inner.contains(p.rect)), None)
        rows = np.array([piece.as_row() for piece in pieces], dtype=np.int64)
        fits = self._floor.unobstructed(rows, rule.elbow_room) & (rows[:, 5] <= self._ceiling)
        if not rule.covers_window:
            fits &= self._floor.lets_light_in(rows)
        passable = (
            pieces[i]
            for i in islice(np.flatnonzero(fits).tolist(), _TRIES)
            if self._floor.stays_passable(pieces[i].volume, sides(pieces[i]))
        )
        return next(passable, None)


def _is_flat(model: Model) -> bool:
    """Say whether a model is a rug or a mat, which other furniture may stand on."""
    return not model.shapes and model.size[2] < 0.04


def _sides(piece: Piece) -> tuple[Rect, ...]:
    """Return where the robot may stand to get at a piece; nothing for what only decorates."""
    category = piece.model.category
    if piece.model.role != "receptacle" and category not in _USED_FROM_FRONT:
        return ()
    if category not in _OPEN_SIDED:
        return (standing_strip(piece.rect, piece.front),)
    return tuple(standing_strip(piece.rect, step) for step in ((1, 0), (-1, 0), (0, 1), (0, -1)))


def _no_sides(piece: Piece) -> tuple[Rect, ...]:
    return ()
