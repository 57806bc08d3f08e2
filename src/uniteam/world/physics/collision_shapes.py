"""Collision shapes as points of the world, and the solid pieces of walls."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from uniteam.world.assets.model import Box, CollisionShape
from uniteam.world.homes.home import Stage, Wall

_CORNERS = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])


def shape_vertices(shape: CollisionShape) -> NDArray[np.float64]:
    """Return the (V, 3) vertices of a collision shape (m, model frame)."""
    if isinstance(shape, Box):
        return np.asarray(_CORNERS * shape.size + shape.center)
    return np.array(shape.vertices)


def model_vertices(shapes: tuple[CollisionShape, ...]) -> NDArray[np.float64]:
    """Return the (V, 3) vertices of all of a model's shapes (m, model frame)."""
    return np.concatenate([shape_vertices(shape) for shape in shapes])


def wall_boxes(stage: Stage) -> Iterator[tuple[NDArray[np.float64], float, Box]]:
    """Yield the solid pieces of every wall, around its openings.

    Yields:
        (2,) start of the wall (m, world), its direction (rad), and a box in the wall's frame, which has its origin at
        that start, x along the wall and z up.
    """
    for wall in stage.walls:
        start, along = np.array(wall.start), np.subtract(wall.end, wall.start)
        for low, high, bottom, top in _solid_pieces(wall, float(np.hypot(*along)), stage.ceiling_height):
            center = ((low + high) / 2, 0.0, (bottom + top) / 2)
            box = Box(center, (high - low, wall.thickness, top - bottom))
            yield start, float(np.arctan2(along[1], along[0])), box


def _solid_pieces(wall: Wall, length: float, height: float) -> Iterator[tuple[float, float, float, float]]:
    """Yield (from, to) along the wall and (bottom, top) above the floor of what its openings leave."""
    reached = 0.0
    for opening in sorted(wall.openings, key=lambda o: o.start):
        pieces = (
            (reached, opening.start, 0.0, height),
            (opening.start, opening.end, 0.0, opening.bottom),
            (opening.start, opening.end, opening.top, height),
        )
        yield from (p for p in pieces if p[1] - p[0] > 1e-6 and p[3] - p[2] > 1e-6)
        reached = opening.end
    if length - reached > 1e-6:
        yield reached, length, 0.0, height


def wall_to_world(start: NDArray[np.float64], direction: float) -> NDArray[np.float64]:
    """Return the (4, 4) transform from a wall's frame to the world."""
    c, s = np.cos(direction), np.sin(direction)
    return np.array([[c, -s, 0, start[0]], [s, c, 0, start[1]], [0, 0, 1, 0], [0, 0, 0, 1]])
