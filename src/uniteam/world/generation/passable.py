"""Whether the robot gets about in a home: everywhere in a tidy one, almost everywhere in one that is lived in."""

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.stretch import BASE_RADIUS
from uniteam.world.generation.plan.openings import WALL_THICKNESS
from uniteam.world.homes.home import Home, Room
from uniteam.world.homes.polygon import as_rectangle
from uniteam.world.physics.navigable_floor import CELL_SIZE, NavigableFloor

_ROOM_TO_STAND = 0.5
"""The robot's centre reaches at least so much of every room, without its doorways (m2)."""
_SHARE_TO_REACH = 0.3
"""And at least this share of where it could stand in the room: no furniture shuts the rest off."""
_SHARE_OF_ROOMS = 0.7
"""Of a home that is lived in, so many rooms can be entered; others are shut or blocked."""


def is_roomy(home: Home) -> bool:
    """Say whether the robot gets from every room into every other, and to a fair share of where it could stand."""
    return bool(_entered(home).all())


def is_passable(home: Home) -> bool:
    """Say whether the robot gets from one living room and kitchen into the other and into most rooms."""
    entered = _entered(home)
    day = [entered[i] for i, room in enumerate(home.stage.rooms) if room.kind in ("living_room", "kitchen", "hall")]
    return bool(all(day) and entered.mean() >= _SHARE_OF_ROOMS)


def _entered(home: Home) -> NDArray[np.bool_]:
    """Say of each room whether the robot gets into it from the largest part of the floor."""
    floor = NavigableFloor(home)
    reached = np.array([_area_within(floor, room, floor.largest_component) for room in home.stage.rooms])
    free = np.array([_area_within(floor, room, floor.free) for room in home.stage.rooms])
    return np.asarray(reached >= np.maximum(_ROOM_TO_STAND, _SHARE_TO_REACH * free))


def _area_within(floor: NavigableFloor, room: Room, cells: NDArray[np.bool_]) -> float:
    """Return how much of a room (m2) chosen cells of its floor fill, without those in its doorways.

    No robot stands nearer to the walls' centre lines than this but in a doorway.
    """
    border = BASE_RADIUS + WALL_THICKNESS / 200
    low = floor.to_cell(room.low[0] + border, room.low[1] + border)
    high = floor.to_cell(room.high[0] - border, room.high[1] - border)
    inside = cells[low[0] : high[0], low[1] : high[1]]
    if as_rectangle(room.outline) is None:
        inside = inside & _mask(floor, room, low, inside.shape)
    return float(inside.sum()) * CELL_SIZE**2


def _mask(floor: NavigableFloor, room: Room, low: tuple[int, int], shape: tuple[int, ...]) -> NDArray[np.bool_]:
    """Return which cells of a window, whose first cell is `low`, have their centres in a room."""
    mask = np.zeros(shape, np.uint8)
    corners = np.array([floor.to_cell(*corner)[::-1] for corner in room.outline], np.int32) - low[::-1]
    cv2.fillPoly(mask, [corners], 1)
    return np.asarray(mask > 0)
