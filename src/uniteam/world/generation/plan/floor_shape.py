"""The floor of a room in whole centimetres: a rectangle, without the rectangles that are cut out of its corners."""

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

from uniteam.world.generation.plan.rect import Rect

Corner = tuple[int, int]


@dataclass(frozen=True)
class WallRun:
    """A straight stretch of wall, seen from the floor before it.

    Attributes:
        quarters: the quarter turns that turn a model's back to it: 0 where it is in the north, then to the left.
        start, end: along x or y (cm).
        line: where it is on the other axis (cm).
    """

    quarters: int
    start: int
    end: int
    line: int


@dataclass(frozen=True)
class FloorShape:
    """A rectangle without its cut-out corners.

    Attributes:
        rect: the rectangle around the floor.
        cuts: what of it is not of the floor: rectangles at its corners, one at a corner at most; they do not touch.
    """

    rect: Rect
    cuts: tuple[Rect, ...] = ()

    def shrunk(self, margin: int) -> "FloorShape":
        """Return the floor without a strip `margin` wide along its border (cm)."""
        inner = self.rect.grown(-margin)
        return FloorShape(inner, tuple(cut.grown(margin).clipped(inner) for cut in self.cuts))

    @property
    def area(self) -> float:
        """m2."""
        return self.rect.area - sum(cut.area for cut in self.cuts)

    @cached_property
    def parts(self) -> tuple[Rect, ...]:
        """Rectangles that fill the floor, side by side, from the lowest to the highest."""
        if not self.cuts:
            return (self.rect,)
        rect = self.rect
        levels = sorted({rect.y0, rect.y1, *(y for cut in self.cuts for y in (cut.y0, cut.y1))})
        return tuple(self._band(low, high) for low, high in pairwise(levels))

    @cached_property
    def heart(self) -> Rect:
        """The largest rectangle in the floor that reaches over its whole width or its whole depth, or the rectangle."""
        if not self.cuts:
            return self.rect
        rect = self.rect
        turned = FloorShape(_swapped(rect), tuple(_swapped(cut) for cut in self.cuts))
        return max((*self._full_bands(), *(_swapped(band) for band in turned._full_bands())), key=lambda r: r.area)

    @cached_property
    def outline(self) -> tuple[Corner, ...]:
        """The corners, counter-clockwise, those at the lower left first."""
        x0, y0, x1, y1 = self.rect.x0, self.rect.y0, self.rect.x1, self.rect.y1
        corners: list[Corner] = []
        for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1)):
            cut = next((c for c in self.cuts if x in (c.x0, c.x1) and y in (c.y0, c.y1)), None)
            corners += [(x, y)] if cut is None else _around_cut(cut, x, y, x == x0, y == y0)
        return tuple(corners)

    @cached_property
    def runs(self) -> tuple[WallRun, ...]:
        """The stretches of wall around the floor, in the order of their quarters."""
        outline = self.outline
        runs = [_run(start, end) for start, end in pairwise((*outline, outline[0]))]
        return tuple(sorted(runs, key=lambda run: run.quarters))

    def _band(self, low: int, high: int) -> Rect:
        """Return what of the floor lies between two levels that no cut begins or ends between."""
        x0, x1 = self.rect.x0, self.rect.x1
        for cut in self.cuts:
            if cut.y0 < high and low < cut.y1:
                x0, x1 = (cut.x1, x1) if cut.x0 == self.rect.x0 else (x0, cut.x0)
        return Rect(x0, low, x1, high)

    def _full_bands(self) -> tuple[Rect, ...]:
        """Return the band over the whole depth and the bands over the whole width."""
        x0 = max((cut.x1 for cut in self.cuts if cut.x0 == self.rect.x0), default=self.rect.x0)
        x1 = min((cut.x0 for cut in self.cuts if cut.x1 == self.rect.x1), default=self.rect.x1)
        return (Rect(min(x0, x1), self.rect.y0, x1, self.rect.y1), *self.parts)


def _swapped(rect: Rect) -> Rect:
    return Rect(rect.y0, rect.x0, rect.y1, rect.x1)


def _around_cut(cut: Rect, x: int, y: int, at_left: bool, at_bottom: bool) -> list[Corner]:
    """Return the three corners that a cut at the corner (x, y) leaves, counter-clockwise around the floor."""
    far_x, far_y = (cut.x1 if at_left else cut.x0), (cut.y1 if at_bottom else cut.y0)
    inward = [(x, far_y), (far_x, far_y), (far_x, y)]
    return inward if at_left == at_bottom else inward[::-1]


def _run(start: Corner, end: Corner) -> WallRun:
    (ax, ay), (bx, by) = start, end
    if ay == by:
        return WallRun(2 if bx > ax else 0, min(ax, bx), max(ax, bx), ay)
    return WallRun(3 if by > ay else 1, min(ay, by), max(ay, by), ax)
