"""What lies on the floor of a home that is lived in: shoes, toys, bags, boxes, laundry, in heaps and by themselves.

Most of it lies at walls and furniture, some in the way: the robot has to go around it, but nothing shuts a way.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from uniteam.geometry import Point2, yaw_quaternion
from uniteam.stretch import BASE_RADIUS
from uniteam.world.assets.model import Model
from uniteam.world.generation.objects.scatter import DROP
from uniteam.world.generation.objects.stock import ObjectStock
from uniteam.world.homes.home import Home, Instance, Room
from uniteam.world.physics.navigable_floor import CELL_SIZE, NavigableFloor

_TOYS = (
    "ball", "board_game", "doll", "puzzle_cube", "stuffed_toy", "toy_airplane", "toy_construction_set", "toy_vehicle",
    "xylophone", "action_figure",
)  # fmt: skip
_BAGS = ("backpack", "briefcase", "handbag")
_LAUNDRY = ("basket", "folded_clothes", "sock", "towel")

_BY_ROOM: Mapping[str, tuple[str, ...]] = {
    "hall": ("shoe", "shoe", "shoe", *_BAGS, "ball", "box", "basket", "umbrella"),
    "living_room": (*_TOYS, *_BAGS, "book", "box", "cushion", "game_controller", "newspaper", "shoe"),
    "bedroom": (*_TOYS, *_BAGS, *_LAUNDRY, "book", "cushion", "dumbbell", "shoe", "shoe"),
    "office": (*_BAGS, "basket", "book", "box", "dumbbell", "newspaper", "notebook"),
    "kitchen": ("basket", "bottle", "box", "paper_towel", "wine_bottle"),
    "dining_room": (*_TOYS, *_BAGS, "box"),
    "bathroom": ("basket", "folded_clothes", "scale", "toilet_brush", "towel"),
    "laundry": (*_LAUNDRY, "bottle", "box"),
}  # fmt: skip
_PER_AREA = 0.28
"""How many things lie on a square metre at most, beside the two that may lie in every room."""
_MOST_IN_ROOM = 8
_HEAP_CHANCE = 0.5
"""That a thing lies near the one before."""
_HEAP = 0.7
"""m."""
_AT_EDGE_CHANCE = 0.75
_EDGE = 0.25
"""What lies at a wall or at furniture is so near to it (m)."""
_GAP = 0.02
_TRIES, _TRIES_NEAR = 12, 240
"""How many places are tried for a thing, and for one that is to lie near another."""


_STRIDE = 3
_MOST_SHUT_OFF = 0.4
"""A thing may shut off so much of the floor (m2)."""


@dataclass(frozen=True)
class _Spot:
    x: float
    y: float
    radius: float


class _Ways:
    """Where the robot's centre can be, on every third cell of a floor."""

    def __init__(self, floor: NavigableFloor) -> None:
        self._floor = floor
        self._free = floor.largest_component[::_STRIDE, ::_STRIDE].astype(np.uint8)

    def lets_stand(self, spot: _Spot) -> bool:
        """Put a thing there unless it would shut a way, and say whether it stands."""
        row, column = self._floor.to_cell(spot.x, spot.y)
        reach = round((spot.radius + BASE_RADIUS) / CELL_SIZE / _STRIDE)
        left = self._free.copy()
        cv2.circle(left, (column // _STRIDE, row // _STRIDE), reach, 0, -1)
        _, _, stats, _ = cv2.connectedComponentsWithStats(left, connectivity=4)
        shut_off = (int(left.sum()) - int(stats[1:, cv2.CC_STAT_AREA].max(initial=0))) * (CELL_SIZE * _STRIDE) ** 2
        if shut_off <= _MOST_SHUT_OFF:
            self._free = left
        return shut_off <= _MOST_SHUT_OFF


def scatter_litter(home: Home, stock: ObjectStock, rng: Generator) -> tuple[Instance, ...]:
    """Return things a hair above the floor of a home that has no objects yet."""
    floor = NavigableFloor(home)
    ways = _Ways(floor)
    return tuple(thing for room in home.stage.rooms for thing in _RoomLitter(room, floor, ways, stock, rng).things())


def no_litter(home: Home, stock: ObjectStock, rng: Generator) -> tuple[Instance, ...]:
    """Return nothing: a tidy home's floor is clear."""
    return ()


@dataclass(frozen=True)
class _RoomLitter:
    """What lies on the floor of one room."""

    room: Room
    floor: NavigableFloor
    ways: _Ways
    stock: ObjectStock
    rng: Generator

    def things(self) -> Iterator[Instance]:
        """Yield what lies there."""
        categories = self.stock.known(_BY_ROOM.get(self.room.kind, ()))
        count = min(_MOST_IN_ROOM, int(self.rng.integers(0, 3 + int(_PER_AREA * self.room.area))))
        cells = self._free_cells()
        if not categories or len(cells) == 0:
            return
        placed: list[_Spot] = []
        for _ in range(count):
            model = self.stock.of(categories[int(self.rng.integers(len(categories)))], self.rng)
            spot = self._spot(model, cells, placed)
            if spot is not None and self.ways.lets_stand(spot):
                placed.append(spot)
                yield _lying(model, spot, self.room, self.rng)

    def _free_cells(self) -> NDArray[np.int64]:
        """Return (N, 2) cells on which nothing stands, a third of those in the rectangle around the room."""
        (top, left), (bottom, right) = (self.floor.to_cell(*corner) for corner in (self.room.low, self.room.high))
        cells = np.argwhere(self.floor.cells[top:bottom, left:right] > _GAP)[::3]
        return np.asarray(cells + np.array([top, left]))

    def _spot(self, model: Model, cells: NDArray[np.int64], placed: Sequence[_Spot]) -> _Spot | None:
        """Return where a thing may lie, or None where nothing was found."""
        radius = float(np.hypot(*model.size[:2])) / 2
        clear = self.floor.cells[cells[:, 0], cells[:, 1]]
        most = radius + (_EDGE if self.rng.random() < _AT_EDGE_CHANCE else np.inf)
        fitting = cells[(clear >= radius + _GAP) & (clear <= most)]
        near = placed[-1] if placed and self.rng.random() < _HEAP_CHANCE else None
        for row, column in self.rng.permutation(fitting)[: _TRIES if near is None else _TRIES_NEAR]:
            x, y = self.floor.to_point(row, column)
            is_near = near is None or np.hypot(x - near.x, y - near.y) <= _HEAP
            apart = all(np.hypot(x - other.x, y - other.y) >= radius + other.radius + _GAP for other in placed)
            if is_near and apart and self.room.contains(x, y):
                return _Spot(x, y, radius)
        return None


def _lying(model: Model, spot: _Spot, room: Room, rng: Generator) -> Instance:
    yaw = np.radians(int(rng.integers(360)))
    w, x, y, z = (round(q, 9) for q in yaw_quaternion(yaw))
    place: Point2 = (round(spot.x, 4), round(spot.y, 4))
    return Instance("", model.id, model.category, True, (*place, DROP), (w, x, y, z), room.name)
