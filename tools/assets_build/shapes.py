"""Collision shapes: boxes and convex prisms merged from cells for furniture, small hulls for objects."""

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import ConvexHull, QhullError

from assets_build.voxels import Voxels

Shape = dict[str, list]
Span = tuple[int, int, int, int, int, int]


def box(low: NDArray[np.float64], high: NDArray[np.float64]) -> Shape:
    """Return a box from its corners."""
    low, high = np.asarray(low, float), np.asarray(high, float)
    return {"center": _rounded((low + high) / 2), "size": _rounded(high - low)}


def hull(points: NDArray[np.floating], limit: int = 32) -> Shape:
    """Return the convex hull of (N, 3) points, reduced to `limit` vertices that keep the most of it."""
    return {"hull": [_rounded(p) for p in reduced_hull(np.asarray(points, float), limit)]}


def with_flat_bottom(points: NDArray[np.floating]) -> NDArray[np.float64]:
    """Return a body's convex hull cut just above the floor, the cut put on the floor: it rests rather than rolls."""
    points = np.array(points, dtype=float)
    height = min(0.06 * points[:, 2].max(), 0.006)
    try:
        points = points[ConvexHull(points).vertices]
    except QhullError:
        return points
    below, above = points[points[:, 2] < height], points[points[:, 2] >= height]
    start, end = np.repeat(below, len(above), axis=0), np.tile(above, (len(below), 1))
    share = (height - start[:, 2]) / (end[:, 2] - start[:, 2])
    cut = start + share[:, None] * (end - start)
    cut[:, 2] = 0.0
    return np.concatenate([above, cut])


def _rounded(values: NDArray[np.float64]) -> list[float]:
    return [round(float(v), 5) for v in values]


def reduced_hull(points: NDArray[np.float64], limit: int) -> NDArray[np.float64]:
    """Return at most `limit` of the points: the extremes, then always the point farthest outside what is kept."""
    points = np.unique(np.round(points, 5), axis=0)
    try:
        points = points[ConvexHull(points).vertices]
    except QhullError:
        middle = (points.min(0) + points.max(0)) / 2
        half = np.maximum(np.ptp(points, axis=0) / 2, 0.002)
        return middle + half * np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    if len(points) <= limit:
        return points
    chosen = set()
    for direction in np.concatenate([np.eye(3), -np.eye(3), _corner_directions()]):
        chosen.add(int(np.argmax(points @ direction)))
    while len(chosen) < limit:
        equations = ConvexHull(points[sorted(chosen)]).equations
        outside = (points @ equations[:, :3].T + equations[:, 3]).max(1)
        outside[sorted(chosen)] = -1
        farthest = int(np.argmax(outside))
        if outside[farthest] < 1e-5:
            break
        chosen.add(farthest)
    return points[sorted(chosen)]


def _corner_directions() -> NDArray[np.float64]:
    bottom = [[np.cos(a), np.sin(a), -3.0] for a in np.arange(8) * np.pi / 4]
    return np.array(bottom + [[x, y, 1.0] for x in (-1, 1) for y in (-1, 1)])


def merged_boxes(voxels: Voxels, limit: int, fill: float = 0.88) -> list[Shape]:
    """Cover the filled cells with few boxes and round prisms; the largest first, until little is left.

    A box grows while at least the share `fill` of each layer it takes in is filled.
    """
    shapes, covered = _round_slabs(voxels)
    volumes = voxels.volumes()
    total = float((volumes * voxels.filled).sum())
    rng = np.random.default_rng(0)
    while len(shapes) < limit:
        left = voxels.filled & ~covered
        if float((volumes * left).sum()) < 0.02 * total:
            break
        span, gain = _best_span(voxels, left, volumes, fill, rng)
        if gain < 0.002 * total:
            break
        x0, x1, y0, y1, z0, z1 = span
        covered[x0:x1, y0:y1, z0:z1] = True
        corners = [(p[a], p[b]) for p, a, b in zip(voxels.planes, span[::2], span[1::2], strict=True)]
        shapes.append(box(np.array([c[0] for c in corners]), np.array([c[1] for c in corners])))
    return shapes


def _integral(values: NDArray[np.float64]) -> NDArray[np.float64]:
    out = np.zeros(tuple(n + 1 for n in values.shape))
    out[1:, 1:, 1:] = values.cumsum(0).cumsum(1).cumsum(2)
    return out


def _sum(table: NDArray[np.float64], s: Span) -> float:
    a, b, c, d, e, f = s
    return float(
        table[b, d, f] - table[a, d, f] - table[b, c, f] - table[b, d, e]
        + table[a, c, f] + table[a, d, e] + table[b, c, e] - table[a, c, e]
    )  # fmt: skip


