"""A piece of furniture: a model in a room, in whole centimetres and quarter turns.

A model's front faces -y, so at zero turns its back is to the north.
"""

import math
from dataclasses import dataclass
from functools import lru_cache

from numpy.random import Generator

from uniteam.world.assets.model import Model
from uniteam.world.generation.furniture.room_floor import Volume
from uniteam.world.generation.plan.floor_shape import FloorShape
from uniteam.world.generation.plan.rect import Rect


@dataclass(frozen=True)
class Piece:
    """A model at (x, y, z) cm, turned by `quarters` of a turn to the left and `degrees` more."""

    model: Model
    x: int
    y: int
    quarters: int
    z: float = 0.0
    degrees: int = 0

    @property
    def half_size(self) -> tuple[int, int]:
        """Half the width and half the depth in the model's own frame, rounded up, with room to turn by `degrees`."""
        width, depth, _ = self.model.size
        return _half_size(width, depth, abs(self.degrees))

    def offset(self, right: int, back: int) -> tuple[int, int]:
        """Return the point of the room at (right, back) cm in the model's own frame."""
        dx, dy = turned(self.quarters, right, back)
        return self.x + dx, self.y + dy

    @property
    def front(self) -> tuple[int, int]:
        """The unit step that the front faces."""
        return turned(self.quarters, 0, -1)

    @property
    def rect(self) -> Rect:
        """The rectangle it covers on the floor."""
        hx, hy = self.half_size
        if self.quarters % 2:
            hx, hy = hy, hx
        return Rect(self.x - hx, self.y - hy, self.x + hx, self.y + hy)

    @property
    def volume(self) -> Volume:
        """The box it fills."""
        return Volume(self.rect, *_levels(self.z, self.model.size[2]))

    def as_row(self) -> tuple[int, int, int, int, int, int]:
        """Return the row of its volume, faster."""
        hx, hy = self.half_size[:: -1 if self.quarters % 2 else 1]
        bottom, top = _levels(self.z, self.model.size[2])
        return (self.x - hx, self.y - hy, bottom, self.x + hx, self.y + hy, top)


@lru_cache(maxsize=4096)
def _half_size(width: float, depth: float, degrees: int) -> tuple[int, int]:
    turn = math.radians(degrees)
    c, s = math.cos(turn), math.sin(turn)
    return _half_up(c * width + s * depth), _half_up(s * width + c * depth)


@lru_cache(maxsize=4096)
def _levels(z: float, height: float) -> tuple[int, int]:
    """Return the bottom and the top of what stands at `z` (cm) and is so high (m)."""
    return math.ceil(round(z, 3)), math.ceil(round(z + 100 * height, 3))


def _half_up(length: float) -> int:
    return math.ceil(round(50 * length, 3))


def turned(quarters: int, x: int, y: int) -> tuple[int, int]:
    """Return a vector turned to the left by quarters."""
    for _ in range(quarters % 4):
        x, y = -y, x
    return x, y


@dataclass(frozen=True)
class Site:
    """What a proposal may look at.

    Attributes:
        floor: the room's, between the walls' faces.
        ceiling: its height (cm).
        windows: the volumes before them.
        anchor: the piece it is placed in relation to; None where a rule needs none.
        rng: for every choice.
    """

    floor: FloorShape
    ceiling: int
    windows: tuple[Volume, ...]
    anchor: Piece | None
    rng: Generator

    @property
    def the_anchor(self) -> Piece:
        """The anchor, for a proposal whose rule names one."""
        assert self.anchor is not None, "a rule with an anchor is tried only where one stands"
        return self.anchor
