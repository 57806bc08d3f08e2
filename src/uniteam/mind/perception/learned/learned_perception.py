"""Perception `learned`: from colours, depth and the words of the instruction to detections, by networks of our own.

A segmenter says where things are, a namer what each of them is (see `docs/perception.md`). Frames are segmented at
240x320; where the run's camera is finer, things are named from the finer frame.
"""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from uniteam.interface import Detection, Instruction, Observation, Segmentation
from uniteam.mind.perception.learned.asking import Asked, Asking
from uniteam.mind.perception.learned.eyes import Eyes, Glimpse
from uniteam.mind.perception.learned.kinds import Kind
from uniteam.mind.perception.learned.networks import WEIGHTS, read_card
from uniteam.mind.perception.words.meaning import load_words

HIGHEST_SCORE = 0.99
"""Nothing that networks say is certain."""


class LearnedPerception:
    """Finds what the instruction names in colours and depth."""

    def __init__(self, weights: Path = WEIGHTS) -> None:
        """Load the networks of a folder, those of the package by default, and the words.

        Raises:
            DamagedFileError: a file of the package cannot be read.
        """
        self._eyes, self._asking = Eyes(weights), Asking(read_card(weights), load_words())
        self._asked: tuple[Asked, ...] = ()

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Take the instruction's words; raises UnknownNameError for one that cannot be read."""
        receptacles = dict.fromkeys((instruction.start_receptacle, instruction.goal_receptacle))
        self._asked = (
            self._asking.asked(instruction.object_category, Kind.OBJECT),
            *(self._asking.asked(word, Kind.RECEPTACLE) for word in receptacles),
        )

    def perceive(self, observation: Observation) -> Segmentation:
        """Return what of an observation may be what the instruction names, with calibrated scores."""
        shape = observation.depth.shape
        instances = np.full(shape, -1, dtype=np.int16)
        found = [(self._candidates(glimpse), glimpse) for glimpse in self._eyes.look(observation)]
        found = sorted((pair for pair in found if pair[0]), key=lambda pair: pair[0][0][1])
        for index, (_, glimpse) in enumerate(found):
            instances[_at_size(glimpse.region.mask, shape)] = index
        detections = tuple(Detection(candidates, glimpse.vector) for candidates, glimpse in found)
        return Segmentation(instances, detections)

    def _candidates(self, glimpse: Glimpse) -> tuple[tuple[str, float], ...]:
        """Return the words of a glimpse's kind with their scores, the likeliest first: low ones are evidence too."""
        scores = [
            (asked.word, min(self._asking.score(glimpse, asked), HIGHEST_SCORE))
            for asked in self._asked
            if asked.kind is glimpse.region.kind
        ]
        return tuple(sorted(scores, key=lambda pair: -pair[1]))


def _at_size(mask: NDArray[np.bool_], shape: tuple[int, ...]) -> NDArray[np.bool_]:
    """Return a mask of half size at a size."""
    if mask.shape == shape:
        return mask
    rows = np.arange(shape[0]) * mask.shape[0] // shape[0]
    columns = np.arange(shape[1]) * mask.shape[1] // shape[1]
    return mask[rows][:, columns]
