"""How a held object could be put on a piece of furniture: over which point, from which height and stand, how postured.

What is most likely to work comes first: just above the roomiest point of a surface, from above. The ways of all
surfaces, heights and postures take turns, so that whoever tries a dozen has tried what differs.
"""

from collections.abc import Iterator
from dataclasses import replace
from itertools import islice, product, zip_longest

import numpy as np

from uniteam.stretch import MANIPULATION_POSTURE
from uniteam.world.certification.drop_points import DropPoints, drop_points
from uniteam.world.homes.home import Home, Instance
from uniteam.world.oracle.base_stands import SIDES_APART, Release, apart, releases

LEAST_DROP, MOST_DROP = 0.04, 0.75
"""How far above a surface an object's bottom is released (m); from higher where it must pass a rim."""
HEADROOM = {MANIPULATION_POSTURE.wrist_pitch: 0.35, 0.0: 0.03, -0.7: 0.2, 0.5: 0.2}
"""By the wrist's pitch (rad), what the arm needs above an object (m).

Level, only the fingers reach between a shelf's boards; pitched up, the gripper reaches highest.
"""
WAYS_FROM_A_HEIGHT, APART = 5, 0.12
"""How many points of a surface are tried from one height, and how far apart they are (m)."""
SIDES = 3
"""From how many sides a point is reached."""
RISES = (0.0, 0.25)
"""From how much higher the gripper comes over the point (m): over what stands in front of it, where that is open."""
EDGE_MARGIN = 0.02
"""What an object keeps from a surface's edge, where the surface is large enough (m)."""


def release_ways(home: Home, held: Instance, receptacle: Instance, floor_points: np.ndarray) -> Iterator[Release]:
    """Yield ways to release an object over a receptacle.

    Args:
        home: with what else stands on the receptacle.
        held: the object.
        receptacle: where it shall go.
        floor_points: (N, 2) where the base may stand (m, world).
    """
    width, depth, height = home.model_of(held).size
    margin = float(np.hypot(width, depth)) / 2.0 + EDGE_MARGIN
    top = receptacle.position[2] + home.model_of(receptacle).size[2]
    surfaces = sorted(drop_points(home, receptacle), key=lambda surface: -surface.margins.max())
    drops = [(surface, drop) for surface in surfaces for drop in _drops(surface, top)]
    ways = [
        (replace(way, rise=rise) for way in _ways(surface, floor_points, height + drop, pitch, margin))
        for rise in RISES
        for (surface, drop), pitch in product(sorted(drops, key=lambda pair: pair[1] != LEAST_DROP), HEADROOM)
        if surface.clearance >= height + drop + HEADROOM[pitch] + rise
    ]
    yield from (way for round_of_ways in zip_longest(*ways) for way in round_of_ways if way is not None)


def _drops(surface: DropPoints, top: float) -> list[float]:
    """Return from how high above a surface to release (m): just above it, or just above the furniture's top."""
    over_the_top = top + LEAST_DROP - surface.height
    return [LEAST_DROP, over_the_top] if LEAST_DROP < over_the_top < MOST_DROP else [LEAST_DROP]


def _ways(
    surface: DropPoints, floor_points: np.ndarray, height: float, wrist_pitch: float, margin: float
) -> Iterator[Release]:
    """Yield ways to release at the surface's roomiest points; `height` is the gripper's above the surface (m)."""
    roominess = np.round(np.minimum(surface.margins, margin), 2)
    reach = np.linalg.norm(surface.points[:, None] - floor_points[None], axis=2).min(axis=1, initial=np.inf)
    tried = np.empty((0, 2))
    by_point: list[list[Release]] = []
    for i in np.lexsort((reach, -roominess)):
        if np.all(np.linalg.norm(tried - surface.points[i], axis=1) >= APART):
            found = releases(surface.points[i], floor_points, surface.height + height, wrist_pitch)
            by_point.append(list(islice(apart(found, SIDES_APART), SIDES)))
            tried = np.vstack([tried, surface.points[i]])
        if len(tried) == WAYS_FROM_A_HEIGHT:
            break
    yield from (way for side in zip_longest(*by_point) for way in side if way is not None)
