"""A home as a MuJoCo model: static geoms for what is fixed, a free body for each graspable object."""

from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError
from uniteam.geometry import yaw_quaternion
from uniteam.world.assets.model import Box, CollisionShape, Model
from uniteam.world.homes.fixed_mesh import stage_mesh
from uniteam.world.homes.home import Home, Instance, Stage
from uniteam.world.physics.arm_shapes import ARM_BOXES
from uniteam.world.physics.collision_shapes import shape_vertices, wall_boxes, wall_to_world
from uniteam.world.physics.mesh_solids import mesh_solids

TIMESTEP = 0.004
"""s."""

FLOOR = "floor"
WALL = "wall"
ARM = "arm"

_FRICTION = (0.9, 0.01, 0.002)
_SLEEP_SPEED = 3e-3
_THINNEST = 1e-3
_NO_ROTATION = np.array([1.0, 0.0, 0.0, 0.0])


@dataclass(frozen=True)
class HomeModel:
    """A compiled home.

    Attributes:
        mujoco: the MjModel; body k + 1 is the k-th name of `bodies`, with a free joint.
        bodies: names of the movable instances.
        owners: the instance of each geom, or "floor", "wall" or "arm".
        low, high: (G, 3) corners of each geom's bounding box in its body's frame (m); the floor's are not finite.
        arm: the geoms of `ARM_BOXES`, in their order; they touch nothing, they are there to measure distances.
    """

    mujoco: Any
    bodies: tuple[str, ...]
    owners: tuple[str, ...]
    low: NDArray[np.float64]
    high: NDArray[np.float64]
    arm: range


def compile_home(home: Home) -> HomeModel:
    """Return the compiled home; instances of one model share its hulls.

    Raises:
        DamagedFileError: the stage's mesh cannot be read.
        InvalidInputError: a collision shape is one that MuJoCo does not take, such as a flat hull.
    """
    return _Builder(home).build()


def home_spec(home: Home) -> Any:
    """Return a home's MjSpec, not compiled yet and without the robot's arm, for those who add to it.

    Raises:
        DamagedFileError: the stage's mesh cannot be read.
    """
    return _Builder(home).bare_spec()


