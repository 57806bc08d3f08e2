"""The home of a miniature as our generator made it, with the reader's light, and what KTX2 leaves of its pictures.

Nothing of the readers is in it: the pictures are unpacked by another decoder, the light is written down here.
"""

from collections.abc import Iterable
from dataclasses import replace
from functools import cache
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray
from worlds.ovmm_miniature.glb_file import write_glb
from worlds.ovmm_miniature.ktx2_pictures import Ktx2Pictures
from worlds.ovmm_miniature.scene_files import stage_meshes

from uniteam.world.assets.mesh import Mesh, load_model_mesh
from uniteam.world.assets.model import Model
from uniteam.world.assets.textures import load_texture
from uniteam.world.homes.home import Home, Room
from uniteam.world.rendering.meshes.render_mesh import RenderMesh, make_render_mesh
from uniteam.world.rendering.scene import MeshOf


class PngPictures:
    """Keeps what KTX2 leaves of pictures, as PNG."""

    def __init__(self, coded: Ktx2Pictures) -> None:
        self._coded = coded

    def file(self, picture: NDArray[np.uint8]) -> bytes:
        """Return the PNG of what the coding leaves of a picture."""
        return cv2.imencode(".png", self._coded.left_of(picture)[..., ::-1])[1].tobytes()


def lit_alike(home: Home) -> Home:
    """Return a home with white light of one brightness in every room."""
    return replace(home, stage=replace(home.stage, rooms=tuple(_lit(home.stage.rooms))))


def with_its_stage_as_a_mesh(home: Home, folder: Path, coded: Ktx2Pictures) -> Home:
    """Return a home whose floors, walls and ceilings are one mesh, with what KTX2 leaves of their textures as PNG."""
    path = folder / f"{home.name}.glb"
    write_glb(path, stage_meshes(home), PngPictures(coded))
    rooms = tuple(replace(room, floor_texture=None, wall_texture=None) for room in home.stage.rooms)
    return replace(home, stage=replace(home.stage, rooms=rooms, walls=(), mesh=path))


def with_coded_textures(home: Home, folder: Path, coded: Ktx2Pictures) -> Home:
    """Return a home whose floors and walls show what KTX2 leaves of their textures."""
    textures = dict(home.library.textures)
    for name in sorted({n for r in home.stage.rooms for n in (r.floor_texture, r.wall_texture) if n is not None}):
        path = folder / f"{name}.png"
        path.write_bytes(PngPictures(coded).file(load_texture(textures[name])))
        textures[name] = replace(textures[name], path=path)
    return replace(home, library=replace(home.library, textures=textures))


def models_with_coded_textures(coded: Ktx2Pictures) -> MeshOf:
    """Return what shows a model with what KTX2 leaves of its textures."""

    @cache
    def shown(model: Model) -> RenderMesh:
        return make_render_mesh(_coded(load_model_mesh(model), coded))

    return lambda home, instance: shown(home.model_of(instance))


def _lit(rooms: Iterable[Room]) -> Iterable[Room]:
    return (replace(room, light=replace(room.light, color=(1.0, 1.0, 1.0), ambient=0.45)) for room in rooms)


def _coded(mesh: Mesh, coded: Ktx2Pictures) -> Mesh:
    def picture(texture: NDArray[np.uint8] | None) -> NDArray[np.uint8] | None:
        return None if texture is None else coded.left_of(texture)

    return replace(mesh, materials=tuple(replace(m, texture=picture(m.texture)) for m in mesh.materials))
