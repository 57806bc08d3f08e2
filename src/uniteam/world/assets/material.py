"""What a mesh is made of: colours and pictures, as a glTF binary has them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.world.assets.gltf import GltfBinary, MaterialEntry, TextureEntry
from uniteam.world.assets.image import MOST_PIXELS, decode_image

Color = tuple[float, float, float]

_MOST_TEXELS = 4 * 3 * MOST_PIXELS


@dataclass(frozen=True)
class Material:
    """A surface: its colour (sRGB, [0, 1]) multiplies the texture ((H, W, 3) uint8 sRGB) where there is one.

    One that is not lit shows its colour as it is, as lamps and the sky in a window do; of a stage only.
    """

    color: Color
    texture: NDArray[np.uint8] | None = None
    is_lit: bool = True


def materials_of(gltf: GltfBinary, last: int) -> tuple[Material, ...]:
    """Return the document's materials, and a plain one after them where `last`, the last in use, asks for it."""
    entries = gltf.document.materials
    if last > len(entries):
        raise ValueError("a primitive is of a material that does not exist")
    plain = [MaterialEntry()] if last == len(entries) else []
    pictures: dict[int, NDArray[np.uint8]] = {}
    return tuple(_material(gltf, entry, pictures) for entry in (*entries, *plain))


def plain_materials(gltf: GltfBinary, last: int) -> tuple[Material, ...]:
    """Return as many materials as `materials_of` does, all of them white."""
    return (Material((1.0, 1.0, 1.0)),) * max(len(gltf.document.materials), last + 1)


def _material(gltf: GltfBinary, entry: MaterialEntry, pictures: dict[int, NDArray[np.uint8]]) -> Material:
    """Return a material; its picture is unpacked where it is not among those of the others, by their views."""
    surface = entry.pbr_metallic_roughness
    r, g, b = (_srgb(v) for v in surface.base_color_factor[:3])
    is_lit = entry.extensions.unlit is None
    if surface.base_color_texture is None:
        return Material((r, g, b), is_lit=is_lit)
    source = _source(gltf.document.textures[surface.base_color_texture.index])
    view = None if source is None else gltf.document.images[source].buffer_view
    if view is None:
        raise ValueError("a texture lies outside of the file, or is in a format that is not read")
    if view not in pictures:
        pictures[view] = decode_image(bytes(gltf.view(view)))
    if sum(picture.size for picture in pictures.values()) > _MOST_TEXELS:
        raise ValueError("its textures together would fill the memory; make them smaller")
    return Material((r, g, b), pictures[view], is_lit)


def _source(texture: TextureEntry) -> int | None:
    """Return the image that a texture shows; the one in KTX2 where there is one, as files need not hold another."""
    return texture.source if texture.extensions.basisu is None else texture.extensions.basisu.source


def _srgb(linear: float) -> float:
    linear = min(max(linear, 0.0), 1.0)
    return 12.92 * linear if linear <= 0.0031308 else 1.055 * linear ** (1 / 2.4) - 0.055
