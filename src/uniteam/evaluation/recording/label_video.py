"""Segmentations as films of bytes: a pixel's byte is its index and 1, so that 0 is where there is none.

An image of more than 254 detections has a second byte a pixel, in a film of its own.
"""

from collections.abc import Iterator
from itertools import repeat

import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.recording.video import BYTES, VideoEncoder, decode_video
from uniteam.interface import Segmentation

Labels = NDArray[np.int16]


class LabelEncoder:
    """Takes (H, W) segmentations in."""

    def __init__(self, height: int, width: int) -> None:
        """Begin without an image."""
        self._size = height, width
        self._low = VideoEncoder(BYTES, height, width)
        self._high: VideoEncoder | None = None
        self._count = 0

    def add(self, segmentation: Segmentation) -> None:
        """Append an image."""
        if self._high is None and len(segmentation.detections) >= 0xFF:
            self._high = VideoEncoder(BYTES, *self._size)
            for _ in range(self._count):
                self._high.add(np.zeros(self._size, np.uint8))
        codes = segmentation.instances + np.int16(1)
        self._low.add(codes.astype(np.uint8))
        if self._high is not None:
            self._high.add((codes >> 8).astype(np.uint8))
        self._count += 1

    def finish(self) -> tuple[bytes, bytes]:
        """Return the film of the low bytes and that of the high ones, which is empty where there are none."""
        return self._low.finish(), b"" if self._high is None else self._high.finish()


def decode_labels(low: bytes, high: bytes, height: int, width: int) -> Iterator[Labels]:
    """Yield the images one by one; raises ValueError where the content is no film."""
    nothing = np.zeros((height, width), np.uint8)
    highs = decode_video(high, BYTES, height, width) if high else repeat(nothing)
    for one, more in zip(decode_video(low, BYTES, height, width), highs, strict=False):
        codes = one.astype(np.uint16) | more.astype(np.uint16) << 8
        yield codes.view(np.int16) - np.int16(1)
