"""Rooms from the regions of a semantic config, and one room more for what lies between them.

Regions are what a room's floor shows; doorways and the stretches within walls are in none. The robot may stand only in
rooms, so the last room is the rectangle around all: walls, not outlines, say where it can go.
"""

import re
from collections.abc import Iterable
from pathlib import Path

import cv2
import numpy as np

from uniteam.geometry import Point2
from uniteam.world.assets.mesh import Mesh
from uniteam.world.assets.reading import read_json
from uniteam.world.homes import polygon
from uniteam.world.homes.check import SMALLEST_ROOM
from uniteam.world.homes.home import Light, Room
from uniteam.world.homes.polygon import Polygon
from uniteam.world.homes.readers.habitat_frame import point_to_world
from uniteam.world.homes.readers.hssd_schema import Region, SemanticConfig

BETWEEN = "between_rooms"
"""The name of the last room."""
AMBIENT = 0.45
LAMP_DEPTH = 0.3
"""How far below the ceiling a room's light hangs (m)."""
LOWEST_CEILING, HIGHEST_CEILING = 1.5, 20.0

_SAME_POINT = 1e-3
_WHITE = (1.0, 1.0, 1.0)


def read_regions(path: Path) -> tuple[Region, ...]:
    """Return the regions of a home; none where there is no such file. Raises DamagedFileError."""
    if not path.exists():
        return ()
    return tuple(read_json(path, "the semantic config", SemanticConfig).region_annotations)


def ceiling_height(regions: Iterable[Region], stage: Mesh) -> float:
    """Return how high the rooms are (m): as the regions say, or as the stage is."""
    heights = [region.floor_height + region.extrusion_height for region in regions if region.extrusion_height > 0.0]
    height = max(heights, default=float(stage.vertices[:, 2].max()))
    return min(max(height, LOWEST_CEILING), HIGHEST_CEILING)


def rooms_of(regions: Iterable[Region], stage: Mesh, ceiling: float) -> tuple[Room, ...]:
    """Return the rooms: one a region whose outline is any, and the rectangle around them, or else around the stage."""
    outlined = [(region.label or region.name or "room", _outline(region)) for region in regions]
    outlined = [(label, outline) for label, outline in outlined if len(outline) >= 3]
    rooms = [
        _room(f"{_word(label)}_{number}", _word(label), outline, ceiling)
        for number, (label, outline) in enumerate(outlined, start=1)
        if polygon.area(outline) >= SMALLEST_ROOM
    ]
    points = np.array([p for room in rooms for p in room.outline] or stage.vertices[:, :2], dtype=np.float64)
    (x0, y0), (x1, y1) = points.min(axis=0), points.max(axis=0)
    around = polygon.rectangle((float(x0), float(y0)), (float(x1), float(y1)))
    return (*rooms, _room(BETWEEN, "hall", around, ceiling))


def _room(name: str, kind: str, outline: Polygon, ceiling: float) -> Room:
    x, y = polygon.middle(outline)
    return Room(name, kind, outline, None, None, _WHITE, Light((x, y, ceiling - LAMP_DEPTH), _WHITE, AMBIENT))


def _outline(region: Region) -> Polygon:
    """Return a region's outline, counter-clockwise; its convex hull where it crosses itself."""
    points = [(float(x), float(y)) for x, y, _ in point_to_world(np.array(region.poly_loop).reshape(-1, 3))]
    corners: list[Point2] = []
    for point in points:
        if not corners or np.hypot(point[0] - corners[-1][0], point[1] - corners[-1][1]) > _SAME_POINT:
            corners.append(point)
    if len(corners) > 1 and np.hypot(*np.subtract(corners[0], corners[-1])) <= _SAME_POINT:
        corners.pop()
    outline = tuple(corners)
    if len(outline) < 3:
        return ()
    if not polygon.is_simple(outline):
        outline = tuple((float(x), float(y)) for x, y in cv2.convexHull(np.array(outline, np.float32))[:, 0])
    return outline if polygon.area(outline) > 0.0 else outline[::-1]


def _word(label: str) -> str:
    return re.sub(r"\W+", "_", label).strip("_")[:60] or "room"
