"""Simple polygons as the polygons of rooms: (x, y) corners (m), counter-clockwise; they need not be convex."""

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import Point2

Polygon = tuple[Point2, ...]


def rectangle(low: Point2, high: Point2) -> Polygon:
    """Return the polygon of an axis-aligned rectangle, its lower left corner first."""
    return (low, (high[0], low[1]), high, (low[0], high[1]))


def as_rectangle(polygon: Polygon) -> tuple[Point2, Point2] | None:
    """Return the two corners that `rectangle` would make this polygon of, or None where there are none such."""
    if len(polygon) != 4:
        return None
    low, high = polygon[0], polygon[2]
    return (low, high) if polygon == rectangle(low, high) and low[0] < high[0] and low[1] < high[1] else None


def bounds(polygon: Polygon) -> tuple[Point2, Point2]:
    """Return the lower left and the upper right corner of the smallest axis-aligned rectangle around a polygon."""
    xs, ys = zip(*polygon, strict=True)
    return (min(xs), min(ys)), (max(xs), max(ys))


def area(polygon: Polygon) -> float:
    """Return the area (m2); negative where the polygon is clockwise."""
    return sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in _edges(polygon)) / 2.0


def contains(polygon: Polygon, x: float, y: float) -> bool:
    """Say whether a point is inside a polygon; a rectangle holds its whole border, another some of it."""
    corners = as_rectangle(polygon)
    if corners is not None:
        (x0, y0), (x1, y1) = corners
        return x0 <= x <= x1 and y0 <= y <= y1
    crossings = (
        (y0 > y) != (y1 > y) and x < x0 + (y - y0) * (x1 - x0) / (y1 - y0) for (x0, y0), (x1, y1) in _edges(polygon)
    )
    return sum(crossings) % 2 == 1


def middle(polygon: Polygon) -> Point2:
    """Return a point well inside: the middle of the bounds, or of the largest triangle where that lies outside."""
    (x0, y0), (x1, y1) = bounds(polygon)
    x, y = (x0 + x1) / 2, (y0 + y1) / 2
    if contains(polygon, x, y):
        return x, y
    corners = np.array(max(convex_pieces(polygon), key=area))
    cx, cy = corners.mean(axis=0)
    return float(cx), float(cy)


def convex_pieces(polygon: Polygon) -> tuple[Polygon, ...]:
    """Return the polygon itself where it is convex, else triangles that fill it, each counter-clockwise."""
    if all(_turn(*corner) >= 0.0 for corner in _corners(polygon)):
        return (polygon,)
    return tuple((polygon[a], polygon[b], polygon[c]) for a, b, c in triangles(polygon))


def triangles(polygon: Polygon) -> list[tuple[int, int, int]]:
    """Return triangles of corner indices that fill a simple polygon, by cutting off ears.

    The ear with the largest smallest angle goes first, so that few slivers remain (Meisters 1975: there is always one).
    """
    left = list(range(len(polygon)))
    cut: list[tuple[int, int, int]] = []
    while len(left) > 3:
        ears = [k for k in range(len(left)) if _is_ear(polygon, left, k)]
        best = max(ears, key=lambda k: _roundness(*(polygon[i] for i in _around(left, k))), default=0)
        cut.append(_around(left, best))
        del left[best]
    return [*cut, (left[0], left[1], left[2])]


def is_simple(polygon: Polygon) -> bool:
    """Say whether no two sides of a polygon meet but at their common corner, and none is shorter than a millimetre."""
    points = np.array(polygon)
    ends = np.roll(points, -1, axis=0)
    if (np.linalg.norm(ends - points, axis=1) < 1e-3).any():
        return False
    count = len(polygon)
    return not any(
        _cross(points[i], ends[i], points[j], ends[j])
        for i in range(count)
        for j in range(i + 2, count)
        if (j + 1) % count != i
    ) and all(_turn(*corner) != 0.0 or _goes_on(*corner) for corner in _corners(polygon))


def _edges(polygon: Polygon) -> Iterator[tuple[Point2, Point2]]:
    return pairwise((*polygon, polygon[0]))


def _corners(polygon: Polygon) -> Iterator[tuple[Point2, Point2, Point2]]:
    """Yield each corner between the one before and the one after."""
    return zip((polygon[-1], *polygon[:-1]), polygon, (*polygon[1:], polygon[0]), strict=True)


def _turn(a: Point2, b: Point2, c: Point2) -> float:
    """Return twice the area of a triangle; positive where it is counter-clockwise."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _goes_on(a: Point2, b: Point2, c: Point2) -> bool:
    return (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]) > 0.0


def _around(left: list[int], k: int) -> tuple[int, int, int]:
    return left[k - 1], left[k], left[(k + 1) % len(left)]


def _is_ear(polygon: Polygon, left: list[int], k: int) -> bool:
    a, b, c = (polygon[i] for i in _around(left, k))
    if _turn(a, b, c) <= 0.0:
        return False
    others = (polygon[i] for i in left if polygon[i] not in (a, b, c))
    return not any(_turn(a, b, p) >= 0.0 and _turn(b, c, p) >= 0.0 and _turn(c, a, p) >= 0.0 for p in others)


def _roundness(a: Point2, b: Point2, c: Point2) -> float:
    """Return the area of a triangle over the square of its longest side."""
    sides = [(p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2 for p, q in ((a, b), (b, c), (c, a))]
    return abs(_turn(a, b, c)) / max(*sides, 1e-12)


def _cross(a: NDArray[np.float64], b: NDArray[np.float64], c: NDArray[np.float64], d: NDArray[np.float64]) -> bool:
    """Say whether the segments ab and cd meet."""

    def side(p: NDArray[np.float64], q: NDArray[np.float64], r: NDArray[np.float64]) -> float:
        return float(np.sign((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])))

    apart = (max(a[0], b[0]) < min(c[0], d[0]) or max(c[0], d[0]) < min(a[0], b[0])) or (
        max(a[1], b[1]) < min(c[1], d[1]) or max(c[1], d[1]) < min(a[1], b[1])
    )
    return not apart and side(a, b, c) * side(a, b, d) <= 0.0 and side(c, d, a) * side(c, d, b) <= 0.0
