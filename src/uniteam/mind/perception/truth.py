"""Perception by the simulator's own segmentation: what a perfect detector would see."""

import numpy as np

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
    near = (observation.depth > 0) & (observation.depth <= DEPTH_RANGE)
    seen = truth.instances | (near.view(np.int8) - np.int8(1))
    pixels = np.bincount(seen.ravel() + 1, minlength=len(truth.detections) + 1)[1:]
    certain = tuple(Detection(((detection.name, 1.0),)) for detection in truth.detections)
    return keep_detections(Segmentation(seen, certain), pixels >= SMALLEST_INSTANCE)
