"""Colour as JPEG and depth as JPEG 2000, as the bridge of stretch_ai packs them, checked before they are decoded."""

import struct

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.stretch import DEPTH_RANGE
from uniteam.world.real.robot_errors import StrangeMessageError

QUALITY = 90
"""Of the JPEG, as the bridge has it."""
RAW_SHARE = 800
"""Per mille of the raw size that the JPEG 2000 may take at most: in effect it is without loss."""
LONGEST_SIDE = 2048
"""Pixels; no camera of a Stretch has more."""

_END = b"\xff\xd9"
_WITHOUT_LENGTH = (0x01, *range(0xD0, 0xD9))
_FRAME_HEADERS = frozenset(range(0xC0, 0xD0)) - {0xC4, 0xC8, 0xCC}


def encode_rgb(rgb: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return the JPEG of (H, W, 3) colours; as in the bridge, red and blue change places in it, and back when read."""
    return np.asarray(cv2.imencode(".jpg", rgb, [cv2.IMWRITE_JPEG_QUALITY, QUALITY])[1])


def encode_depth(depth: NDArray[np.float32]) -> NDArray[np.uint8]:
    """Return the JPEG 2000 of (H, W) depth (m), in whole millimetres."""
    millimetres = np.rint(depth * 1000.0).astype(np.uint16)
    return np.asarray(cv2.imencode(".jp2", millimetres, [cv2.IMWRITE_JPEG2000_COMPRESSION_X1000, RAW_SHARE])[1])


def decode_rgb(data: bytes, shape: tuple[int, int]) -> NDArray[np.uint8]:
    """Return the read-only (H, W, 3) uint8 of a JPEG; raises StrangeMessageError where it is none of this shape."""
    _check(_jpeg_shape(data), shape, data, "colour")
    image = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_COLOR)
    if image is None or image.shape != (*shape, 3):
        raise StrangeMessageError("a message's colour image cannot be decoded; see that the robot sends whole ones")
    image.flags.writeable = False
    return np.asarray(image, np.uint8)


def decode_depth(data: bytes, shape: tuple[int, int]) -> NDArray[np.float32]:
    """Return the read-only (H, W) float32 depth (m) of a JPEG 2000, 0 where nothing returned or it is out of range.

    Raises:
        StrangeMessageError: it is none of this shape, or not of 16 bits.
    """
    _check(_jpeg2000_shape(data), shape, data, "depth")
    image = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_UNCHANGED)
    if image is None or image.shape != shape or image.dtype != np.uint16:
        raise StrangeMessageError("a message's depth image cannot be decoded; see that the robot sends whole ones")
    depth = image.astype(np.float32) / np.float32(1000.0)
    depth[depth > DEPTH_RANGE] = 0.0
    depth.flags.writeable = False
    return depth


def _check(found: tuple[int, int] | None, shape: tuple[int, int], data: bytes, name: str) -> None:
    """Refuse an image before it is decoded; one that says it is huge would fill the memory."""
    if found != shape or max(shape) > LONGEST_SIDE or not data.endswith(_END):
        raise StrangeMessageError(
            f"the {name} image of a message is cut short, or not of {shape[0]} rows and {shape[1]} columns as it says"
        )


def _jpeg_shape(data: bytes) -> tuple[int, int] | None:
    """Return the rows and columns that a JPEG's frame header names; None where there is none."""
    at = 2 if data.startswith(b"\xff\xd8") else len(data)
    while at + 9 <= len(data) and data[at] == 0xFF:
        marker = data[at + 1]
        if marker in _FRAME_HEADERS:
            rows, columns = struct.unpack(">HH", data[at + 5 : at + 9])
            return rows, columns
        at += 2 if marker in _WITHOUT_LENGTH else 2 + struct.unpack(">H", data[at + 2 : at + 4])[0]
    return None


def _jpeg2000_shape(data: bytes) -> tuple[int, int] | None:
    """Return the rows and columns of a JPEG 2000's first code stream (ISO 15444-1, SIZ); None where there is none."""
    at = data.find(b"\xff\x4f\xff\x51")
    if not data.startswith(b"\x00\x00\x00\x0cjP  ") or at < 0 or at + 40 > len(data):
        return None
    right, bottom, left, top = struct.unpack(">IIII", data[at + 8 : at + 24])
    return bottom - top, right - left
