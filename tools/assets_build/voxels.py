"""A model as cells of an uneven grid whose planes lie where the model's own flat faces do.

Boards, tabletops and panels then fill whole cells, so that shapes merged from cells meet the model's faces exactly.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy import ndimage

from assets_build.sampling import SurfaceSamples

EXACT_COSINE = 0.985
CURVED_COSINE = 0.75
CLOSEST_PLANES = 0.006
CUSHION_BULGE = 0.025


@dataclass(frozen=True)
class Voxels:
    """`planes`: for each axis the sorted boundaries of its cells (m); `filled` (X, Y, Z) bool."""

    planes: tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]
    filled: NDArray[np.bool_]

    def volumes(self) -> NDArray[np.float64]:
        """Return the (X, Y, Z) volumes of the cells (m3)."""
        x, y, z = (np.diff(p) for p in self.planes)
        return x[:, None, None] * y[None, :, None] * z[None, None, :]


def _peaks(values: NDArray[np.float64], weights: NDArray[np.float64], least: float, apart: float) -> list[float]:
    """Return the places where weight gathers to at least `least`, heaviest first, none nearer than `apart`."""
    if not len(values):
        return []
    bins = np.floor(values / 0.002).astype(int)
    start = bins.min()
    histogram = np.bincount(bins - start, weights)
    sums = np.bincount(bins - start, weights * values)
    window = np.ones(3)
    heavy = np.convolve(histogram, window, "same")
    place = np.convolve(sums, window, "same") / np.maximum(heavy, 1e-12)
    found: list[float] = []
    for k in np.argsort(-heavy):
        if heavy[k] < least:
            break
        if all(abs(place[k] - other) >= apart for other in found):
            found.append(float(place[k]))
    return found


def _axis_planes(samples: SurfaceSamples, axis: int, step: float) -> NDArray[np.float64]:
    low, high = samples.points[:, axis].min(), samples.points[:, axis].max()
    extent = np.ptp(samples.points, axis=0)
    side = float(np.prod(np.delete(extent, axis)))
    facing = np.abs(samples.normals[:, axis])
    flat = facing > EXACT_COSINE
    found = _peaks(samples.points[flat, axis], samples.areas[flat], 0.015 * side, CLOSEST_PLANES)
    if axis == 2:
        curved = samples.normals[:, 2] > CURVED_COSINE
        peaks = _peaks(samples.points[curved, 2], samples.areas[curved], 0.03 * side, 0.03)
        found += [p for p in peaks if all(abs(p - f) > 0.03 for f in found)]
    kept = [low, high]
    for place in found:
        if all(abs(place - other) >= CLOSEST_PLANES for other in kept):
            kept.append(place)
    kept.sort()
    filled = [np.linspace(a, b, max(1, int(np.ceil((b - a) / step - 0.01))) + 1)[:-1] for a, b in pairwise(kept)]
    return np.concatenate([*filled, [high]])


def voxelise(samples: SurfaceSamples, step: float, solid: bool) -> Voxels:
    """Return the cells that the surface passes through or closes in (a bottom left open counts as closed).

    A `solid` model is filled from the lowest to the highest cell of each column: upholstery and vessels, whose hollows
    open upwards, but nothing with room beneath a board.
    """
    planes = tuple(_axis_planes(samples, axis, step) for axis in range(3))
    points = samples.points - 0.002 * samples.normals
    points = _settle_cushions(points, samples, planes[2])
    shape = tuple(len(p) - 1 for p in planes)
    index = np.stack(
        [
            np.clip(np.searchsorted(p, points[:, k], "right") - 1, 0, n - 1)
            for k, (p, n) in enumerate(zip(planes, shape, strict=True))
        ]
    )
    flat = np.ravel_multi_index(tuple(index), shape)
    area = np.bincount(flat, samples.areas, int(np.prod(shape))).reshape(shape)
    sizes = [np.diff(p) for p in planes]
    faces = np.stack(
        np.broadcast_arrays(
            sizes[0][:, None, None] * sizes[1][None, :, None],
            sizes[0][:, None, None] * sizes[2][None, None, :],
            sizes[1][None, :, None] * sizes[2][None, None, :],
        )
    )
    filled = area > 0.2 * faces.min(0)
    sealed = np.pad(filled, 1)
    sealed[1:-1, 1:-1, 0] = True
    filled = ndimage.binary_fill_holes(sealed)[1:-1, 1:-1, 1:-1]
    if solid:
        filled = (
            np.logical_or.accumulate(filled, axis=2) & np.logical_or.accumulate(filled[:, :, ::-1], axis=2)[:, :, ::-1]
        )
    return Voxels(planes, filled)  # type: ignore[arg-type]


def _settle_cushions(
    points: NDArray[np.float64], samples: SurfaceSamples, planes: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Press the bulges of soft tops down to the plane that stands for them."""
    below = planes[np.clip(np.searchsorted(planes, points[:, 2]) - 1, 0, None)]
    rise = points[:, 2] - below
    soft = (samples.normals[:, 2] > 0.5) & (rise < CUSHION_BULGE) & (rise > 0)
    settled = points.copy()
    settled[soft, 2] = below[soft] - 0.002
    return settled
