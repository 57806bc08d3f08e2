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
    distances, points = distances_to(home, instance, bases), to_rectangle(home, instance, bases)
    walled: set[Point2] = set()
    for moment in np.argsort(distances, kind="stable").tolist():
        (x, y), (u, v) = bases[moment].tolist(), points[moment].tolist()
        if (x, y) in walled:
            continue
        if not is_wall_between(home, (x, y), (u, v), WALL_HEIGHT):
            return moment, float(distances[moment])
        walled.add((x, y))
    return int(np.argmin(distances)), math.inf


def box_of(home: Home, name: str, pose: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the lowest and the highest x, y, z (m, world) of an object at a (4, 4) pose."""
    points = transform_points(pose, model_vertices(home.model_of(home.by_name[name]).shapes))
    return points.min(axis=0), points.max(axis=0)


def is_wall_between(home: Home, one: Point2, other: Point2, height: float) -> bool:
    """Return whether the line between two points of the floor meets a wall at a height (m)."""
    for start, direction, box in wall_boxes(home.stage):
        along = np.array([np.cos(direction), np.sin(direction)])
        across = np.array([-along[1], along[0]])
        ends = [(float((p - start) @ along), float((p - start) @ across)) for p in (np.array(one), np.array(other))]
        if abs(height - box.center[2]) <= box.size[2] / 2 and _meets(ends[0], ends[1], box.center[0], box.size):
            return True
    return False


def _meets(one: Point2, other: Point2, middle: float, size: tuple[float, float, float]) -> bool:
    """Return whether a line meets the rectangle of a wall's box, in the wall's frame."""
    low, high = 0.0, 1.0
    for axis, centre in ((0, middle), (1, 0.0)):
        begin, step, half = one[axis] - centre, other[axis] - one[axis], size[axis] / 2
        if abs(step) < 1e-9:
            if abs(begin) > half:
                return False
            continue
        first, last = sorted(((-half - begin) / step, (half - begin) / step))
        low, high = max(low, first), min(high, last)
    return low <= high


def _in_own_frame(
    home: Home, instance: Instance, points: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return points of the floor in an instance's frame, (N, 3), and half its rectangle's sides (m)."""
    to_own = invert_transform(instance.model_to_world())
    own = transform_points(to_own, np.column_stack([points, np.zeros(len(points))]))
    return own, np.array(home.model_of(instance).size[:2]) / 2
