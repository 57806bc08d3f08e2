"""A home as the camera sees it: stage, instances and extra parts, each of which can be moved, shown and hidden."""

from collections import defaultdict
from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.world.assets.mesh import Mesh
from uniteam.world.homes.home import Home, Instance
from uniteam.world.rendering.kernels.culling import may_be_seen, screen_bounds
from uniteam.world.rendering.kernels.lighting import RoomLight, outdoor_light, pose_part, room_light
from uniteam.world.rendering.kernels.scene_buffers import SceneBuffers, Workspace
from uniteam.world.rendering.kernels.texture_atlas import MipCache
from uniteam.world.rendering.meshes.floor_shade import floor_shade
from uniteam.world.rendering.meshes.render_mesh import RenderMesh, load_render_mesh, make_render_mesh
from uniteam.world.rendering.meshes.stage_mesh import StagePart, room_at, stage_parts
from uniteam.world.rendering.scene_arrays import ScenePart, corners_of, packed

Transform = NDArray[np.float64]

MeshOf = Callable[[Home, Instance], RenderMesh]
"""What is shown for an instance of a home."""

_stage_mips = MipCache()
"""The few textures of floors and walls are prepared once a process, as the pack's models are."""


def mesh_of_model(home: Home, instance: Instance) -> RenderMesh:
    """Return the mesh of an instance's model; raises DamagedFileError."""
    return load_render_mesh(home.model_of(instance))


