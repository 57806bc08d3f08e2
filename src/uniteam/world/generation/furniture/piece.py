"""A piece of furniture: a model in a room, in whole centimetres and quarter turns.

A model's front faces -y, so at zero turns its back is to the north.
"""

import math
from dataclasses import dataclass

from numpy.random import Generator

from uniteam.world.assets.model import Model
from uniteam.world.generation.furniture.room_floor import Volume
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
        turn = math.radians(abs(self.degrees))
        c, s = math.cos(turn), math.sin(turn)
        return _half_up(c * width + s * depth), _half_up(s * width + c * depth)

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
        top = math.ceil(round(self.z + 100 * self.model.size[2], 3))
        return Volume(self.rect, math.ceil(round(self.z, 3)), top)


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
        inner: the room's floor between the walls' faces.
        ceiling: its height (cm).
        windows: the volumes before them.
        anchor: the piece it is placed in relation to; None where a rule needs none.
        rng: for every choice.
    """

    inner: Rect
    ceiling: int
    windows: tuple[Volume, ...]
    anchor: Piece | None
    rng: Generator

    @property
    def the_anchor(self) -> Piece:
        """The anchor, for a proposal whose rule names one."""
        assert self.anchor is not None, "a rule with an anchor is tried only where one stands"
        return self.anchor
