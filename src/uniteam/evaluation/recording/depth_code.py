"""Depth as bytes: 255 distances in even proportions, of every second pixel each way.

It is what people look at, and tells a distance to 1 %. The depth that the agent saw, to the bit, is drawn again from
the recorded poses (`RecordedBody`).
"""

import numpy as np
from numpy.typing import NDArray

from uniteam.stretch import DEPTH_RANGE

NEAREST = 0.1
"""m; what is nearer counts as being there."""
STRIDE = 2
"""Every how many pixels one is kept, each way."""
RELATIVE_ERROR = 0.01
"""The most by which a distance from `NEAREST` to `DEPTH_RANGE` differs once it has been decoded, of itself."""

_LEVELS = 255


def _distances() -> NDArray[np.float32]:
    """Return the distance that each byte stands for, (256,); 0 is 0."""
    shares = np.arange(_LEVELS) / (_LEVELS - 1)
    return np.concatenate([[0.0], NEAREST * (DEPTH_RANGE / NEAREST) ** shares]).astype(np.float32)


def _bytes_of_halves() -> NDArray[np.uint8]:
    """Return the byte for each of the 65,536 half-precision numbers, which are finer than the bytes."""
    halves = np.arange(1 << 16, dtype=np.uint32).astype(np.uint16).view(np.float16).astype(np.float64)
    is_depth = halves > 0.0
    shares = np.log(np.where(is_depth, halves, 1.0) / NEAREST) / np.log(DEPTH_RANGE / NEAREST)
    return np.where(is_depth, 1.0 + np.clip(np.rint(shares * (_LEVELS - 1)), 0, _LEVELS - 1), 0).astype(np.uint8)


_DISTANCES, _BYTES = _distances(), _bytes_of_halves()


def encode_depth(depth: NDArray[np.float32]) -> NDArray[np.uint8]:
    """Return (ceil(H / 2), ceil(W / 2)) bytes of (H, W) depth (m)."""
    with np.errstate(over="ignore"):
        halves = depth[::STRIDE, ::STRIDE].astype(np.float16)
    return np.take(_BYTES, halves.view(np.uint16))


def decode_depth(code: NDArray[np.uint8]) -> NDArray[np.float32]:
    """Return the depth (m) of what `encode_depth` returned, of its shape; 0 where nothing returned."""
    return np.take(_DISTANCES, code)