class _Builder:
    def __init__(self, home: Home) -> None:
        self._home = home
        self._spec = mujoco.MjSpec()
        self._owners: list[str] = []
        self._corners: list[tuple[NDArray[np.float64], NDArray[np.float64]]] = []
        self._hulls: set[str] = set()

    def build(self) -> HomeModel:
        self._set_options()
        self._add_floor()
        self._add_arm()
        self._add_home()
        names = tuple(instance.name for instance in self._home.instances if instance.movable)
        low, high = (np.array(corners) for corners in zip(*self._corners, strict=True))
        return HomeModel(self._compiled(), names, tuple(self._owners), low, high, range(1, 1 + len(ARM_BOXES)))

    def bare_spec(self) -> Any:
        """Return the home alone."""
        self._set_options()
        self._add_floor()
        self._add_home()
        return self._spec

    def _add_home(self) -> None:
        self._add_walls(self._home.stage)
        for instance in self._home.instances:
            if not instance.movable:
                self._add_fixed(instance)
        for instance in self._home.instances:
            if instance.movable:
                self._add_movable(instance)

    def _compiled(self) -> Any:
        try:
            return self._spec.compile()
        except ValueError as error:
            reason = " ".join(str(error).split())
            raise InvalidInputError(f"a collision shape of home '{self._home.name}' is no solid: {reason}") from error

    def _set_options(self) -> None:
        self._spec.option.timestep = TIMESTEP
        self._spec.option.enableflags = int(mujoco.mjtEnableBit.mjENBL_SLEEP)
        self._spec.option.sleep_tolerance = _SLEEP_SPEED
        self._spec.default.geom.friction = list(_FRICTION)
        self._spec.default.geom.condim = 6

    def _add_floor(self) -> None:
        self._spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[0, 0, 1])
        self._note(FLOOR, np.array([[-np.inf, -np.inf, -np.inf], [np.inf, np.inf, 0.0]]))

    def _add_arm(self) -> None:
        for part in ARM_BOXES:
            geom = self._add_box(self._spec.worldbody, part.box.size, np.array(part.box.center), _NO_ROTATION)
            geom.contype = geom.conaffinity = 0
            self._note(ARM, shape_vertices(part.box))

    def _add_walls(self, stage: Stage) -> None:
        for start, direction, box in wall_boxes(stage):
            to_world = wall_to_world(start, direction)
            center = to_world[:3, :3] @ box.center + to_world[:3, 3]
            self._add_box(self._spec.worldbody, box.size, center, np.array(yaw_quaternion(direction)))
            self._note(WALL, shape_vertices(box) @ to_world[:3, :3].T + to_world[:3, 3])
        mesh = stage_mesh(stage)
        for number, vertices in enumerate([] if mesh is None else mesh_solids(mesh)):
            self._add_hull(self._spec.worldbody, f"stage/{number}", vertices, np.zeros(3), _NO_ROTATION)
            self._note(WALL, vertices)

    def _add_fixed(self, instance: Instance) -> None:
        model = self._home.model_of(instance)
        to_world = instance.model_to_world()
        for number, shape in enumerate(model.shapes):
            self._add_shape(self._spec.worldbody, _hull_name(model, number), shape, instance)
            self._note(instance.name, shape_vertices(shape) @ to_world[:3, :3].T + to_world[:3, 3])

    def _add_movable(self, instance: Instance) -> None:
        model = self._home.model_of(instance)
        body = self._spec.worldbody.add_body(name=instance.name, pos=instance.position, quat=instance.quaternion)
        body.add_freejoint()
        _set_inertia(body, model)
        for number, shape in enumerate(model.shapes):
            self._add_shape(body, _hull_name(model, number), shape, None)
            self._note(instance.name, shape_vertices(shape))

    def _add_shape(self, body: Any, name: str, shape: CollisionShape, at: Instance | None) -> None:
        """Add a shape to a body, at an instance's pose or in the body's own frame."""
        to_body = np.eye(4) if at is None else at.model_to_world()
        quaternion = _NO_ROTATION if at is None else np.array(at.quaternion)
        box = _as_box(shape)
        if box is not None:
            self._add_box(body, box.size, to_body[:3, :3] @ box.center + to_body[:3, 3], quaternion)
            return
        self._add_hull(body, name, shape_vertices(shape), to_body[:3, 3], quaternion)

    def _add_hull(
        self, body: Any, name: str, vertices: NDArray[np.float64], position: NDArray[np.float64], quaternion: Any
    ) -> None:
        """Add a convex hull (V, 3) that may be known by its name already."""
        if name not in self._hulls:
            mesh = self._spec.add_mesh(name=name, inertia=mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL)
            mesh.uservert = vertices.ravel()
            self._hulls.add(name)
        body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name, pos=position, quat=quaternion)

    def _add_box(self, body: Any, size: Any, center: NDArray[np.float64], quaternion: NDArray[np.float64]) -> Any:
        half = np.maximum(size, _THINNEST) / 2
        return body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=half, pos=center, quat=quaternion)

    def _note(self, owner: str, vertices: NDArray[np.float64]) -> None:
        self._owners.append(owner)
        self._corners.append((vertices.min(axis=0), vertices.max(axis=0)))


def _hull_name(model: Model, number: int) -> str:
    return f"{model.id}/{number}"


def _as_box(shape: CollisionShape) -> Box | None:
    """Return a box as it is, and the bounding box of a hull too thin to have a volume."""
    if isinstance(shape, Box):
        return shape
    low, high = shape_vertices(shape).min(axis=0), shape_vertices(shape).max(axis=0)
    if (high - low).min() > _THINNEST:
        return None
    return Box(tuple((low + high) / 2), tuple(high - low))


def _set_inertia(body: Any, model: Model) -> None:
    """Give a body its mass, spread evenly over the bounding boxes of its shapes."""
    points = [shape_vertices(shape) for shape in model.shapes]
    sizes = np.array([np.maximum(np.ptp(p, axis=0), _THINNEST) for p in points])
    centers = np.array([(p.min(axis=0) + p.max(axis=0)) / 2 for p in points])
    masses = model.mass * sizes.prod(axis=1) / sizes.prod(axis=1).sum()
    center = masses @ centers / model.mass
    squares = sizes**2 / 12 + (centers - center) ** 2
    body.explicitinertial = True
    body.mass = model.mass
    body.ipos = center
    body.inertia = masses @ (squares.sum(axis=1, keepdims=True) - squares)
    body.gravcomp = np.finfo(float).tiny  # not zero, so that MuJoCo lets it be changed later
