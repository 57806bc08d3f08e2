"""How wide the ways through a home are, and what on them a base can get to.

The way into a room is the widest of all ways there from the home's largest room: its narrowest place decides.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import transform_points
from uniteam.stretch import BASE_RADIUS
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES
from uniteam.world.homes.home import Home, Instance, Room
from uniteam.world.physics.navigable_floor import NavigableFloor

REACH = 0.7
"""The base gets to a receptacle where its centre can stand so near to its rectangle, in the same room (m)."""

_FINEST = 0.01
_WIDEST = 1.2
_STEP = 0.04
"""How far apart (m) the points are from which a receptacle's distance is taken."""


@dataclass(frozen=True)
class Passages:
    """What a survey of a home's ways found.

    Attributes:
        widths: how wide the way into each room is (m), by its name, to within 4 cm, at most 2.4; the
            largest room's is not there.
        reached: whether a base gets to each receptacle, by its name.
    """

    widths: Mapping[str, float]
    reached: Mapping[str, bool]

    @cached_property
    def narrowest(self) -> tuple[str, float] | None:
        """The room with the narrowest way that lets the base through, and its width (m); None where there is none."""
        passable = {name: width for name, width in self.widths.items() if width >= 2 * BASE_RADIUS}
        return min(passable.items(), key=lambda pair: pair[1], default=None)

    @property
    def shut(self) -> tuple[str, ...]:
        """The rooms that the base does not get into."""
        return tuple(name for name, width in self.widths.items() if width < 2 * BASE_RADIUS)


def survey(home: Home) -> Passages:
    """Return how a base of `BASE_RADIUS` gets about in a home."""
    floor = NavigableFloor(home)
    largest, *others = sorted(home.stage.rooms, key=lambda room: -room.area)
    start = _roomiest(floor, largest)
    widths = {room.name: _width(floor, start, _roomiest(floor, room)) for room in others}
    receptacles = [i for i in home.instances if i.category in RECEPTACLE_CATEGORIES and not i.movable]
    return Passages(widths, {i.name: _is_reached(home, floor, i) for i in receptacles})


def _window(floor: NavigableFloor, room: Room) -> tuple[slice, slice]:
    (top, left), (bottom, right) = floor.to_cell(*room.low), floor.to_cell(*room.high)
    return slice(top, bottom + 1), slice(left, right + 1)


def _roomiest(floor: NavigableFloor, room: Room) -> tuple[int, int]:
    """Return the cell of a room that is farthest from everything."""
    rows, columns = _window(floor, room)
    cells = floor.cells[rows, columns]
    for index in np.argsort(-cells, axis=None, kind="stable"):
        row, column = divmod(int(index), cells.shape[1])
        if room.contains(*floor.to_point(rows.start + row, columns.start + column)):
            break
    return rows.start + row, columns.start + column


def _width(floor: NavigableFloor, start: tuple[int, int], end: tuple[int, int]) -> float:
    """Return the width (m) of the widest way between two cells."""
    low, high = 0.0, _WIDEST
    while high - low > _FINEST / 2:
        middle = (low + high) / 2
        _, labels = cv2.connectedComponents((floor.cells >= middle).astype(np.uint8), connectivity=4)
        joined = labels[start] == labels[end] != 0
        low, high = (middle, high) if joined else (low, middle)
    return round(2 * low, 2)


def _is_reached(home: Home, floor: NavigableFloor, piece: Instance) -> bool:
    """Say whether the base's centre can come within `REACH` of a receptacle's rectangle, in the receptacle's room."""
    width, depth, _ = home.model_of(piece).size
    room = next(room for room in home.stage.rooms if room.name == piece.room)
    edge = np.arange(-REACH, REACH + _STEP, _STEP)
    xs = np.concatenate([edge - width / 2, np.arange(-width / 2, width / 2, _STEP), edge + width / 2])
    ys = np.concatenate([edge - depth / 2, np.arange(-depth / 2, depth / 2, _STEP), edge + depth / 2])
    around = np.stack(np.meshgrid(xs, ys), axis=-1).reshape(-1, 2)
    outside = np.maximum(np.abs(around) - (width / 2, depth / 2), 0.0)
    near = around[np.hypot(*outside.T) <= REACH]
    points = transform_points(piece.model_to_world(), np.column_stack([near, np.zeros(len(near))]))[:, :2]
    return any(room.contains(*point) for point in points[_on_largest_part(floor, points)])


def _on_largest_part(floor: NavigableFloor, points: NDArray[np.float64]) -> NDArray[np.bool_]:
    cells = np.array([floor.to_cell(*point) for point in points])
    inside = np.all((cells >= 0) & (cells < floor.cells.shape), axis=1)
    rows, columns = np.where(inside[:, None], cells, 0).T
    return np.asarray(inside & floor.largest_component[rows, columns])
