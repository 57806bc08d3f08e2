"""Where the robot's base can stand: the clearance to whatever a cylinder of the robot's size would hit."""

import copy
import math
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose, transform_points
from uniteam.grid import Grid
from uniteam.stretch import BASE_RADIUS, ROBOT_HEIGHT
from uniteam.world.homes.fixed_mesh import stage_mesh
from uniteam.world.homes.home import Home, Instance
from uniteam.world.homes.polygon import convex_pieces
from uniteam.world.physics.collision_shapes import shape_vertices, wall_boxes, wall_to_world
from uniteam.world.physics.mesh_solids import mesh_solids

CELL_SIZE = 0.02
"""m."""
STEP_HEIGHT = 0.03
"""What is lower than this the wheels roll over (m)."""

_MARGIN = 0.5
_SWEEP_STEP = 0.01
_SUBPIXEL_BITS = 8


class NavigableFloor:
    """A home's floor as a grid of clearances; where something has moved, `with_moved` returns another.

    Attributes:
        cells: (R, C) float32, metres from a cell's centre to the nearest obstacle between 3 cm and 1.41 m above the
            floor, 0 inside one and outside the rooms; row along y, column along x; right to within a cell.
    """

    def __init__(self, home: Home) -> None:
        """Rasterise the home."""
        corners = np.array([(room.low, room.high) for room in home.stage.rooms])
        self._low = corners[:, 0].min(axis=0) - _MARGIN
        self._grid = Grid((float(self._low[0]), float(self._low[1])), CELL_SIZE)
        columns, rows = np.ceil((corners[:, 1].max(axis=0) + _MARGIN - self._low) / CELL_SIZE).astype(int)
        free = np.zeros((rows, columns), np.uint8)
        for room in home.stage.rooms:
            for piece in convex_pieces(room.outline):
                self._fill(free, np.array(piece), 1)
        for points in _fixed_obstacles(home):
            self._fill(free, points, 0)
        self._without_objects = free
        self._objects = {i.name: _object_outlines(home, i, i.model_to_world()) for i in home.instances if i.movable}
        self.cells = self._clearance_cells()

    def with_moved(self, home: Home, poses: Mapping[str, NDArray[np.float64]]) -> "NavigableFloor":
        """Return the floor after objects have moved.

        Args:
            home: which this floor is of.
            poses: (4, 4) of the objects that moved, by name; one that is above the robot is in nobody's way.
        """
        moved = copy.copy(self)
        outlines = {name: _object_outlines(home, home.by_name[name], pose) for name, pose in poses.items()}
        moved._objects = {**self._objects, **outlines}
        moved.cells = moved._clearance_cells()
        for name in ("free", "largest_component"):
            moved.__dict__.pop(name, None)
        return moved

    def _clearance_cells(self) -> NDArray[np.float32]:
        free = self._without_objects.copy()
        for outlines in self._objects.values():
            for outline in outlines:
                self._fill(free, outline, 0)
        return np.asarray(cv2.distanceTransform(free, cv2.DIST_L2, cv2.DIST_MASK_PRECISE) * np.float32(CELL_SIZE))

    def _fill(self, grid: NDArray[np.uint8], points: NDArray[np.float64], value: int) -> None:
        cells = ((points - self._low) / CELL_SIZE - 0.5) * (1 << _SUBPIXEL_BITS)
        cv2.fillConvexPoly(grid, cells.round().astype(np.int32), value, shift=_SUBPIXEL_BITS)

    def to_cell(self, x: float, y: float) -> tuple[int, int]:
        """Return the (row, column) of the cell that holds a point (m, world); it may lie outside the grid."""
        return self._grid.to_cell(x, y)

    def to_point(self, row: int, column: int) -> tuple[float, float]:
        """Return the centre (x, y) of a cell (m, world)."""
        return self._grid.to_point(row, column)

    def clearance(self, x: float, y: float) -> float:
        """Return the distance (m) from a point (m, world) to the nearest obstacle, interpolated between cells."""
        return float(self._clearances(np.array([[x, y]]))[0])

    def is_free(self, x: float, y: float) -> bool:
        """Return whether the base can stand at a point (m, world)."""
        return self.clearance(x, y) >= BASE_RADIUS

    def sweep(self, base: BasePose, x_to: float, y_to: float) -> bool:
        """Return whether the base can move straight from where it stands to a point (m, world).

        A base that stands too near something, because that fell there, may move where it gets no nearer.
        """
        count = max(1, math.ceil(base.distance_to(x_to, y_to) / _SWEEP_STEP)) + 1
        line = np.linspace((base.x, base.y), (x_to, y_to), count)
        clearances = self._clearances(line)
        return bool(np.all(clearances >= min(BASE_RADIUS, clearances[0])))

    @cached_property
    def free(self) -> NDArray[np.bool_]:
        """(R, C) bool: cells on whose centre the base can stand."""
        return np.asarray(self.cells >= BASE_RADIUS)

    @cached_property
    def largest_component(self) -> NDArray[np.bool_]:
        """(R, C) bool: the largest connected set (by sides) of free cells."""
        count, labels, stats, _ = cv2.connectedComponentsWithStats(self.free.astype(np.uint8), connectivity=4)
        if count == 1:
            return np.zeros_like(self.free)
        return np.asarray(labels == 1 + int(np.argmax(stats[1:, cv2.CC_STAT_AREA])))

    def _clearances(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the clearance at (N, 2) points (m, world), bilinear between the cells' centres."""
        positions = (points - self._low) / CELL_SIZE - 0.5
        corner = np.clip(np.floor(positions).astype(int), 0, np.array(self.cells.shape[::-1]) - 2)
        fx, fy = np.clip(positions - corner, 0.0, 1.0).T
        column, row = corner.T
        below = self.cells[row, column] * (1 - fx) + self.cells[row, column + 1] * fx
        above = self.cells[row + 1, column] * (1 - fx) + self.cells[row + 1, column + 1] * fx
        return np.asarray(below * (1 - fy) + above * fy)


Outlines = list[NDArray[np.float64]]


def _fixed_obstacles(home: Home) -> Outlines:
    """Return convex (V, 2) outlines (m, world) of what is fixed between `STEP_HEIGHT` and the robot's height."""
    walls = [transform_points(wall_to_world(s, a), shape_vertices(box)) for s, a, box in wall_boxes(home.stage)]
    mesh = stage_mesh(home.stage)
    solids = () if mesh is None else tuple(mesh_solids(mesh))
    furniture = (shape for i in home.instances if not i.movable for shape in _shapes(home, i, i.model_to_world()))
    return _slab_outlines((*walls, *solids, *furniture))


def _object_outlines(home: Home, instance: Instance, model_to_world: NDArray[np.float64]) -> Outlines:
    """Return the outlines of an object's shapes where it is."""
    return _slab_outlines(_shapes(home, instance, model_to_world))


def _shapes(home: Home, instance: Instance, model_to_world: NDArray[np.float64]) -> Iterator[NDArray[np.float64]]:
    """Yield the (V, 3) vertices (m, world) of an instance's collision shapes."""
    return (transform_points(model_to_world, shape_vertices(shape)) for shape in home.model_of(instance).shapes)


def _slab_outlines(solids: Iterable[NDArray[np.float64]]) -> Outlines:
    outlines = (_slab_outline(vertices) for vertices in solids)
    return [outline for outline in outlines if outline is not None]


def _slab_outline(vertices: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """Return the outline from above of the part of a convex solid within the robot's height, if there is one."""
    z = vertices[:, 2]
    if z.max() <= STEP_HEIGHT or z.min() >= ROBOT_HEIGHT:
        return None
    inside = (z >= STEP_HEIGHT) & (z <= ROBOT_HEIGHT)
    points = [vertices[inside, :2]]
    for height in (STEP_HEIGHT, ROBOT_HEIGHT):
        points.append(_slice(vertices[z < height], vertices[z > height], height))
    hull = cv2.convexHull(np.concatenate(points).astype(np.float32))
    return np.asarray(hull[:, 0, :], dtype=np.float64)


def _slice(below: NDArray[np.float64], above: NDArray[np.float64], height: float) -> NDArray[np.float64]:
    """Return (N, 2) points whose hull is the cut of a convex solid at a height, from its vertices on either side."""
    share = (height - below[:, None, 2]) / (above[None, :, 2] - below[:, None, 2])
    return np.asarray(
        (below[:, None, :2] + share[..., None] * (above[None, :, :2] - below[:, None, :2])).reshape(-1, 2)
    )
