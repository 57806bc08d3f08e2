"""Where a piece of furniture may stand: each function proposes pieces in a room, the best first.

Everything here proposes; what is taken and what stays passable is for `RoomFloor` to say.
"""

from collections.abc import Iterator
from dataclasses import replace

from uniteam.world.assets.model import Model
from uniteam.world.generation.furniture.piece import Piece, Site, turned
from uniteam.world.generation.furniture.room_floor import Volume
from uniteam.world.generation.plan.rect import Rect

_WALL_GAP = 2
"""Furniture stands clear of the baseboard (cm)."""


def wall_run(inner: Rect, model: Model, quarters: int, z: float = 0.0) -> Iterator[tuple[int, Piece]]:
    """Yield (distance of its nearer end from the corner, piece) along the wall that its back is turned to."""
    piece = Piece(model, 0, 0, quarters, z)
    hx, hy = piece.half_size
    start, end = (inner.y0, inner.y1) if quarters % 2 else (inner.x0, inner.x1)
    for along in range(start + hx + _WALL_GAP, end - hx, 5):
        corner = min(along - hx - start, end - along - hx)
        x, y = _at_wall(inner, quarters, along, hy)
        yield corner, replace(piece, x=x, y=y)


def _at_wall(inner: Rect, quarters: int, along: int, half_depth: int) -> tuple[int, int]:
    gap = half_depth + _WALL_GAP
    return (
        (along, inner.y1 - gap),
        (inner.x0 + gap, along),
        (along, inner.y0 + gap),
        (inner.x1 - gap, along),
    )[quarters]


def _ordered(scored: list[tuple[float, Piece]]) -> Iterator[Piece]:
    order = sorted(range(len(scored)), key=lambda i: (scored[i][0], i))
    return (scored[i][1] for i in order)


def against_wall(site: Site, model: Model) -> Iterator[Piece]:
    """Anywhere along the walls, back to the wall."""
    runs = [p for q in range(4) for _, p in wall_run(site.inner, model, q)]
    return (runs[i] for i in site.rng.permutation(len(runs)))


def in_corner(site: Site, model: Model) -> Iterator[Piece]:
    """Along the walls, as near to a corner as it gets."""
    noise = site.rng.integers(0, 30, size=4)
    return _ordered([(c + noise[q], p) for q in range(4) for c, p in wall_run(site.inner, model, q)])


def mid_wall(site: Site, model: Model) -> Iterator[Piece]:
    """Along the walls, as near to a wall's middle as it gets."""
    noise = site.rng.integers(0, 60, size=4)
    scored: list[tuple[float, Piece]] = []
    for q in range(4):
        run = list(wall_run(site.inner, model, q))
        middle = max((corner for corner, _ in run), default=0)
        scored += [(middle - corner + noise[q], piece) for corner, piece in run]
    return _ordered(scored)


def under_window(site: Site, model: Model) -> Iterator[Piece]:
    """Under a window, in its middle: a radiator."""
    for i in site.rng.permutation(len(site.windows)):
        yield before_window(site.inner, site.windows[i], model, 0.0)


def before_window(inner: Rect, window: Volume, model: Model, z: float) -> Piece:
    """Return the model with its back to the wall of a window, in line with its middle."""
    rect = window.rect
    quarters = 0 if rect.y1 > inner.y1 else 1 if rect.x0 < inner.x0 else 2 if rect.y0 < inner.y0 else 3
    piece = Piece(model, 0, 0, quarters, z)
    along = (rect.y0 + rect.y1) // 2 if quarters % 2 else (rect.x0 + rect.x1) // 2
    x, y = _at_wall(inner, quarters, along, piece.half_size[1])
    return replace(piece, x=x, y=y)


def opposite(site: Site, model: Model) -> Iterator[Piece]:
    """At the wall that the anchor faces, in line with it, facing it."""
    anchor = site.the_anchor
    run = wall_run(site.inner, model, (anchor.quarters + 2) % 4)
    ahead = anchor.quarters % 2
    return _ordered([(abs(p.y - anchor.y if ahead else p.x - anchor.x), p) for _, p in run])


def beside(site: Site, model: Model) -> Iterator[Piece]:
    """Left or right of the anchor, a hand's breadth away, backs in line."""
    return _at_side(site, model, int(site.rng.integers(2, 9)))


