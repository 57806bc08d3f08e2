"""Where a thing may hang, lie flat, or stand on another: proposals for what does not stand on the floor by itself."""

import math
from collections.abc import Iterator
from dataclasses import replace

from uniteam.world.assets.catalogue import Model
from uniteam.world.homes.placement import Placement, Site
from uniteam.world.homes.placing import wall_run


def on_wall(site: Site, model: Model) -> Iterator[Placement]:
    """Hung on a wall, its middle at eye level, anywhere along it."""
    z = max(100, 155 - round(50 * model.size[2]))
    runs = [p for q in range(4) for _, p in wall_run(site.inner, model, q, z)]
    return (runs[i] for i in site.rng.permutation(len(runs)))


def over(site: Site, model: Model) -> Iterator[Placement]:
    """Hung on the wall over the anchor: a mirror over a sink, a picture over a couch."""
    anchor = site.the_anchor
    top = anchor.z + round(100 * anchor.model.size[2])
    z = max(top + 12, 150 - round(50 * model.size[2]))
    piece = Placement(model, 0, 0, anchor.quarters, z)
    (_, ay), (_, hy) = anchor.half_size, piece.half_size
    x, y = anchor.offset(0, ay - hy)
    yield replace(piece, x=x, y=y)


def on_top(site: Site, model: Model) -> Iterator[Placement]:
    """On the anchor's highest surface, at its middle: a television on its stand."""
    anchor = site.the_anchor
    if anchor.model.surfaces:
        height = max(surface.height for surface in anchor.model.surfaces)
        yield Placement(model, anchor.x, anchor.y, anchor.quarters, round(100 * height))


def on_ceiling(site: Site, model: Model) -> Iterator[Placement]:
    """Under the ceiling, at the room's middle."""
    inner = site.inner
    x, y = (inner.x0 + inner.x1) // 2, (inner.y0 + inner.y1) // 2
    yield Placement(model, x, y, 0, site.ceiling - math.ceil(100 * model.size[2]))


def above(site: Site, model: Model) -> Iterator[Placement]:
    """Under the ceiling, above the anchor: a lamp above a dining table."""
    anchor = site.the_anchor
    yield Placement(model, anchor.x, anchor.y, anchor.quarters, site.ceiling - math.ceil(100 * model.size[2]))


def beneath(site: Site, model: Model) -> Iterator[Placement]:
    """On the floor beneath the anchor, centred on it: a rug."""
    anchor = site.the_anchor
    for shift in (0, -30, 30, 60, -60):
        yield Placement(model, *anchor.offset(0, shift), anchor.quarters)


def on_floor(site: Site, model: Model) -> Iterator[Placement]:
    """Flat in the room's middle: a rug without a table."""
    inner = site.inner
    quarters = int((inner.depth > inner.width) == (model.size[0] > model.size[1]))
    yield Placement(model, (inner.x0 + inner.x1) // 2, (inner.y0 + inner.y1) // 2, quarters)
