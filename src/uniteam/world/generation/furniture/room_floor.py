"""What of a room is taken, and whether the robot still gets to its doors and to everything that holds things.

Whole centimetres. Things are boxes aligned with the room; the way of a disc of the robot's radius is followed on a grid
of 5 cm, on which every box is grown by that radius (square at the corners, so a little to the safe side).
"""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.world.generation.plan.floor_shape import FloorShape
from uniteam.world.generation.plan.rect import Rect

CELL = 5
ROBOT_RADIUS = 31
ROBOT_TOP = 141
_REACH = 48
"""How far from a thing's side the robot's centre may stand to get at it (cm)."""
_FOOTHOLD = 25
"""How much room along that side it needs there (cm)."""
_TOP_OF_WALLS = 1000


@dataclass(frozen=True)
class Volume:
    """A box: its rectangle on the floor, and from `bottom` to `top` above it (cm)."""

    rect: Rect
    bottom: int
    top: int

    def as_row(self) -> tuple[int, int, int, int, int, int]:
        """Return (x0, y0, bottom, x1, y1, top)."""
        return (self.rect.x0, self.rect.y0, self.bottom, self.rect.x1, self.rect.y1, self.top)


class RoomFloor:
    """A room while it is being furnished.

    Attributes:
        shape: the floor between the walls' faces.
        inner: the rectangle around it.
        doors: rectangles on the floor before the doors, inside the room.
        windows: volumes before the windows.
    """

    def __init__(self, shape: FloorShape, doors: Iterable[Rect], windows: Iterable[Volume]) -> None:
        """Start with an empty room.

        Args:
            shape: the floor between the walls' faces.
            doors: rectangles on the floor before the doors, inside the room; nothing may stand there.
            windows: volumes before windows; only what belongs at a window may stand there.
        """
        self.shape = shape
        self.inner = inner = shape.rect
        self.doors = tuple(doors)
        self.windows = tuple(windows)
        walls = (Volume(cut, 0, _TOP_OF_WALLS) for cut in shape.cuts)
        self._volumes = _as_rows((*(Volume(door, 0, 210) for door in self.doors), *walls))
        rows, columns = -(-inner.depth // CELL), -(-inner.width // CELL)
        self._free = np.zeros((rows, columns), dtype=np.uint8)
        self._free[self._cells(inner.grown(-ROBOT_RADIUS))] = 1
        for cut in shape.cuts:
            self._free[self._cells(cut.grown(ROBOT_RADIUS))] = 0
        self._sides: list[tuple[tuple[slice, slice], ...]] = []

    def _cells(self, rect: Rect) -> tuple[slice, slice]:
        """Return the rows and columns of the cells whose centres lie in a rectangle."""
        rows = slice(*(max(0, -(-(2 * (y - self.inner.y0) - CELL) // (2 * CELL))) for y in (rect.y0, rect.y1)))
        columns = slice(*(max(0, -(-(2 * (x - self.inner.x0) - CELL) // (2 * CELL))) for x in (rect.x0, rect.x1)))
        return rows, columns

    def unobstructed(self, volumes: NDArray[np.int64], elbow_room: int = 0) -> NDArray[np.bool_]:
        """Say which of (N, 6) volumes lie inside the room and come no nearer than `elbow_room` (cm) to anything."""
        inner = self.inner
        low, high = volumes[:, :3], volumes[:, 3:]
        inside = (low[:, 0] >= inner.x0) & (low[:, 1] >= inner.y0) & (high[:, 0] <= inner.x1) & (high[:, 1] <= inner.y1)
        margin = np.array([elbow_room, elbow_room, 0])
        return inside & ~_meet_any(low - margin, high + margin, self._volumes)

    def lets_light_in(self, volumes: NDArray[np.int64]) -> NDArray[np.bool_]:
        """Say which of (N, 6) volumes stand before no window."""
        return ~_meet_any(volumes[:, :3], volumes[:, 3:], _as_rows(self.windows))

    def stays_passable(self, volume: Volume, sides: Iterable[Rect]) -> bool:
        """Say whether, with this volume taken, all doors and all held sides are still reached, these sides too."""
        free = self._free
        if volume.bottom < ROBOT_TOP:
            free = free.copy()
            free[self._cells(volume.rect.grown(ROBOT_RADIUS))] = 0
        _, components = cv2.connectedComponents(free, connectivity=4)
        reached = self._reached(np.asarray(components))
        if reached is None:
            return False
        wanted = [*self._sides, tuple(self._cells(side) for side in sides)]
        return all(
            not slots or any(_has_foothold(reached[rows, columns]) for rows, columns in slots) for slots in wanted
        )

    def _reached(self, components: NDArray[Any]) -> NDArray[np.bool_] | None:
        """Return the cells that every door leads to, or None where two doors do not lead to each other."""
        labels = None
        for door in self.doors:
            here = set(np.unique(components[self._cells(door)]).tolist()) - {0}
            labels = here if labels is None else labels & here
        if labels is None:
            return components > 0
        return np.isin(components, sorted(labels)) if labels else None

    def take(self, volume: Volume, sides: Iterable[Rect]) -> None:
        """Put a thing there for good; one of its sides, if it has any, is to stay within reach."""
        self._volumes = np.vstack([self._volumes, volume.as_row()])
        if volume.bottom < ROBOT_TOP:
            self._free[self._cells(volume.rect.grown(ROBOT_RADIUS))] = 0
        self._sides.append(tuple(self._cells(side) for side in sides))


def _as_rows(volumes: Iterable[Volume]) -> NDArray[np.int64]:
    return np.array([volume.as_row() for volume in volumes], dtype=np.int64).reshape(-1, 6)


def _meet_any(low: NDArray[np.int64], high: NDArray[np.int64], others: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Say which of the boxes from `low` to `high`, (N, 3) each, meet any of (M, 6) others."""
    meets = (low[:, None] < others[None, :, 3:]) & (others[None, :, :3] < high[:, None])
    return np.any(np.all(meets, axis=2), axis=1)


def _has_foothold(cells: NDArray[np.bool_]) -> bool:
    """Say whether enough of a strip's length is reached."""
    if cells.size == 0:
        return False
    along = np.any(cells, axis=0) if cells.shape[1] >= cells.shape[0] else np.any(cells, axis=1)
    return int(along.sum()) * CELL >= min(_FOOTHOLD, CELL * along.size)


def standing_strip(rect: Rect, direction: tuple[int, int]) -> Rect:
    """Return where the robot's centre may stand to get at the side of `rect` that faces `direction`, a unit step."""
    dx, dy = direction
    if dx:
        edge = rect.x1 if dx > 0 else rect.x0
        near, far = sorted((edge + dx * ROBOT_RADIUS, edge + dx * _REACH))
        return Rect(near, rect.y0, far, rect.y1)
    edge = rect.y1 if dy > 0 else rect.y0
    near, far = sorted((edge + dy * ROBOT_RADIUS, edge + dy * _REACH))
    return Rect(rect.x0, near, rect.x1, far)
