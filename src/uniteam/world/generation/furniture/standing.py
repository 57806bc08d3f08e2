"""Where a piece of furniture may stand: each function proposes pieces in a room, the best first.

Everything here proposes; what is taken and what stays passable is for `RoomFloor` to say.
"""

from collections.abc import Iterator
from dataclasses import replace

from uniteam.world.assets.model import Model
from uniteam.world.generation.furniture.piece import Piece, Site, turned
from uniteam.world.generation.furniture.room_floor import Volume
from uniteam.world.generation.plan.floor_shape import FloorShape, WallRun
from uniteam.world.generation.plan.rect import Rect

_WALL_GAP = 2
"""Furniture stands clear of the baseboard (cm)."""
_SPOTS = 40
"""How many places are proposed for what stands anywhere."""


def along_wall(run: WallRun, model: Model, z: float = 0.0) -> Iterator[tuple[int, Piece]]:
    """Yield (distance of its nearer end from the corner, piece) along the wall that its back is turned to."""
    hx, hy = Piece(model, 0, 0, run.quarters, z).half_size
    for along in range(run.start + hx + _WALL_GAP, run.end - hx, 5):
        corner = min(along - hx - run.start, run.end - along - hx)
        yield corner, Piece(model, *_at_wall(run, along, hy), run.quarters, z)


def _at_wall(run: WallRun, along: int, half_depth: int) -> tuple[int, int]:
    gap = half_depth + _WALL_GAP
    return (
        (along, run.line - gap),
        (run.line + gap, along),
        (along, run.line + gap),
        (run.line - gap, along),
    )[run.quarters]


def _ordered(scored: list[tuple[float, Piece]]) -> Iterator[Piece]:
    order = sorted(range(len(scored)), key=lambda i: (scored[i][0], i))
    return (scored[i][1] for i in order)


def against_wall(site: Site, model: Model) -> Iterator[Piece]:
    """Anywhere along the walls, back to the wall."""
    runs = [piece for run in site.floor.runs for _, piece in along_wall(run, model)]
    return (runs[i] for i in site.rng.permutation(len(runs)))


def in_corner(site: Site, model: Model) -> Iterator[Piece]:
    """Along the walls, as near to a corner as it gets."""
    runs = site.floor.runs
    noise = site.rng.integers(0, 30, size=len(runs))
    return _ordered([(c + noise[i], p) for i, run in enumerate(runs) for c, p in along_wall(run, model)])


def mid_wall(site: Site, model: Model) -> Iterator[Piece]:
    """Along the walls, as near to a wall's middle as it gets."""
    runs = site.floor.runs
    noise = site.rng.integers(0, 60, size=len(runs))
    scored: list[tuple[float, Piece]] = []
    for i, run in enumerate(runs):
        pieces = list(along_wall(run, model))
        middle = max((corner for corner, _ in pieces), default=0)
        scored += [(middle - corner + noise[i], piece) for corner, piece in pieces]
    return _ordered(scored)


def under_window(site: Site, model: Model) -> Iterator[Piece]:
    """Under a window, in its middle: a radiator."""
    for i in site.rng.permutation(len(site.windows)):
        yield before_window(site.floor, site.windows[i], model, 0.0)


def before_window(floor: FloorShape, window: Volume, model: Model, z: float) -> Piece:
    """Return the model with its back to the wall of a window, in line with its middle."""
    rect = window.rect
    run = next(run for run in floor.runs if _is_in(run, rect))
    piece = Piece(model, 0, 0, run.quarters, z)
    along = (rect.y0 + rect.y1) // 2 if run.quarters % 2 else (rect.x0 + rect.x1) // 2
    x, y = _at_wall(run, along, piece.half_size[1])
    return replace(piece, x=x, y=y)


def _is_in(run: WallRun, window: Rect) -> bool:
    """Say whether a window, as the floor before and behind it, is in a wall."""
    along, across = ((window.x0, window.x1), (window.y0, window.y1))[:: -1 if run.quarters % 2 else 1]
    return across[0] < run.line < across[1] and along[0] < run.end and run.start < along[1]


def opposite(site: Site, model: Model) -> Iterator[Piece]:
    """At the wall that the anchor faces, in line with it, facing it."""
    anchor = site.the_anchor
    runs = [run for run in site.floor.runs if run.quarters == (anchor.quarters + 2) % 4]
    pieces = [piece for run in runs for _, piece in along_wall(run, model)]
    ahead = anchor.quarters % 2
    return _ordered([(abs(p.y - anchor.y if ahead else p.x - anchor.x), p) for p in pieces])


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
    degrees = int(site.rng.integers(-7, 8))
    chair = Piece(model, 0, 0, 0, 0, degrees)
    return _seated(site, chair, int(site.rng.integers(2, 9)))


def pulled_out(site: Site, model: Model) -> Iterator[Piece]:
    """At the seats of the anchor table, pulled back and turned as somebody left them."""
    chair = Piece(model, 0, 0, 0, 0, int(site.rng.integers(-38, 39)))
    gaps = sorted({int(gap) for gap in site.rng.integers(2, 46, size=2)}, reverse=True)
    for gap in gaps:
        yield from _seated(site, chair, gap)


def _seated(site: Site, chair: Piece, gap: int) -> Iterator[Piece]:
    """Yield a chair at every seat of the anchor table, `gap` (cm) away from it."""
    anchor = site.the_anchor
    (ax, ay), (hx, hy) = anchor.half_size, chair.half_size
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


def left_about(site: Site, model: Model) -> Iterator[Piece]:
    """Anywhere on the floor, turned anyhow: what was used last and not put back."""
    inner, rng = site.floor.rect, site.rng
    for _ in range(_SPOTS):
        x, y = int(rng.integers(inner.x0, inner.x1)), int(rng.integers(inner.y0, inner.y1))
        yield Piece(model, x, y, int(rng.integers(4)), 0.0, int(rng.integers(-40, 41)))


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
    inner = site.floor.heart
    quarters = int((inner.depth > inner.width) == (model.size[0] > model.size[1])) + 2 * int(site.rng.integers(2))
    x, y = (inner.x0 + inner.x1) // 2, (inner.y0 + inner.y1) // 2
    shifts = [(dx, dy) for dx in range(-100, 101, 20) for dy in range(-100, 101, 20)]
    noise = site.rng.integers(0, 40, size=len(shifts))
    scored = [
        (float(abs(dx) + abs(dy) + noise[i]), Piece(model, x + dx, y + dy, quarters))
        for i, (dx, dy) in enumerate(shifts)
    ]
    return _ordered(scored)
