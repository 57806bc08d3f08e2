"""Pictures within files: JPEG, PNG and KTX2, whose size is known before they are unpacked."""

import struct

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.world.assets import ktx2

MOST_PIXELS = 4096 * 4096
"""A picture of more pixels is not unpacked: a small file can hold a very large one."""

_PNG = b"\x89PNG\r\n\x1a\n"
_JPEG = b"\xff\xd8"
_JPEG_SIZES = frozenset(range(0xC0, 0xD0)) - {0xC4, 0xC8, 0xCC}
"""Markers of the JPEG segments that say how large the picture is."""


def decode_image(content: bytes) -> NDArray[np.uint8]:
    """Return a picture as (H, W, 3) RGB.

    Raises:
        ValueError: it is none, is damaged or is too large.
        UnavailableError: it is in KTX2, for which an extra has to be installed.
    """
    width, height = picture_size(content)
    if not 0 < width * height <= MOST_PIXELS:
        raise ValueError(f"a picture of {width} x {height} pixels, where at most {MOST_PIXELS} in all are read")
    if content.startswith(ktx2.MAGIC):
        return ktx2.decode_ktx2(content)
    flags = cv2.IMREAD_COLOR | cv2.IMREAD_IGNORE_ORIENTATION
    try:
        decoded = cv2.imdecode(np.frombuffer(content, np.uint8), flags)
    except cv2.error as error:
        raise ValueError("a picture does not decode") from error
    if decoded is None:
        raise ValueError("a picture does not decode")
    return np.ascontiguousarray(decoded[..., ::-1], dtype=np.uint8)


def picture_size(content: bytes) -> tuple[int, int]:
    """Return width and height (pixels) from a picture's header; raises ValueError, struct.error where it has none."""
    if content.startswith(_PNG) and len(content) >= 24:
        return struct.unpack_from(">II", content, 16)
    if content.startswith(_JPEG):
        return _jpeg_size(content)
    if content.startswith(ktx2.MAGIC) and len(content) >= 28:
        return ktx2.size_of(content)
    raise ValueError("a picture that is neither JPEG nor PNG nor KTX2")


def _jpeg_size(content: bytes) -> tuple[int, int]:
    offset = len(_JPEG)
    while offset + 9 <= len(content) and content[offset] == 0xFF:
        if content[offset + 1] in _JPEG_SIZES:
            height, width = struct.unpack_from(">HH", content, offset + 5)
            return width, height
        offset += 1 if content[offset + 1] == 0xFF else 2 + struct.unpack_from(">H", content, offset + 2)[0]
    raise ValueError("a JPEG that does not say how large it is")
