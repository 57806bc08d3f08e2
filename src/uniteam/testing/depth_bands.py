"""A perception that needs no truth, to see with where an agent is checked without it."""

import numpy as np

from uniteam.interface import Detection, Instruction, Observation, Segmentation

BANDS = (1.2, 2.0, 3.0)
"""Up to where (m) there is the object, then the start receptacle, then the goal receptacle."""


class DepthBands:
    """Takes what is near for the object, and what is farther for the receptacles: wrong, but the same for everybody."""

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Take the names to give."""
        names = (instruction.object_category, instruction.start_receptacle, instruction.goal_receptacle)
        self._detections = tuple(Detection(((name, 1.0),)) for name in names)

    def perceive(self, observation: Observation) -> Segmentation:
        """Return the bands of depth."""
        bands = np.digitize(observation.depth, BANDS).astype(np.int16)
        bands[(observation.depth <= 0.0) | (bands == len(BANDS))] = -1
        return Segmentation(bands, self._detections)
