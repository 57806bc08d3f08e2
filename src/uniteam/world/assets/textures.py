"""Floor and wall textures of the pack: square tiles that repeat, and how much of a floor one covers."""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.errors import DamagedFileError, UnknownNameError
from uniteam.world.assets.catalogue import PACK_DIRECTORY

TEXTURE_DIRECTORY = PACK_DIRECTORY / "textures"

TextureKind = Literal["floor", "wall"]


@dataclass(frozen=True)
class Texture:
    """What the pack knows of a texture; `size` is the side (m) of the square that one tile covers."""

    kinds: tuple[TextureKind, ...]
    size: float
    title: str
    source: str
    creator: str
    licence: str
    checksum: str


@lru_cache(maxsize=1)
def load_textures() -> Mapping[str, Texture]:
    """Read the list of textures by name; raises DamagedFileError where it is missing or no such list."""
    path = TEXTURE_DIRECTORY / "textures.json"
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        return {name: Texture(**{**entry, "kinds": tuple(entry["kinds"])}) for name, entry in sorted(data.items())}
    except (OSError, ValueError, TypeError, KeyError, AttributeError) as error:
        raise DamagedFileError(f"the list of textures {path} cannot be read ({error}); reinstall uniteam") from error


def texture_names(kind: TextureKind) -> tuple[str, ...]:
    """Return the names of the textures for floors or for walls, sorted."""
    return tuple(name for name, texture in load_textures().items() if kind in texture.kinds)


def texture_size(name: str) -> float:
    """Return the side (m) of the square that one tile covers."""
    return _texture(name).size


def load_texture(name: str) -> NDArray[np.uint8]:
    """Return the (H, W, 3) RGB image of a texture.

    Raises:
        UnknownNameError: the pack has no such texture.
        DamagedFileError: its file does not decode.
    """
    _texture(name)
    path = TEXTURE_DIRECTORY / f"{name}.jpg"
    image = cv2.imread(str(path), cv2.IMREAD_COLOR)
    if image is None:
        raise DamagedFileError(f"the texture {path} cannot be read; reinstall uniteam")
    return np.ascontiguousarray(image[..., ::-1], dtype=np.uint8)


def _texture(name: str) -> Texture:
    try:
        return load_textures()[name]
    except KeyError:
        raise UnknownNameError("texture", name, load_textures()) from None
