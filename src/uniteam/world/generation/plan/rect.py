"""An axis-aligned rectangle in whole centimetres."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Rect:
    """An axis-aligned rectangle, [x0, x1] by [y0, y1], in cm."""

    x0: int
    y0: int
    x1: int
    y1: int

    @property
    def width(self) -> int:
        """Extent along x (cm)."""
        return self.x1 - self.x0

    @property
    def depth(self) -> int:
        """Extent along y (cm)."""
        return self.y1 - self.y0

    @property
    def area(self) -> float:
        """Area in m2."""
        return self.width * self.depth / 1e4

    def overlaps(self, other: "Rect") -> bool:
        """Say whether the interiors meet."""
        return self.x0 < other.x1 and other.x0 < self.x1 and self.y0 < other.y1 and other.y0 < self.y1

    def contains(self, other: "Rect") -> bool:
        """Say whether the other lies inside, edges included."""
        return self.x0 <= other.x0 and self.y0 <= other.y0 and other.x1 <= self.x1 and other.y1 <= self.y1

    def grown(self, margin: int) -> "Rect":
        """Return the rectangle with every side moved out by `margin` (cm; negative shrinks)."""
        return Rect(self.x0 - margin, self.y0 - margin, self.x1 + margin, self.y1 + margin)

    def clipped(self, bounds: "Rect") -> "Rect":
        """Return what of the rectangle lies within another, which it meets."""
        return Rect(max(self.x0, bounds.x0), max(self.y0, bounds.y0), min(self.x1, bounds.x1), min(self.y1, bounds.y1))

    def shifted(self, x: int, y: int) -> "Rect":
        """Return the rectangle moved by x and y (cm)."""
        return Rect(self.x0 + x, self.y0 + y, self.x1 + x, self.y1 + y)
