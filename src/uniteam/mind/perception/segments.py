"""Segmentations with some of their detections changed or left out."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from uniteam.interface import Detection, Segmentation


def keep_detections(segmentation: Segmentation, keep: ArrayLike) -> Segmentation:
    """Return the segmentation without the detections whose entry of `keep` (D,) is false; the others move up."""
    kept = np.asarray(keep, dtype=bool)
    changed = [d if k else None for d, k in zip(segmentation.detections, kept, strict=True)]
    return change_detections(segmentation, changed)


def change_detections(segmentation: Segmentation, changed: Sequence[Detection | None]) -> Segmentation:
    """Return the segmentation with each detection replaced by its entry of `changed`; None leaves it out."""
    if all(detection is not None for detection in changed):
        return Segmentation(segmentation.instances, tuple(detection for detection in changed if detection is not None))
    new_index = np.full(len(changed) + 1, -1, dtype=np.int16)
    detections: list[Detection] = []
    for index, detection in enumerate(changed):
        if detection is not None:
            new_index[index] = len(detections)
            detections.append(detection)
    return Segmentation(new_index.take(segmentation.instances, mode="wrap"), tuple(detections))
