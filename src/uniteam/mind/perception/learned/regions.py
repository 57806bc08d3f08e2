"""From what the segmenter says of each cell to regions: connected pixels of one kind that depth does not part."""

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from uniteam.mind.perception.learned.geometry_image import STRIDE
from uniteam.mind.perception.learned.kinds import Kind

FEWEST_PIXELS = {Kind.OBJECT: 30, Kind.RECEPTACLE: 250}
"""Of a region, by its kind; what is smaller is not looked at."""
MOST_REGIONS = {Kind.OBJECT: 8, Kind.RECEPTACLE: 6}
"""In a frame; the largest."""
FARTHEST = {Kind.OBJECT: 4.0, Kind.RECEPTACLE: 8.0}
"""m; what is farther cannot be told."""
DEPTH_STEP = 0.08
"""Share of the depth by which neighbouring pixels of two things differ."""
ENDS_AT = 0.5
"""Probability from which on a thing ends in a cell."""
_RIM = 6
"""Pixels at a region's rim that cutting took, and that are given back."""


@dataclass(frozen=True)
class Region:
    """A region that may be one thing.

    Attributes:
        kind: `Kind.OBJECT` or `Kind.RECEPTACLE`.
        mask: (H, W) bool.
        certainty: mean probability of its kind.
        receptacle_scores: (R,) mean log-probability of each receptacle's name; meaningful for receptacles.
    """

    kind: Kind
    mask: NDArray[np.bool_]
    certainty: float
    receptacle_scores: NDArray[np.float32]


def find_regions(logits: NDArray[np.float32], depth: NDArray[np.float32]) -> list[Region]:
    """Return the regions of objects and receptacles of a frame, the largest of each kind first.

    Args:
        logits: (4 + 1 + R, H / STRIDE, W / STRIDE), as the segmenter gives them.
        depth: (H, W) in metres.
    """
    height, width = depth.shape
    count = len(Kind)
    fine = np.stack([cv2.resize(channel, (width, height)) for channel in logits[: count + 1]])
    kinds = fine[:count].argmax(axis=0)
    chances = _softmax(logits[:count])
    ends = (fine[count] > np.log(ENDS_AT / (1.0 - ENDS_AT))).astype(np.uint8)
    is_inside = (cv2.dilate(ends, np.ones((3, 3), np.uint8)) == 0) & ~_steps(depth)
    regions = []
    for kind in (Kind.OBJECT, Kind.RECEPTACLE):
        near = depth <= FARTHEST[kind]
        masks = _parts(kinds == kind, is_inside, near, FEWEST_PIXELS[kind])
        for mask in masks[: MOST_REGIONS[kind]]:
            cells = _cells(mask)
            names = np.log(_softmax(logits[count + 1 :, cells]) + 1e-6).mean(axis=1)
            regions.append(Region(kind, mask, float(chances[kind][cells].mean()), names.astype(np.float32)))
    return regions


def _parts(
    of_kind: NDArray[np.bool_], is_inside: NDArray[np.bool_], near: NDArray[np.bool_], fewest: int
) -> list[NDArray[np.bool_]]:
    """Return the connected parts of what is of a kind, the largest first, each with its rim."""
    whole = of_kind & near
    count, labels, stats, _ = cv2.connectedComponentsWithStats((whole & is_inside).astype(np.uint8), connectivity=4)
    areas = stats[1:, cv2.CC_STAT_AREA]
    kept = [int(i) + 1 for i in np.argsort(-areas, kind="stable") if areas[i] >= fewest]
    if not kept:
        return []
    grown = _grown(labels.astype(np.int32), whole, np.isin(np.arange(count), kept))
    return [grown == label for label in kept]


def _grown(labels: NDArray[np.int32], whole: NDArray[np.bool_], is_kept: NDArray[np.bool_]) -> NDArray[np.int32]:
    """Return the labels with the pixels of the kind that lie within the rim of a kept part added to it."""
    grown = np.where(is_kept[labels], labels, 0).astype(np.float32)
    kernel = np.ones((3, 3), np.uint8)
    for _ in range(_RIM):
        grown = np.where((grown == 0) & whole, cv2.dilate(grown, kernel), grown)
    return grown.astype(np.int32)


def _steps(depth: NDArray[np.float32]) -> NDArray[np.bool_]:
    """Return where depth jumps to the pixel at the right or below, or is missing."""
    jumps: NDArray[np.bool_] = np.asarray(depth <= 0, dtype=np.bool_)
    least = DEPTH_STEP * depth
    jumps[:, :-1] |= np.abs(np.diff(depth, axis=1)) > least[:, :-1]
    jumps[:-1] |= np.abs(np.diff(depth, axis=0)) > least[:-1]
    return jumps


def _cells(mask: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return the (h, w) cells whose middle a mask holds, or any cell that it touches where it holds no middle."""
    middles = mask[STRIDE // 2 :: STRIDE, STRIDE // 2 :: STRIDE]
    if middles.any():
        return middles
    height, width = mask.shape
    return np.asarray(mask.reshape(height // STRIDE, STRIDE, width // STRIDE, STRIDE).any(axis=(1, 3)))


def _softmax(logits: NDArray[np.float32]) -> NDArray[np.float32]:
    raised = np.exp(logits - logits.max(axis=0))
    return np.asarray(raised / raised.sum(axis=0), dtype=np.float32)
