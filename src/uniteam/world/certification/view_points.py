"""Where the base may stand to see an instance: the view points of the challenge, for a home as it is given.

A view point is a point of the lattice on the largest connected part of the navigable floor, within 1 m of the
instance's footprint, from where some part of the instance is seen at the height of the head camera. What hides what is
decided by rays against the collision shapes.
"""

import mujoco
import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import Point2, transform_points
from uniteam.stretch import BASE_RADIUS, NAVIGATION_POSTURE, head_camera_to_base
from uniteam.world.homes.home import Home, Instance
from uniteam.world.physics.collision_shapes import shape_vertices
from uniteam.world.physics.navigable_floor import CELL_SIZE, NavigableFloor
from uniteam.world.physics.physics_model import HomeModel
from uniteam.world.task.footprint import VIEW_DISTANCE, distance_to_footprint
from uniteam.world.task.lattice import lattice_points_near

CAMERA_HEIGHT = float(head_camera_to_base(NAVIGATION_POSTURE)[2, 3])
"""m."""

_MOST_TARGETS = 24
_OUT_OF_SIGHT = 1000.0
_FAR = 10.0
_TOWARDS_CENTRE = 0.15


class Viewpoints:
    """The view points of a home's instances, found when they are asked for."""

    def __init__(self, home: Home, floor: NavigableFloor, model: HomeModel) -> None:
        """Take the home's floor and its compiled bodies, which are where the home has them."""
        self._home = home
        self._floor = floor
        self._model = model
        self._data = mujoco.MjData(model.mujoco)
        mujoco.mj_kinematics(model.mujoco, self._data)
        self._data.geom_xpos[list(model.arm)] = _OUT_OF_SIGHT
        self._standable = floor.largest_component & (floor.cells >= BASE_RADIUS + CELL_SIZE)
        self._of: dict[str, tuple[Point2, ...]] = {}

    def of(self, name: str) -> tuple[Point2, ...]:
        """Return an instance's view points (m, world)."""
        if name not in self._of:
            targets = self._targets(name)
            points = self.standable(self._home.by_name[name])
            self._of[name] = tuple((float(x), float(y)) for x, y in points if self._is_seen(name, x, y, targets))
        return self._of[name]

    def standable(self, instance: Instance, within: float = VIEW_DISTANCE) -> NDArray[np.float64]:
        """Return the (N, 2) lattice points that the robot can drive to, no farther than `within` (m) of an instance."""
        x, y, _ = instance.position
        reach = within + float(np.linalg.norm(self._home.model_of(instance).size))
        points = lattice_points_near(x, y, reach, reach)
        points = points[distance_to_footprint(self._home, instance, points) <= within]
        return points[self._are_standable(points)]

    def _are_standable(self, points: NDArray[np.float64]) -> NDArray[np.bool_]:
        cells = np.array([self._floor.to_cell(*point) for point in points]).reshape(-1, 2)
        inside = np.all((cells >= 0) & (cells < self._standable.shape), axis=1)
        rows, columns = np.where(inside[:, None], cells, 0).T
        return np.asarray(inside & self._standable[rows, columns])

    def _targets(self, name: str) -> NDArray[np.float64]:
        """Return (T, 3) points (m, world) inside an instance's shapes, near their corners and at their centres."""
        instance = self._home.by_name[name]
        corners = [shape_vertices(shape) for shape in self._home.model_of(instance).shapes]
        centres = [vertices.mean(axis=0) for vertices in corners]
        inner = [v + _TOWARDS_CENTRE * (c - v) for v, c in zip(corners, centres, strict=True)]
        inside = transform_points(instance.model_to_world(), np.vstack([*inner, *centres]))
        chosen = np.unique(np.linspace(0, len(inside) - 1, _MOST_TARGETS).round().astype(int))
        return np.ascontiguousarray(inside[chosen])

    def _is_seen(self, name: str, x: float, y: float, targets: NDArray[np.float64]) -> bool:
        eye = np.array([x, y, CAMERA_HEIGHT])
        rays = np.ascontiguousarray(targets - eye)
        geoms = np.empty(len(targets), np.int32)
        distances = np.empty(len(targets))
        model, count = self._model.mujoco, len(targets)
        mujoco.mj_multiRay(model, self._data, eye, rays.ravel(), None, True, -1, geoms, distances, None, count, _FAR)
        return any(geom >= 0 and self._model.owners[geom] == name for geom in geoms)
