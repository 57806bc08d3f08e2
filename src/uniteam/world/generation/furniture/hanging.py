"""Where a thing may hang, lie flat, or stand on another: proposals for what does not stand on the floor by itself."""

import math
from collections.abc import Iterator
from dataclasses import replace

from uniteam.world.assets.model import Model
from uniteam.world.generation.furniture.piece import Piece, Site
from uniteam.world.generation.furniture.standing import along_wall, before_window


def on_wall(site: Site, model: Model) -> Iterator[Piece]:
    """Hung on a wall, its middle at eye level, anywhere along it."""
    z = max(20, 155 - round(50 * model.size[2]))
    runs = [piece for run in site.floor.runs for _, piece in along_wall(run, model, z)]
    return (runs[i] for i in site.rng.permutation(len(runs)))


def over(site: Site, model: Model) -> Iterator[Piece]:
    """Hung on the wall over the anchor, its middle at eye level: a mirror over a sink, a picture over a couch."""
    anchor = site.the_anchor
    top = anchor.z + 100 * anchor.model.size[2]
    z = max(round(top) + 12, 150 - round(50 * model.size[2]))
    yield _behind(anchor, model, z)


def overhead(site: Site, model: Model) -> Iterator[Piece]:
    """Hung on the wall above the anchor, out of the way of heads: a kitchen's upper cabinet."""
    yield _behind(site.the_anchor, model, min(145, site.ceiling - math.ceil(100 * model.size[2]) - 5))


def _behind(anchor: Piece, model: Model, z: float) -> Piece:
    """Return the model in line with the anchor, its back where the anchor's is."""
    piece = Piece(model, 0, 0, anchor.quarters, z)
    (_, ay), (_, hy) = anchor.half_size, piece.half_size
    x, y = anchor.offset(0, ay - hy)
    return replace(piece, x=x, y=y)


def on_top(site: Site, model: Model) -> Iterator[Piece]:
    """On the anchor's highest surface, towards its back: a television on its stand."""
    anchor = site.the_anchor
    if not anchor.model.surfaces:
        return
    height = 100 * max(surface.height for surface in anchor.model.surfaces)
    piece = Piece(model, 0, 0, anchor.quarters, height)
    (ax, ay), (hx, hy) = anchor.half_size, piece.half_size
    if hx <= ax and hy <= ay:
        shifts = (0,) if 2 * hx > ax else (hx - ax + 4, ax - hx - 4)
        for i in site.rng.permutation(len(shifts)):
            x, y = anchor.offset(shifts[i], max(0, ay - hy - 4))
            yield replace(piece, x=x, y=y)


def at_window(site: Site, model: Model) -> Iterator[Piece]:
    """Before a window that it covers, its rod just above: curtains."""
    z = max(0, min(228, site.ceiling - 4) - math.ceil(100 * model.size[2]))
    for window in site.windows:
        width = max(window.rect.width, window.rect.depth)
        if 50 * model.size[0] <= width <= 100 * model.size[0]:
            yield before_window(site.floor, window, model, z)


def on_ceiling(site: Site, model: Model) -> Iterator[Piece]:
    """Under the ceiling, at the room's middle."""
    inner = site.floor.heart
    x, y = (inner.x0 + inner.x1) // 2, (inner.y0 + inner.y1) // 2
    yield Piece(model, x, y, 0, site.ceiling - math.ceil(100 * model.size[2]))


def above(site: Site, model: Model) -> Iterator[Piece]:
    """Under the ceiling, above the anchor: a lamp above a dining table."""
    anchor = site.the_anchor
    yield Piece(model, anchor.x, anchor.y, anchor.quarters, site.ceiling - math.ceil(100 * model.size[2]))


def beneath(site: Site, model: Model) -> Iterator[Piece]:
    """On the floor beneath the anchor, centred on it: a rug."""
    anchor = site.the_anchor
    for shift in (0, -30, 30, 60, -60):
        yield Piece(model, *anchor.offset(0, shift), anchor.quarters)


def on_floor(site: Site, model: Model) -> Iterator[Piece]:
    """Flat in the room's middle: a rug without a table."""
    inner = site.floor.heart
    quarters = int((inner.depth > inner.width) == (model.size[0] > model.size[1]))
    yield Piece(model, (inner.x0 + inner.x1) // 2, (inner.y0 + inner.y1) // 2, quarters)
