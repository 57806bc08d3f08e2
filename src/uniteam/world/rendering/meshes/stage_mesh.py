"""A home's stage as meshes: floors, walls with their openings, window panes, ceilings and the lamps that hang there."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.material import Color, Material
from uniteam.world.assets.mesh import Mesh
from uniteam.world.assets.reading import modified
from uniteam.world.assets.textures import Texture, load_texture
from uniteam.world.homes.fixed_mesh import stage_mesh
from uniteam.world.homes.home import Room, Stage, Wall
from uniteam.world.homes.polygon import as_rectangle
from uniteam.world.rendering.meshes.fixed_parts import LONGEST_SIDE, fixed_parts
from uniteam.world.rendering.meshes.mesh_builder import MeshBuilder, Plane, Surface, grid_cuts
from uniteam.world.rendering.meshes.refine import refined
from uniteam.world.rendering.meshes.wall_mesh import WallPainter, wall_faces

CEILING_SURFACE = Surface(Material((0.95, 0.95, 0.94)))
LAMP_SURFACE = Surface(Material((1.0, 0.98, 0.93)))
_LAMP_SIZE = np.array([0.36, 0.36, 0.05])


@dataclass(frozen=True)
class StagePart:
    """A piece of the stage that is lit by one room.

    Attributes:
        name: what it belongs to; several parts may share one ("ceiling", "wall_3", "floor", "stage").
        mesh: in the world frame.
        room: index of the room that lights it; None outside of every room.
        is_glowing: whether it shines by itself (a lamp, the sky in a window).
    """

    name: str
    mesh: Mesh
    room: int | None
    is_glowing: bool = False


def room_at(stage: Stage, x: float, y: float) -> int | None:
    """Return the index of the first room that holds a point (m, world), or None."""
    return next((index for index, room in enumerate(stage.rooms) if room.contains(x, y)), None)


def stage_parts(stage: Stage, library: Catalogue) -> tuple[StagePart, ...]:
    """Return everything of the stage that can be seen.

    Raises:
        UnknownNameError: a room names a texture that the library lacks.
        DamagedFileError: a texture or the stage's mesh cannot be read.
    """
    shown = [(index, room) for index, room in enumerate(stage.rooms) if room.floor_texture is not None]
    parts = [_floor(index, room, library) for index, room in shown]
    for index, room in shown:
        parts += [_ceiling(index, room, stage.ceiling_height), _lamp(index, room, stage.ceiling_height)]
    painter = WallPainter([_wall_surface(room, library) for room in stage.rooms], _room_finder(stage))
    for index, wall in enumerate(stage.walls):
        parts += [
            StagePart(f"wall_{index}", face.mesh, face.room, face.is_glowing)
            for face in wall_faces(wall, stage.ceiling_height, painter, _is_continued(wall, stage.walls))
        ]
    mesh = stage_mesh(stage)
    if mesh is not None:
        parts += [StagePart(*part) for part in fixed_parts(mesh, stage.ceiling_height, _room_finder(stage))]
    return tuple(parts)


def _room_finder(stage: Stage) -> Callable[[float, float], int | None]:
    return lambda x, y: room_at(stage, x, y)


@lru_cache(maxsize=64)
def _image(texture: Texture, *_: object) -> NDArray[np.uint8]:
    return load_texture(texture)


def _textured(name: str, color: Color, library: Catalogue) -> Surface:
    texture = library.texture(name)
    return Surface(Material(color, _image(texture, modified(texture.path))), texture.size)


def _is_continued(wall: Wall, walls: Sequence[Wall]) -> tuple[bool, bool]:
    """Say whether another wall goes on in the same line from a wall's start, and from its end."""
    along = np.subtract(wall.end, wall.start) / np.linalg.norm(np.subtract(wall.end, wall.start))
    others = [other for other in walls if other is not wall and _is_parallel(other, along)]
    start, end = (
        any(np.allclose(point, other_point, atol=1e-3) for other in others for other_point in (other.start, other.end))
        for point in (wall.start, wall.end)
    )
    return start, end


def _is_parallel(wall: Wall, along: NDArray[np.float64]) -> bool:
    step = np.subtract(wall.end, wall.start)
    return bool(abs(step[0] * along[1] - step[1] * along[0]) < 1e-6 * np.linalg.norm(step))


def _wall_surface(room: Room, library: Catalogue) -> Surface:
    if room.wall_texture is None:
        return Surface(Material(room.wall_tint))
    return _textured(room.wall_texture, room.wall_tint, library)


def _horizontal(room: Room, height: float, surface: Surface, up: float) -> Mesh:
    builder = MeshBuilder()
    plane = Plane(np.array([0.0, 0.0, height]), np.eye(3)[0], np.eye(3)[1], np.array([0.0, 0.0, up]))
    if as_rectangle(room.outline) is None:
        builder.add_polygon(plane, room.outline, surface)
        return refined(builder.build(), LONGEST_SIDE)
    cuts = (grid_cuts(room.low[0], room.high[0]), grid_cuts(room.low[1], room.high[1]))
    builder.add_rectangle(plane, cuts, surface)
    return builder.build()


def _floor(index: int, room: Room, library: Catalogue) -> StagePart:
    assert room.floor_texture is not None, "other rooms show no floor"
    surface = _textured(room.floor_texture, (1.0, 1.0, 1.0), library)
    return StagePart("floor", _horizontal(room, 0.0, surface, 1.0), index)


def _ceiling(index: int, room: Room, height: float) -> StagePart:
    return StagePart("ceiling", _horizontal(room, height, CEILING_SURFACE, -1.0), index)


def _lamp(index: int, room: Room, height: float) -> StagePart:
    x, y, _ = room.light.position
    frame = np.eye(4)
    frame[:3, 3] = (x, y, height - _LAMP_SIZE[2] / 2.0)
    builder = MeshBuilder()
    builder.add_box(-_LAMP_SIZE / 2.0, _LAMP_SIZE / 2.0, frame, LAMP_SURFACE)
    return StagePart("ceiling", builder.build(), index, is_glowing=True)
