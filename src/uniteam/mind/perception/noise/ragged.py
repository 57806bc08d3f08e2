"""Masks whose edges are off: they bleed onto what is beside them, and leave out parts of their own."""

import cv2
import numpy as np
from numpy.typing import NDArray

_PATCH = 12
"""Pixels between places whose displacements have nothing to do with each other, in a frame 240 wide."""
_REFERENCE_WIDTH = 240


def ragged(instances: NDArray[np.int16], amplitude: float, dice: np.random.Generator) -> NDArray[np.int16]:
    """Return (H, W) indices whose edges wander by about `amplitude` pixels of a frame 240 wide.

    Each pixel takes the index of one nearby; which one varies smoothly over the image.
    """
    height, width = instances.shape
    scale = width / _REFERENCE_WIDTH
    coarse = (max(2, round(height / (_PATCH * scale))), max(2, round(width / (_PATCH * scale))))
    columns, rows = (
        cv2.resize(dice.normal(0.0, amplitude * scale, coarse).astype(np.float32), (width, height)) for _ in range(2)
    )
    there = np.indices((height, width), dtype=np.float32)
    moved = cv2.remap(
        instances, there[1] + columns, there[0] + rows, cv2.INTER_NEAREST, borderMode=cv2.BORDER_REPLICATE
    )
    return np.asarray(moved, dtype=np.int16)