class Scene:
    """Everything the camera can see of a home, in arrays that the rasteriser reads.

    The stage's parts are named "floor", "ceiling", "wall_0", "wall_1", ..., and "stage" for its mesh; the others by
    their instances, or by their keys in `parts`.
    """

    def __init__(self, home: Home, parts: Mapping[str, Mesh] | None = None, mesh_of: MeshOf = mesh_of_model) -> None:
        """Gather the geometry.

        Args:
            home: its stage and instances; the instance image shows indices into `home.instances`.
            parts: further meshes by name (the robot's links), at the world's origin until they are moved; label -1.
            mesh_of: what is shown for an instance, in its model's frame.

        Raises:
            DamagedFileError: a file of the home's library, or the stage's mesh, cannot be read.
            UnknownNameError: the home names a model or a texture that its library lacks.
        """
        self.home = home
        stage = stage_parts(home.stage, home.library)
        entries = _stage_entries(stage) + _instance_entries(home, mesh_of) + _extra_entries(parts or {})
        self._meshes = tuple(entry.mesh for entry in entries)
        self._glowing = tuple(entry.is_glowing for entry in entries)
        self._lights = [room_light(room, home.stage.ceiling_height) for room in home.stage.rooms]
        self._outdoors = outdoor_light(home.stage)
        self._parts_of: dict[str, list[int]] = defaultdict(list)
        for index, entry in enumerate(entries):
            self._parts_of[entry.name].append(index)
        self._buffers = packed(entries, floor_shade(home))
        self._poses = np.tile(np.eye(4), (len(entries), 1, 1))
        self._stale: set[int] = set()
        self._workspaces: dict[tuple[int, int], Workspace] = {}
        self._corners = [corners_of(mesh) for mesh in self._meshes]
        for index in range(len(entries)):
            self._place_box(index)
        for index, part in enumerate(stage):
            self._pose_part(index, self._outdoors if part.room is None else self._lights[part.room])
        for instance in home.instances:
            self.move(instance.name, instance.model_to_world())
        self._stale.update(index for name in (parts or {}) for index in self._parts_of[name])

    @property
    def names(self) -> tuple[str, ...]:
        """Every name that `move` and `show` know."""
        return tuple(self._parts_of)

    def move(self, name: str, to_world: Transform) -> None:
        """Put a part at the pose `to_world` (4, 4, rigid); raises UnknownNameError, InvalidInputError."""
        if to_world.shape != (4, 4):
            raise InvalidInputError(f"the pose of '{name}' must be a (4, 4) transform, got {to_world.shape}")
        for index in self._indices(name):
            self._poses[index] = to_world
            self._place_box(index)
            self._stale.add(index)

    def show(self, name: str, visible: bool) -> None:
        """Show or hide a part, or everything of the stage that bears the name; raises UnknownNameError."""
        self._buffers.part_visible[self._indices(name)] = visible

    def is_shown(self, name: str) -> bool:
        """Say whether a part is shown; raises UnknownNameError."""
        return bool(self._buffers.part_visible[self._indices(name)[0]])

    def pose(self, name: str) -> Transform:
        """Return a part's (4, 4) pose in the world; raises UnknownNameError."""
        return self._poses[self._indices(name)[0]].copy()

    def buffers(self) -> SceneBuffers:
        """Return the arrays, with every part that is shown where it was last moved to."""
        return self._brought_up_to_date(self._buffers.part_visible)

    def buffers_in_view(self, projection: NDArray[np.float32], height: int, width: int) -> SceneBuffers:
        """Return the arrays, with every part that may be in a picture where it was last moved to, and others hidden.

        The robot moves in nearly every frame, and its own camera sees little of it. A part that stays where it was is
        hidden, for there it may be in the picture.

        Args:
            projection: (3, 4) from the world to pixel coordinates times depth.
            height, width: of the picture.
        """
        if not self._stale:
            return self._buffers
        may_be = screen_bounds(self._buffers, projection, width, height)[:, 4] >= 0.0
        for index in self._stale:
            if may_be[index]:
                mesh, from_model = self._meshes[index], _after(projection, self._poses[index])
                may_be[index] = may_be_seen(mesh.vertices, mesh.triangles, from_model, width, height)
        buffers = self._brought_up_to_date(may_be)
        shown = buffers.part_visible.copy()
        shown[list(self._stale)] = False
        return buffers._replace(part_visible=shown)

    def _brought_up_to_date(self, is_wanted: NDArray[np.bool_]) -> SceneBuffers:
        for index in sorted(index for index in self._stale if is_wanted[index]):
            self._pose_part(index, self._light_at(index))
            self._stale.discard(index)
        return self._buffers

    def workspace(self, height: int, width: int) -> Workspace:
        """Return the rasteriser's arrays for images of a size; their content is the last frame's."""
        if (height, width) not in self._workspaces:
            self._workspaces[height, width] = Workspace(
                np.empty((len(self._buffers.vertices), 3), dtype=np.float32),
                np.empty((height, width), dtype=np.float32),
                np.empty((height, width), dtype=np.int32),
            )
        return self._workspaces[height, width]

    def _indices(self, name: str) -> list[int]:
        if name not in self._parts_of:
            raise UnknownNameError("part of the scene", name, self._parts_of)
        return self._parts_of[name]

    def _light_at(self, index: int) -> RoomLight:
        room = room_at(self.home.stage, *self._poses[index, :2, 3])
        return self._outdoors if room is None else self._lights[room]

    def _pose_part(self, index: int, light: RoomLight) -> None:
        buffers, mesh, pose = self._buffers, self._meshes[index], self._poses[index]
        first, last = buffers.part_ranges[index, :2]
        pose_part(
            mesh.vertices, mesh.normals, pose[:3].astype(np.float32), light.numbers,
            buffers.vertices[first:last], buffers.light[first:last],
        )  # fmt: skip
        if self._glowing[index]:
            buffers.light[first:last] = 1.0
        else:
            buffers.part_tints[index] = light.tint

    def _place_box(self, index: int) -> None:
        pose = self._poses[index]
        self._buffers.part_boxes[index] = self._corners[index] @ pose[:3, :3].T + pose[:3, 3]


def _after(projection: NDArray[np.float32], pose: Transform) -> NDArray[np.float32]:
    """Return the (3, 4) projection of what stands at a pose."""
    moved = projection[:, :3].astype(np.float64) @ pose[:3]
    moved[:, 3] += projection[:, 3]
    return moved.astype(np.float32)


def _stage_entries(stage: tuple[StagePart, ...]) -> list[ScenePart]:
    return [
        ScenePart(p.name, make_render_mesh(p.mesh, _stage_mips), -1, is_stage=True, is_glowing=p.is_glowing)
        for p in stage
    ]


def _instance_entries(home: Home, mesh_of: MeshOf) -> list[ScenePart]:
    return [ScenePart(instance.name, mesh_of(home, instance), label) for label, instance in enumerate(home.instances)]


def _extra_entries(parts: Mapping[str, Mesh]) -> list[ScenePart]:
    return [ScenePart(name, make_render_mesh(mesh), -1) for name, mesh in parts.items()]
