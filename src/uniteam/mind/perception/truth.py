"""Perception by the simulator's own segmentation: what a perfect detector would see."""

import numpy as np
from numba import njit
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError
from uniteam.interface import Detection, Instruction, Observation, Segmentation
from uniteam.mind.perception.segments import keep_detections
from uniteam.stretch import DEPTH_RANGE

SMALLEST_INSTANCE = 20
"""Pixels; what covers fewer is not seen."""


class TruthPerception:
    """Sees what the simulator says is there, but for what is too small or too far to be seen."""

    needs_truth = True

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Take a new instruction; there is nothing to forget."""

    def perceive(self, observation: Observation) -> Segmentation:
        """Return the observation's true segmentation, score 1; raises InvalidInputError where it carries none."""
        return visible_truth(observation)


def visible_truth(observation: Observation) -> Segmentation:
    """Return the observation's true segmentation without what is too small or too far to be seen.

    Raises:
        InvalidInputError: the observation carries no truth.
    """
    truth = observation.truth
    if truth is None:
        raise InvalidInputError(
            "perception 'truth' needs observations with their true segmentation, and this one has none; "
            "make the environment with give_truth=True"
        )
    seen, pixels = _in_range(truth.instances, observation.depth, len(truth.detections))
    certain = tuple(Detection(((detection.name, 1.0),)) for detection in truth.detections)
    return keep_detections(Segmentation(seen, certain), pixels >= SMALLEST_INSTANCE)


@njit(cache=True, nogil=True)
def _in_range(
    instances: NDArray[np.int16], depth: NDArray[np.float32], count: int
) -> tuple[NDArray[np.int16], NDArray[np.int64]]:  # pragma: no cover
    """Return the (H, W) instances where depth can be measured, -1 elsewhere, and how many pixels each has (count,)."""
    seen = np.full(instances.shape, -1, dtype=np.int16)
    pixels = np.zeros(count, dtype=np.int64)
    for row in range(instances.shape[0]):
        for column in range(instances.shape[1]):
            instance = instances[row, column]
            if instance >= 0 and 0 < depth[row, column] <= DEPTH_RANGE:
                seen[row, column] = instance
                pixels[instance] += 1
    return seen, pixels
