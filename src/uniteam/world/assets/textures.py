"""Floor and wall textures of a library: square tiles that repeat, and how much of a floor one covers.

They stand in `textures/textures.json` of the library's folder, by the stem of the JPEG beside it:

    {"oak": {"kinds": ["floor"], "size": 1.2}}
"""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

import msgspec
import numpy as np
from numpy.typing import NDArray

from uniteam.world.assets.catalogue_file import Identifier, Length, Text
from uniteam.world.assets.image import decode_image
from uniteam.world.assets.reading import PACK_DIRECTORY, damaged, read_bytes, read_json

TextureKind = Literal["floor", "wall"]


@dataclass(frozen=True)
class Texture:
    """What a library knows of a texture.

    Attributes:
        kinds: what it is for.
        size: side of the square that one tile covers (m).
        title, source, creator, licence: what it shows, where it is from and who made it.
        checksum: SHA-256 of its file; empty where nobody wrote one down.
        path: its JPEG.
    """

    kinds: tuple[TextureKind, ...]
    size: float
    title: str
    source: str
    creator: str
    licence: str
    checksum: str
    path: Path


class _Texture(msgspec.Struct, forbid_unknown_fields=True):
    kinds: Annotated[tuple[TextureKind, ...], msgspec.Meta(min_length=1, max_length=2)]
    size: Length
    title: Text = ""
    source: Text = ""
    creator: Text = ""
    licence: Text = ""
    checksum: Text = ""


def read_textures(folder: Path) -> Mapping[str, Texture]:
    """Return the textures of a library's folder by name, sorted; none where it has no `textures/`.

    Raises:
        DamagedFileError: the list of textures is missing or is no such list.
    """
    directory = folder / "textures"
    if not directory.exists() and folder != PACK_DIRECTORY:
        return {}
    listed = read_json(directory / "textures.json", "the list of textures", dict[Identifier, _Texture])
    return {
        name: Texture(**msgspec.structs.asdict(entry), path=directory / f"{name}.jpg")
        for name, entry in sorted(listed.items())
    }


def load_texture(texture: Texture) -> NDArray[np.uint8]:
    """Return the (H, W, 3) RGB image of a texture; raises DamagedFileError where its file is missing or no picture."""
    try:
        return decode_image(read_bytes(texture.path, "the texture"))
    except ValueError as error:
        raise damaged(texture.path, "the texture", str(error)) from error
