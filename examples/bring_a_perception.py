"""Bring a perception of your own: a detector that wavers, made of the truth. A real one calls its network here.

uniteam evaluate --agents baseline uniteam-plus --perception bring_a_perception:Wavering
"""

import numpy as np

from uniteam import Detection, Instruction, Observation, Segmentation

SURE_UNTIL = 1.0
"""m; farther away, the score falls with the distance."""


class Wavering:
    """Misses what is far away more often than not, and is never quite sure of the rest."""

    needs_truth = True  # leave this out: a real detector is shown rgb and depth only

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Begin an episode; a detector takes its vocabulary from the instruction."""
        self.generator = np.random.default_rng(seed)

    def perceive(self, observation: Observation) -> Segmentation:
        """Return what was noticed in this frame."""
        assert observation.truth is not None
        instances = np.full(observation.depth.shape, -1, np.int16)
        detections: list[Detection] = []
        for index in np.unique(observation.truth.instances[observation.depth > 0]):
            mask = observation.truth.instances == index
            score = min(1.0, SURE_UNTIL / max(float(np.median(observation.depth[mask])), 0.1))
            if index >= 0 and mask.sum() >= 50 and self.generator.random() < score**0.5:
                instances[mask] = len(detections)
                detections.append(Detection(((observation.truth.detections[index].name, score),)))
        return Segmentation(instances, tuple(detections))