def _best_span(
    voxels: Voxels, left: NDArray[np.bool_], volumes: NDArray[np.float64], fill: float, rng: np.random.Generator
) -> tuple[Span, float]:
    """Return the span of cells, grown from sampled seeds, that covers most of what is left."""
    filled = _integral(volumes * voxels.filled)
    fresh = _integral(volumes * left)
    needed = fill * _integral(volumes)
    seeds = np.argwhere(left)
    weights = volumes[left]
    picks = rng.choice(len(seeds), min(24, len(seeds)), replace=False, p=weights / weights.sum())
    best: tuple[Span, float] = ((0, 0, 0, 0, 0, 0), -1.0)
    for seed in seeds[picks]:
        for order in ((0, 1, 2), (1, 0, 2), (2, 0, 1), (2, 1, 0)):
            span = _grow(seed, order, filled, needed)
            empty = _sum(needed, span) / fill - _sum(filled, span)
            gain = _sum(fresh, span) - 2.0 * empty
            if gain > best[1]:
                best = (span, gain)
    return best


def _grow(
    seed: NDArray[np.int64], order: tuple[int, ...], filled: NDArray[np.float64], needed: NDArray[np.float64]
) -> Span:
    span = [int(v) for k in seed for v in (k, k + 1)]
    shape = [n - 1 for n in needed.shape]
    grown = True
    while grown:
        grown = False
        for axis in order:
            for side in (0, 1):
                while _extend(span, axis, side, shape, filled, needed):
                    grown = True
    return tuple(span)  # type: ignore[return-value]


def _extend(
    span: list[int], axis: int, side: int, shape: list[int], filled: NDArray[np.float64], needed: NDArray[np.float64]
) -> bool:
    k = 2 * axis + side
    if (side == 0 and span[k] == 0) or (side == 1 and span[k] == shape[axis]):
        return False
    layer = list(span)
    layer[2 * axis], layer[2 * axis + 1] = (span[k] - 1, span[k]) if side == 0 else (span[k], span[k] + 1)
    s: Span = tuple(layer)  # type: ignore[assignment]
    if _sum(filled, s) < _sum(needed, s):
        return False
    span[k] += 1 if side else -1
    return True


def _round_slabs(voxels: Voxels) -> tuple[list[Shape], NDArray[np.bool_]]:
    """Carve out slabs whose footprint is convex but no rectangle, such as a round tabletop."""
    covered = np.zeros_like(voxels.filled)
    x, y, z = voxels.planes
    areas = np.diff(x)[:, None] * np.diff(y)[None, :]
    shapes: list[Shape] = []
    start = 0
    layers = voxels.filled.shape[2]
    while start < layers:
        mask = voxels.filled[:, :, start]
        end = start + 1
        while end < layers and _overlap(mask, voxels.filled[:, :, end], areas) > 0.93:
            end += 1
        outline = _round_outline(mask, x, y, areas)
        if outline is not None:
            shapes.append(
                hull(np.concatenate([np.column_stack([outline, np.full(len(outline), h)]) for h in (z[start], z[end])]))
            )
            covered[mask, start:end] = True
        start = end
    return shapes, covered


def _overlap(a: NDArray[np.bool_], b: NDArray[np.bool_], areas: NDArray[np.float64]) -> float:
    return float(areas[a & b].sum() / max(areas[a | b].sum(), 1e-12))


def _round_outline(
    mask: NDArray[np.bool_], x: NDArray[np.float64], y: NDArray[np.float64], areas: NDArray[np.float64]
) -> NDArray[np.float64] | None:
    area = float(areas[mask].sum())
    if area < 0.25 * areas.sum():
        return None
    i, j = np.nonzero(mask)
    centres = np.column_stack([(x[i] + x[i + 1]) / 2, (y[j] + y[j + 1]) / 2])
    corners = np.concatenate([np.column_stack([x[i + a], y[j + b]]) for a in (0, 1) for b in (0, 1)])
    low, high = corners.min(0), corners.max(0)
    around = ConvexHull(corners)
    inner = ConvexHull(centres).volume if len(centres) > 3 and np.ptp(centres, axis=0).min() > 0 else 0.0
    if area > 0.9 * np.prod(high - low) or area < 0.93 * (around.volume + inner) / 2:
        return None
    middle = (low + high) / 2
    polygon = corners[around.vertices]
    angles = np.arange(16) * np.pi / 8
    support = [(polygon - middle) @ np.array([np.cos(a), np.sin(a)]) for a in angles]
    chosen = sorted({int(np.argmax(s)) for s in support})
    return polygon[chosen]
