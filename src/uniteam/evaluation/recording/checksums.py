"""Checksums of what an agent saw, by which a frame that is drawn again is known to be the same to the bit."""

import zlib
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.interface import Observation

Checksums = tuple[int, int, int]
"""CRC-32 of colour, depth, and the true segmentation (0 where there is none)."""


def checksums_of(observation: Observation) -> Checksums:
    """Return the checksums of an observation's images, row by row."""
    truth = observation.truth
    true = 0 if truth is None else zlib.crc32(repr([d.name for d in truth.detections]).encode())
    return (
        _checksum(observation.rgb),
        _checksum(observation.depth),
        true if truth is None else _checksum(truth.instances, true),
    )


def _checksum(image: NDArray[Any], before: int = 0) -> int:
    return zlib.crc32(np.ascontiguousarray(image).data, before)
