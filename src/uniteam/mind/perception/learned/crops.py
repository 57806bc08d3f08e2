"""Crops of a frame around one region: square, of one size, what is around the region greyed.

Greying tells the network which thing of the crop is meant, and leaves a hint of what it stands on.
"""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

CROP_SIZE = 112
"""Pixels; of a side of what the namer is shown."""
CROP_MARGIN = 1.25
"""A crop's side over the longer side of the region's box."""
GREY = 127
GREYED = 0.6
"""How much of what is around the region is grey, from 0 to 1."""
SMALLEST_SIDE = 16.0
"""Of a crop, in pixels of the frame."""


@dataclass(frozen=True)
class Square:
    """A square of a frame, in pixels: its centre and its side; it may reach beyond the frame."""

    x: float
    y: float
    side: float


def square_around(mask: NDArray[np.bool_], margin: float = CROP_MARGIN) -> Square:
    """Return the square around the box of a region's (H, W) mask, which must not be empty."""
    rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
    top, bottom, left, right = rows[0], rows[-1] + 1, columns[0], columns[-1] + 1
    side = max(SMALLEST_SIDE, margin * max(bottom - top, right - left))
    return Square((left + right - 1) / 2.0, (top + bottom - 1) / 2.0, float(side))


def cut(image: NDArray[np.uint8], square: Square, size: int, fill: int) -> NDArray[np.uint8]:
    """Return the (size, size, ...) content of a square of an (H, W, ...) image, `fill` where it leaves the image."""
    half = square.side / 2.0
    left, top = round(square.x - half), round(square.y - half)
    side = max(1, round(square.side))
    height, width = image.shape[:2]
    inner = image[max(0, top) : min(height, top + side), max(0, left) : min(width, left + side)]
    whole = np.full((side, side, *image.shape[2:]), fill, dtype=np.uint8)
    row, column = max(0, -top), max(0, -left)
    whole[row : row + inner.shape[0], column : column + inner.shape[1]] = inner
    way = cv2.INTER_AREA if side > size else cv2.INTER_LINEAR
    return np.asarray(cv2.resize(whole, (size, size), interpolation=way))


def greyed(crop: NDArray[np.uint8], mask: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Return an (S, S, 3) crop with what is around the region greyed; `mask` (S, S) is 255 on it and 0 around."""
    keep = (1.0 - GREYED) + GREYED * (mask[..., None].astype(np.float32) / 255.0)
    return (crop * keep + GREY * (1.0 - keep) + 0.5).astype(np.uint8)


def region_crop(rgb: NDArray[np.uint8], mask: NDArray[np.bool_]) -> NDArray[np.uint8]:
    """Return the (CROP_SIZE, CROP_SIZE, 3) crop of a region: its mask may be smaller than the frame by a whole factor.

    Args:
        rgb: (H, W, 3), the finest frame at hand.
        mask: (h, w), the region, where H = k h and W = k w for a whole k.
    """
    square, factor = square_around(mask), rgb.shape[0] // mask.shape[0]
    fine = Square(square.x * factor + (factor - 1) / 2.0, square.y * factor + (factor - 1) / 2.0, square.side * factor)
    crop = cut(rgb, fine, CROP_SIZE, GREY)
    return greyed(crop, cut(mask.astype(np.uint8) * 255, square, CROP_SIZE, 0))
