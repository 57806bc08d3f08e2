"""Convex pieces of a vessel that is open at the top: a floor and a ring of wall segments."""

import numpy as np
from numpy.typing import NDArray

from assets_build.geometry import Geometry
from assets_build.sampling import SurfaceSamples, sample_surface
from assets_build.shapes import Shape, hull

SECTORS = 8


def hollow_hulls(geometry: Geometry, wall: float = 0.006) -> list[Shape]:
    """Return a floor and eight wall segments of a bowl, cup, basket or pot about the vertical through its middle.

    The middle is that of the foot, which no handle pulls aside; `wall` is the thickness in m.
    """
    samples = sample_surface(geometry.corners, 0.004)
    top = samples.points[:, 2].max()
    foot = samples.points[samples.points[:, 2] < 0.2 * top, :2]
    middle = (foot.min(0) + foot.max(0)) / 2
    top = _rim_height(samples.points, middle, top)
    floor = _floor_height(samples, middle, top)
    heights = np.linspace(floor, top, 3)
    outer = np.array([_outer_radii(samples.points, middle, h, top / 6 + 0.004) for h in heights])
    base = _outer_radii(samples.points, middle, 0.0, max(floor, 0.01))
    shapes = [hull(np.concatenate([_ring(middle, base, 0.0), _ring(middle, outer[0], floor)]))]
    for sector in range(SECTORS):
        pair = [sector, (sector + 1) % SECTORS]
        points = []
        for radii, height in zip(outer, heights, strict=True):
            ring, inside = _ring(middle, radii, height), _ring(middle, np.maximum(radii - wall, 0.004), height)
            points += [ring[pair], inside[pair]]
        shapes.append(hull(np.concatenate(points)))
    return shapes


def _rim_height(points: NDArray[np.float64], middle: NDArray[np.float64], top: float) -> float:
    """Return the greatest height at which the vessel goes nearly all the way round: a handle may rise above it."""
    offset = points[:, :2] - middle
    sector = np.floor((np.arctan2(offset[:, 1], offset[:, 0]) / (2 * np.pi) + 0.5) * SECTORS).astype(int) % SECTORS
    levels = np.arange(top, 0.3 * top, -0.001)
    around = (len(np.unique(sector[np.abs(points[:, 2] - level) < 0.004])) for level in levels)
    return float(next((level for level, count in zip(levels, around, strict=True) if count >= SECTORS - 2), top))


def _floor_height(samples: SurfaceSamples, middle: NDArray[np.float64], top: float) -> float:
    """Return the height of the vessel's inner floor: the lowest upward face near the middle."""
    radius = np.linalg.norm(samples.points[:, :2] - middle, axis=1)
    reach = np.quantile(radius, 0.9)
    chosen = (samples.normals[:, 2] > 0.7) & (radius < 0.4 * reach) & (samples.points[:, 2] < 0.6 * top)
    floor = float(np.median(samples.points[chosen, 2])) if chosen.any() else 0.08 * top
    return max(floor, 0.004)


def _outer_radii(
    points: NDArray[np.float64], middle: NDArray[np.float64], height: float, band: float
) -> NDArray[np.float64]:
    """Return the outer radius at the borders of the sectors (a handle, which few points carry, is left out)."""
    near = points[np.abs(points[:, 2] - height) < band]
    near = near if len(near) > 20 else points
    offset = near[:, :2] - middle
    angle, radius = np.arctan2(offset[:, 1], offset[:, 0]), np.linalg.norm(offset, axis=1)
    turns = [np.abs(np.angle(np.exp(1j * (angle - 2 * np.pi * k / SECTORS)))) for k in range(SECTORS)]
    sectors = [radius[turn < np.pi / SECTORS] for turn in turns]
    usual = float(np.median([np.median(sector) for sector in sectors if len(sector)]))
    inside = [sector[sector < 1.2 * usual] for sector in sectors]
    return np.array([np.quantile(sector, 0.95) if len(sector) else usual for sector in inside])


def _ring(middle: NDArray[np.float64], radii: NDArray[np.float64], height: float) -> NDArray[np.float64]:
    angles = 2 * np.pi * np.arange(SECTORS) / SECTORS
    return np.column_stack(
        [middle[0] + radii * np.cos(angles), middle[1] + radii * np.sin(angles), np.full(SECTORS, height)]
    )
