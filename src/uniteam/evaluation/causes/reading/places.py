"""Where things are in a home: the rectangle that an instance covers, and walls between two points."""

import math

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import Point2, invert_transform, transform_points
from uniteam.world.homes.home import Home, Instance
from uniteam.world.physics.collision_shapes import model_vertices, wall_boxes

WALL_HEIGHT = 0.3
"""Above the floor (m): walls go down to it, and doorways are open there."""


def to_rectangle(home: Home, instance: Instance, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the nearest points (N, 2) of the floor on a standing instance's rectangle to (N, 2) points (m, world)."""
    own, half = _in_own_frame(home, instance, points)
    own[:, :2] = np.clip(own[:, :2], -half, half)
    return np.asarray(transform_points(instance.model_to_world(), own)[:, :2])


def distances_to(home: Home, instance: Instance, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return how far (m) (N, 2) points of the floor are from a standing instance's rectangle, (N,); 0 inside."""
    own, half = _in_own_frame(home, instance, points)
    return np.asarray(np.hypot(*np.maximum(np.abs(own[:, :2]) - half, 0.0).T))


def nearest_to(home: Home, instance: Instance, bases: NDArray[np.float64]) -> tuple[int, float]:
    """Return at which of (M, 2) points of the floor a base was nearest to a standing instance, and how near (m).

    Points with a wall in between do not count: it is infinitely far where there is no other.
    """
    distances = distances_to(home, instance, bases)
    is_walled = walls_between(home, bases, to_rectangle(home, instance, bases), WALL_HEIGHT)
    if is_walled.all():
        return int(np.argmin(distances)), math.inf
    moment = int(np.argmin(np.where(is_walled, math.inf, distances)))
    return moment, float(distances[moment])


def box_of(home: Home, name: str, pose: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the lowest and the highest x, y, z (m, world) of an object at a (4, 4) pose."""
    points = transform_points(pose, model_vertices(home.model_of(home.by_name[name]).shapes))
    return points.min(axis=0), points.max(axis=0)


def is_wall_between(home: Home, one: Point2, other: Point2, height: float) -> bool:
    """Return whether the line between two points of the floor meets a wall at a height (m)."""
    return bool(walls_between(home, np.array([one]), np.array([other]), height)[0])


def walls_between(
    home: Home, ones: NDArray[np.float64], others: NDArray[np.float64], height: float
) -> NDArray[np.bool_]:
    """Return (N,) whether the line between each two of (N, 2) points of the floor meets a wall at a height (m)."""
    met = np.zeros(len(ones), dtype=np.bool_)
    for start, direction, box in wall_boxes(home.stage):
        if abs(height - box.center[2]) > box.size[2] / 2:
            continue
        c, s = np.cos(direction), np.sin(direction)
        to_wall = np.array([[c, -s], [s, c]])
        middle = np.array([box.center[0], 0.0])
        met |= _meet((ones - start) @ to_wall - middle, (others - start) @ to_wall - middle, np.array(box.size[:2]) / 2)
    return met


def _meet(ones: NDArray[np.float64], others: NDArray[np.float64], half: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return (N,) whether lines between (N, 2) points meet the rectangle around the origin with (2,) half sides."""
    steps = others - ones
    is_level = np.abs(steps) < 1e-9
    steps = np.where(is_level, 1.0, steps)
    ends = np.stack([(-half - ones) / steps, (half - ones) / steps])
    is_beside = is_level & (np.abs(ones) > half)
    first, last = np.where(is_level, -np.inf, ends.min(axis=0)), np.where(is_level, np.inf, ends.max(axis=0))
    overlaps = np.maximum(first.max(axis=1), 0.0) <= np.minimum(last.min(axis=1), 1.0)
    return np.asarray(overlaps & ~is_beside.any(axis=1))


def _in_own_frame(
    home: Home, instance: Instance, points: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return points of the floor in an instance's frame, (N, 3), and half its rectangle's sides (m)."""
    to_own = invert_transform(instance.model_to_world())
    own = transform_points(to_own, np.column_stack([points, np.zeros(len(points))]))
    return own, np.array(home.model_of(instance).size[:2]) / 2