def in_row(site: Site, model: Model) -> Iterator[Piece]:
    """Left or right of the anchor, touching it but for a hair, backs in line."""
    return _at_side(site, model, 0)


def _at_side(site: Site, model: Model, gap: int) -> Iterator[Piece]:
    anchor = site.the_anchor
    piece = Piece(model, 0, 0, anchor.quarters)
    (ax, ay), (hx, hy) = anchor.half_size, piece.half_size
    sides = (1, -1) if site.rng.random() < 0.5 else (-1, 1)
    for side in sides:
        x, y = anchor.offset(side * (ax + hx + gap), ay - hy)
        yield replace(piece, x=x, y=y)


def before(site: Site, model: Model) -> Iterator[Piece]:
    """In front of the anchor at a knee's distance, turned as the anchor is: a coffee table before its couch."""
    return _in_front(site, model, int(site.rng.integers(30, 46)))


def at_foot(site: Site, model: Model) -> Iterator[Piece]:
    """Right at the anchor's front, turned as the anchor is: a bench at the foot of a bed."""
    return _in_front(site, model, int(site.rng.integers(2, 8)))


def _in_front(site: Site, model: Model, gap: int) -> Iterator[Piece]:
    anchor = site.the_anchor
    piece = Piece(model, 0, 0, anchor.quarters)
    (_, ay), (_, hy) = anchor.half_size, piece.half_size
    for shift in (0, 15, -15, 30, -30):
        x, y = anchor.offset(shift, -(ay + hy + gap))
        yield replace(piece, x=x, y=y)


def around(site: Site, model: Model) -> Iterator[Piece]:
    """At the seats of the anchor table, facing it; seats at the long sides first."""
    anchor = site.the_anchor
    degrees = int(site.rng.integers(-7, 8))
    chair = Piece(model, 0, 0, 0, 0, degrees)
    (ax, ay), (hx, hy) = anchor.half_size, chair.half_size
    gap = int(site.rng.integers(2, 9))
    seats = []
    for quarters, length, distance in ((0, ax, ay), (2, ax, ay), (1, ay, ax), (3, ay, ax)):
        count = max(1, 2 * length // (2 * hx + 8)) if length > 30 else 1
        for k in range(count):
            shift = (2 * k + 1) * length // count - length
            right, back = turned(quarters, shift, distance + hy + gap)
            x, y = anchor.offset(right, back)
            seats.append((-length, replace(chair, x=x, y=y, quarters=(anchor.quarters + quarters) % 4)))
    noise = site.rng.permutation(len(seats))
    return _ordered([(score + noise[i] / 1000, seat) for i, (score, seat) in enumerate(seats)])


def facing(site: Site, model: Model) -> Iterator[Piece]:
    """At a side of the anchor, turned towards it, at a knee's distance: an armchair at a coffee table."""
    anchor = site.the_anchor
    chair = Piece(model, 0, 0, 0, 0, int(site.rng.integers(-15, 16)))
    (ax, ay), (_, hy) = anchor.half_size, chair.half_size
    sides = ((1, ax), (3, ax), (2, ay))
    for i in site.rng.permutation(3):
        quarters, distance = sides[i]
        for gap in (30, 40, 55):
            x, y = anchor.offset(*turned(quarters, 0, distance + hy + gap))
            yield replace(chair, x=x, y=y, quarters=(anchor.quarters + quarters) % 4)


def in_middle(site: Site, model: Model) -> Iterator[Piece]:
    """Near the room's middle, long side along the room's."""
    inner = site.inner
    quarters = int((inner.depth > inner.width) == (model.size[0] > model.size[1])) + 2 * int(site.rng.integers(2))
    x, y = (inner.x0 + inner.x1) // 2, (inner.y0 + inner.y1) // 2
    shifts = [(dx, dy) for dx in range(-100, 101, 20) for dy in range(-100, 101, 20)]
    noise = site.rng.integers(0, 40, size=len(shifts))
    scored = [
        (float(abs(dx) + abs(dy) + noise[i]), Piece(model, x + dx, y + dy, quarters))
        for i, (dx, dy) in enumerate(shifts)
    ]
    return _ordered(scored)
