"""What a glTF binary takes in memory once it is shown, told from its headers: nothing is unpacked for it."""

import struct
from dataclasses import dataclass
from pathlib import Path

import msgspec

from uniteam.world.assets.gltf import GltfBinary, read_gltf
from uniteam.world.assets.image import picture_size
from uniteam.world.assets.ktx2 import LARGEST_SIDE
from uniteam.world.assets.reading import damaged, read_bytes

_BYTES_A_VERTEX = 64
_BYTES_A_TEXEL = 4 * 4 / 3
"""With the smaller levels."""


@dataclass(frozen=True)
class MeshCost:
    """What a file holds.

    Attributes:
        vertices: how many.
        texels: of its pictures, none of which is shown with a side of more than 1024.
    """

    vertices: int
    texels: int

    @property
    def in_memory(self) -> int:
        """Bytes of a scene that shows it once, about."""
        return round(self.vertices * _BYTES_A_VERTEX + self.texels * _BYTES_A_TEXEL)


def mesh_cost(path: Path) -> MeshCost:
    """Return what a glTF binary costs; raises DamagedFileError where it is none."""
    content = read_bytes(path, "the model")
    try:
        gltf = read_gltf(content)
        return MeshCost(_vertices(gltf), sum(_texels(gltf, image.buffer_view) for image in gltf.document.images))
    except (ValueError, IndexError, KeyError, struct.error, msgspec.MsgspecError, RecursionError) as error:
        raise damaged(path, "the model", str(error)) from error


def _vertices(gltf: GltfBinary) -> int:
    document = gltf.document
    return sum(document.accessors[p.attributes["POSITION"]].count for m in document.meshes for p in m.primitives)


def _texels(gltf: GltfBinary, view: int | None) -> int:
    if view is None:
        return 0
    width, height = picture_size(bytes(gltf.view(view)))
    return min(width, LARGEST_SIDE) * min(height, LARGEST_SIDE)
