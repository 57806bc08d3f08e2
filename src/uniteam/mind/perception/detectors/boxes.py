"""Boxes of a detector: which of them to keep, and which of their pixels show the thing."""

import numpy as np
from numpy.typing import NDArray

from uniteam.interface import Observation

LEAST_MARGIN = 0.1
"""m; depth is not taken for the background within this of the thing's own."""


def keep_apart(boxes: NDArray[np.float32], scores: NDArray[np.float32], most_overlap: float) -> list[int]:
    """Return the indices of the boxes that overlap no surer one too much, the surest first.

    Args:
        boxes: (N, 4) corners x0, y0, x1, y1.
        scores: (N,).
        most_overlap: the largest intersection over union of two boxes that are both kept.
    """
    kept: list[int] = []
    for index in np.argsort(-scores, kind="stable"):
        if all(overlap(boxes[index], boxes[other]) <= most_overlap for other in kept):
            kept.append(int(index))
    return kept


def overlap(one: NDArray[np.float32], other: NDArray[np.float32]) -> float:
    """Return the intersection over union of two boxes (4,)."""
    low, high = np.maximum(one[:2], other[:2]), np.minimum(one[2:], other[2:])
    shared = float(np.prod(np.clip(high - low, 0.0, None)))
    union = float(np.prod(one[2:] - one[:2]) + np.prod(other[2:] - other[:2])) - shared
    return shared / union if union > 0.0 else 0.0


def mask_of_box(box: NDArray[np.floating], observation: Observation) -> NDArray[np.bool_]:
    """Return the (H, W) pixels of a box (x0, y0, x1, y1) that are as near as the thing in it.

    A thing is taken to be no deeper than its box is wide or high; what lies farther behind what the middle of the box
    shows, or nearer, is not of it. Pixels without depth count, for nothing is known of them.
    """
    height, width = observation.depth.shape
    x0, y0 = (int(np.clip(np.floor(value), 0, most)) for value, most in zip(box[:2], (width, height), strict=True))
    x1, y1 = (int(np.clip(np.ceil(value), 0, most)) for value, most in zip(box[2:], (width, height), strict=True))
    mask = np.zeros((height, width), dtype=bool)
    inside = observation.depth[y0:y1, x0:x1]
    if inside.size == 0:
        return mask
    quarter_y, quarter_x = inside.shape[0] // 4, inside.shape[1] // 4
    core = inside[quarter_y : inside.shape[0] - quarter_y, quarter_x : inside.shape[1] - quarter_x]
    middle = float(np.median(core[core > 0])) if (core > 0).any() else 0.0
    extent = max(x1 - x0, y1 - y0) * middle / observation.camera.fx
    near = np.abs(inside - middle) <= max(extent, LEAST_MARGIN)
    mask[y0:y1, x0:x1] = near | (inside == 0) if middle > 0.0 else True
    return mask
