"""A home as the camera sees it: stage, instances and extra parts, each of which can be moved, shown and hidden."""

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.world.assets.mesh import Mesh
from uniteam.world.homes.home import Home
from uniteam.world.rendering.kernels.culling import may_be_seen, screen_bounds
from uniteam.world.rendering.kernels.lighting import RoomLight, outdoor_light, pose_part, room_light
from uniteam.world.rendering.kernels.scene_buffers import SceneBuffers, Workspace
from uniteam.world.rendering.kernels.texture_atlas import AtlasBuilder, MipCache
from uniteam.world.rendering.meshes.floor_shade import FloorShade, floor_shade
from uniteam.world.rendering.meshes.render_mesh import RenderMesh, load_render_mesh, make_render_mesh
from uniteam.world.rendering.meshes.stage_mesh import StagePart, room_at, stage_parts

Transform = NDArray[np.float64]

MOST_TRIANGLES = 20_000_000
"""Of a home and all that stands in it: more would fill the memory."""

_stage_mips = MipCache()
"""The few textures of floors and walls are prepared once a process, as the pack's models are."""


@dataclass(frozen=True)
class _Part:
    """One piece of a scene before it is packed; `room` is None where it takes the light of where it stands."""

    name: str
    mesh: RenderMesh
    label: int
    is_stage: bool = False
    is_glowing: bool = False


class Scene:
    """Everything the camera can see of a home, in arrays that the rasteriser reads.

    The stage's parts are named "floor", "ceiling", "wall_0", "wall_1", ..., and "stage" for its mesh; the others by
    their instances, or by their keys in `parts`.
    """

    def __init__(self, home: Home, parts: Mapping[str, Mesh] | None = None) -> None:
        """Gather the geometry.

        Args:
            home: its stage and instances; the instance image shows indices into `home.instances`.
            parts: further meshes by name (the robot's links), at the world's origin until they are moved; label -1.

        Raises:
            DamagedFileError: a file of the home's library, or the stage's mesh, cannot be read.
            UnknownNameError: the home names a model or a texture that its library lacks.
        """
        self.home = home
        stage = stage_parts(home.stage, home.library)
        entries = _stage_entries(stage) + _instance_entries(home) + _extra_entries(parts or {})
        self._meshes = tuple(entry.mesh for entry in entries)
        self._glowing = tuple(entry.is_glowing for entry in entries)
        self._lights = [room_light(room, home.stage.ceiling_height) for room in home.stage.rooms]
        self._outdoors = outdoor_light(home.stage)
        self._parts_of: dict[str, list[int]] = defaultdict(list)
        for index, entry in enumerate(entries):
            self._parts_of[entry.name].append(index)
        self._buffers = _pack(entries, floor_shade(home))
        self._poses = np.tile(np.eye(4), (len(entries), 1, 1))
        self._stale: set[int] = set()
        self._workspaces: dict[tuple[int, int], Workspace] = {}
        self._corners = [_corners(mesh) for mesh in self._meshes]
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
        """Return the arrays, with every part that may be in a picture where it was last moved to, and no other shown.

        The robot moves in nearly every frame, and its own camera sees little of it.

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
        # What is left where it was before must not be drawn there: its box may be in the picture all the same.
        return self._brought_up_to_date(may_be)._replace(part_visible=may_be)

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


def _stage_entries(stage: tuple[StagePart, ...]) -> list[_Part]:
    return [
        _Part(p.name, make_render_mesh(p.mesh, _stage_mips), -1, is_stage=True, is_glowing=p.is_glowing) for p in stage
    ]


def _instance_entries(home: Home) -> list[_Part]:
    return [
        _Part(instance.name, load_render_mesh(home.model_of(instance)), label)
        for label, instance in enumerate(home.instances)
    ]


def _extra_entries(parts: Mapping[str, Mesh]) -> list[_Part]:
    return [_Part(name, make_render_mesh(mesh), -1) for name, mesh in parts.items()]


def _corners(mesh: RenderMesh) -> NDArray[np.float64]:
    choice = np.array([[(k >> axis) & 1 for axis in range(3)] for k in range(8)])
    return np.where(choice == 1, mesh.high.astype(np.float64), mesh.low.astype(np.float64))


def _pack(parts: list[_Part], shade: FloorShade) -> SceneBuffers:
    """Lay the parts' arrays end to end; world vertices and light are filled in when the parts get their poses."""
    meshes = [part.mesh for part in parts]
    triangle_count = sum(len(mesh.triangles) for mesh in meshes)
    if triangle_count > MOST_TRIANGLES:
        raise InvalidInputError(f"a home may show {MOST_TRIANGLES} triangles, this one has {triangle_count}")
    vertex_ends = np.cumsum([len(d.vertices) for d in meshes])
    triangle_ends = np.cumsum([len(d.triangles) for d in meshes])
    vertex_starts, triangle_starts = (np.concatenate([[0], ends[:-1]]) for ends in (vertex_ends, triangle_ends))
    atlas = AtlasBuilder()
    bases, colors, textures = _pack_materials(meshes, atlas)
    packed = atlas.build()
    vertex_count, part_count = int(vertex_ends[-1]), len(parts)
    return SceneBuffers(
        vertices=np.zeros((vertex_count, 3), dtype=np.float32),
        light=np.ones((vertex_count, 2), dtype=np.float32),
        uvs=np.concatenate([d.uvs for d in meshes]),
        triangles=np.concatenate([d.triangles + np.int32(s) for d, s in zip(meshes, vertex_starts, strict=True)]),
        triangle_parts=np.repeat(np.arange(part_count, dtype=np.int32), [len(d.triangles) for d in meshes]),
        triangle_materials=np.concatenate(
            [d.triangle_materials + np.int32(b) for d, b in zip(meshes, bases, strict=True)]
        ),
        texel_areas=np.concatenate([d.texel_areas for d in meshes]),
        material_colors=colors,
        material_textures=textures,
        texture_layout=packed.layout,
        texels=packed.texels,
        part_ranges=np.stack([vertex_starts, vertex_ends, triangle_starts, triangle_ends], axis=1).astype(np.int32),
        part_boxes=np.zeros((part_count, 8, 3), dtype=np.float32),
        part_labels=np.array([part.label for part in parts], dtype=np.int16),
        part_tints=np.ones((part_count, 3), dtype=np.float32),
        part_visible=np.ones(part_count, dtype=bool),
        part_is_stage=np.array([part.is_stage for part in parts], dtype=bool),
        floor_shade=shade.values,
        floor_frame=shade.frame,
    )


def _pack_materials(
    meshes: list[RenderMesh], atlas: AtlasBuilder
) -> tuple[list[int], NDArray[np.float32], NDArray[np.int32]]:
    """Return where each mesh's materials begin, and the colours and textures of all of them."""
    base_of: dict[int, int] = {}
    colors: list[NDArray[np.float32]] = []
    textures: list[int] = []
    bases = []
    for mesh in meshes:
        if id(mesh) not in base_of:
            base_of[id(mesh)] = len(textures)
            colors.append(mesh.colors)
            textures += [atlas.add(chain) for chain in mesh.textures]
        bases.append(base_of[id(mesh)])
    return bases, np.concatenate(colors), np.array(textures, dtype=np.int32)
