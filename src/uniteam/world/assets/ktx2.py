"""Pictures in KTX2 with Basis Universal, as compressed scene data sets have them (extra `hssd`).

The transcoder is `opengl-basisu`, the format https://registry.khronos.org/KTX/specs/2.0/ktxspec.v2.html.
"""

import struct

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import UnavailableError

MAGIC = b"\xabKTX 20\xbb\r\n\x1a\n"
LARGEST_SIDE = 1024
"""Of a larger picture a smaller level is taken (pixels): no more is shown of a texture."""


def size_of(content: bytes) -> tuple[int, int]:
    """Return width and height (pixels) of a picture's largest level, from its header; raises struct.error."""
    return struct.unpack_from("<II", content, 20)


def decode_ktx2(content: bytes) -> NDArray[np.uint8]:
    """Return a picture as (H, W, 3) RGB, of its largest level with no side above `LARGEST_SIDE`.

    Raises:
        UnavailableError: the extra `hssd` is not installed.
        ValueError: it is damaged, or not of Basis Universal.
    """
    try:
        import opengl_basisu
    except ImportError as error:
        raise UnavailableError(
            "textures in KTX2 need the extra hssd: pip install 'uniteam[hssd]', or export the models with PNG or JPEG"
        ) from error
    texture = opengl_basisu.open(content)
    level = next((k for k in range(texture.levels) if _side(texture, k) <= LARGEST_SIDE), texture.levels - 1)
    pixels = np.asarray(texture.transcode("rgba8", level=level).data)
    return np.ascontiguousarray(pixels[..., :3], dtype=np.uint8)


def _side(texture: "opengl_basisu.Texture", level: int) -> int:  # type: ignore[name-defined]  # noqa: F821
    return int(max(texture.width, texture.height)) >> level
