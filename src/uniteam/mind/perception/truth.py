"""Perception by the simulator's own segmentation: what a perfect detector would see."""

import numpy as np

from uniteam.errors import InvalidInputError
from uniteam.interface import Detection, Instruction, Observation, Segmentation
from uniteam.mind.perception.segments import keep_detections

SMALLEST_INSTANCE = 20
"""Pixels; what covers fewer is not seen."""

FARTHEST_INSTANCE = 10.0
"""m; what is farther is not seen."""


def truth_perception(observation: Observation, instruction: Instruction) -> Segmentation:
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
    near = (observation.depth > 0) & (observation.depth <= FARTHEST_INSTANCE)
    seen = np.where(near, truth.instances, np.int16(-1))
    pixels = np.bincount(seen.ravel() + 1, minlength=len(truth.detections) + 1)[1:]
    certain = tuple(Detection(((detection.name, 1.0),)) for detection in truth.detections)
    return keep_detections(Segmentation(seen, certain), pixels >= SMALLEST_INSTANCE)
