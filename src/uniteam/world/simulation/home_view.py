"""A home in motion as cameras see it: the scene, kept where the physics and the robot are."""

import math
from collections.abc import Iterator, Sequence
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import PinholeCamera
from uniteam.stretch import head_camera_to_base
from uniteam.world.homes.home import Home
from uniteam.world.rendering.camera import render, render_geometry
from uniteam.world.rendering.kernels.frame import Frame, Geometry
from uniteam.world.rendering.meshes.robot_mesh import part_poses, robot_parts
from uniteam.world.rendering.scene import Scene
from uniteam.world.rendering.third_person import Watcher
from uniteam.world.simulation.robot_state import RobotState

_WATCHING_FOV = math.radians(60.0)
_OVERHEAD = 1.9
"""What stands higher than this (m) hangs from the ceiling, and would hide the robot from above."""


class ObjectPoses(Protocol):
    """Where the objects of a home are: its physics, or a recording of it."""

    @property
    def names(self) -> Sequence[str]:
        """The movable instances."""

    @property
    def version(self) -> int:
        """Another one whenever an object may have moved."""

    def poses(self) -> NDArray[np.float64]:
        """Return the (N, 4, 4) poses (world) of the objects in the order of `names`."""


class HomeView:
    """The scene of a home with the robot in it."""

    def __init__(self, home: Home, objects: ObjectPoses) -> None:
        """Build the scene; the objects are where `objects` has them whenever a frame is taken."""
        self._objects = objects
        self._scene = Scene(home, robot_parts())
        self._watcher = Watcher(home.stage)
        self._overhead = tuple(name for name in ("ceiling", *_hanging(home)) if name in self._scene.names)
        self._seen_poses: dict[str, NDArray[np.float64]] = {}
        self._seen_version = -1

    def head(self, state: RobotState, camera: PinholeCamera, hanging: dict[str, NDArray[np.float64]]) -> Frame:
        """Return what the head camera sees; `hanging` has the poses (world) of objects that the gripper holds."""
        self._update(state, hanging)
        return render(self._scene, camera, state.base.matrix() @ head_camera_to_base(state.joints))

    def head_geometry(
        self, state: RobotState, camera: PinholeCamera, hanging: dict[str, NDArray[np.float64]]
    ) -> Geometry:
        """Return what the head camera sees but for its colours, as `head` has it."""
        self._update(state, hanging)
        return render_geometry(self._scene, camera, state.base.matrix() @ head_camera_to_base(state.joints))

    def from_above(
        self, state: RobotState, size: tuple[int, int], hanging: dict[str, NDArray[np.float64]]
    ) -> NDArray[np.uint8]:
        """Return the (H, W, 3) picture of the robot from above, without what is overhead; size is (W, H)."""
        self._update(state, hanging)
        camera = PinholeCamera.from_horizontal_fov(*size, _WATCHING_FOV)
        self._show_overhead(False)
        try:
            return render(self._scene, camera, self._watcher.pose(state.base)).rgb
        finally:
            self._show_overhead(True)

    def _show_overhead(self, visible: bool) -> None:
        for name in self._overhead:
            self._scene.show(name, visible)

    def _update(self, state: RobotState, hanging: dict[str, NDArray[np.float64]]) -> None:
        poses = part_poses(state.base, state.joints) | self._object_poses() | hanging
        for name, pose in poses.items():
            seen = self._seen_poses.get(name)
            if seen is None or not np.array_equal(seen, pose):
                self._scene.move(name, pose)
                self._seen_poses[name] = pose

    def _object_poses(self) -> dict[str, NDArray[np.float64]]:
        """Return the poses of all objects if any may have moved since they were last asked for."""
        if self._seen_version == self._objects.version:
            return {}
        self._seen_version = self._objects.version
        return dict(zip(self._objects.names, self._objects.poses(), strict=True))


def _hanging(home: Home) -> Iterator[str]:
    return (i.name for i in home.instances if not i.movable and i.position[2] > _OVERHEAD)
