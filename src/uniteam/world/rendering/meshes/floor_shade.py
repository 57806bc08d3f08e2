"""Soft shadows that furniture throws on the floor, as a picture of the floor: without them things seem to float."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import transform_points
from uniteam.world.assets.model import Box, CollisionShape
from uniteam.world.homes.home import Home
from uniteam.world.rendering.kernels.lighting import GAMMA

CELL_SIZE = 0.04
"""m."""

_MARGIN = 0.2
_DARKNESS = 0.75
_FADING_HEIGHT = 0.75
_HIGHEST = 1.2
_CONTACT_HEIGHT = 0.2
_CONTACT_BLUR, _OVERHANG_BLUR = 0.09, 0.16


@dataclass(frozen=True)
class FloorShade:
    """What remains of the light on the floor.

    Attributes:
        values: (R, C) float32, the factor of an sRGB colour; row = y, column = x.
        frame: (3,) float32: x and y (m, world) of the centre of cell [0, 0], cells a metre.
    """

    values: NDArray[np.float32]
    frame: NDArray[np.float32]


def floor_shade(home: Home) -> FloorShade:
    """Return the shade of everything in a home that does not move, from its collision shapes.

    A shape darkens what is under it, the less the higher it hangs; near the floor with a sharp edge, else a soft one.
    """
    if not home.stage.rooms:
        return FloorShade(np.ones((1, 1), dtype=np.float32), np.array([0.0, 0.0, 1.0], dtype=np.float32))
    low = np.min([room.low for room in home.stage.rooms], axis=0) - _MARGIN
    high = np.max([room.high for room in home.stage.rooms], axis=0) + _MARGIN
    columns, rows = np.ceil((high - low) / CELL_SIZE).astype(int)
    contact, overhang = np.zeros((2, rows, columns), dtype=np.float32)
    for bottom, outline in sorted(_outlines(home), key=lambda item: -item[0]):
        cells = np.round((outline - low) / CELL_SIZE).astype(np.int32)
        darkness = _DARKNESS * math.exp(-max(bottom, 0.0) / _FADING_HEIGHT)
        cv2.fillConvexPoly(contact if bottom < _CONTACT_HEIGHT else overhang, cells, darkness)
    light = (1.0 - _blur(contact, _CONTACT_BLUR)) * (1.0 - _blur(overhang, _OVERHANG_BLUR))
    return FloorShade((light ** (1.0 / GAMMA)).astype(np.float32), np.array([*low, 1.0 / CELL_SIZE], dtype=np.float32))


def _outlines(home: Home) -> Iterator[tuple[float, NDArray[np.float32]]]:
    """Yield each shape's lowest height (m) and its convex outline on the floor, (K, 2) float32."""
    for instance in home.instances:
        if instance.movable:
            continue
        to_world = instance.model_to_world()
        for shape in home.model_of(instance).shapes:
            points = transform_points(to_world, _points(shape))
            bottom = float(points[:, 2].min())
            if bottom < _HIGHEST:
                yield bottom, np.asarray(cv2.convexHull(points[:, :2].astype(np.float32))[:, 0], dtype=np.float32)


def _points(shape: CollisionShape) -> NDArray[np.float64]:
    if not isinstance(shape, Box):
        return np.array(shape.vertices)
    signs = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
    return np.array(shape.center) + signs * np.array(shape.size)


def _blur(image: NDArray[np.float32], radius: float) -> NDArray[np.float32]:
    return np.asarray(cv2.GaussianBlur(image, (0, 0), radius / CELL_SIZE), dtype=np.float32)
