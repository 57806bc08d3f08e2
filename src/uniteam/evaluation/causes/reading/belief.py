"""What the agent believed of what it saw: its own segmentation beside the true one, which is drawn again."""

from collections import Counter
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.recording.body import RecordedBody
from uniteam.evaluation.recording.recording import Recording
from uniteam.interface import Segmentation

NOT_A_THING = "floor or wall"
LEAST_SHARE = 0.3
"""Of an instance's pixels that must be of one detection for it to be that."""


@dataclass(frozen=True)
class Look:
    """One picture: what the agent believed, and what was there.

    Attributes:
        believed: the agent's segmentation.
        true: (H, W) indices of the home's instances, -1 for walls, floor and ceiling.
    """

    believed: Segmentation
    true: NDArray[np.int16]

    def name_of(self, instance: int) -> str:
        """Return what an instance of the home was believed to be; empty for nothing."""
        own = self.true == instance
        labels = self.believed.instances[own]
        counts = np.bincount(labels[labels >= 0])
        if not counts.size or counts.max() < LEAST_SHARE * own.sum():
            return ""
        return self.believed.detections[int(counts.argmax())].name

    def taken_for(self, category: str, names: tuple[str, ...]) -> str | None:
        """Return what most pixels of what was believed to be of a category are; None where nothing was.

        Args:
            category: as detections are named.
            names: of the home's instances, in their order.
        """
        which = [k for k, detection in enumerate(self.believed.detections) if detection.name == category]
        pixels = self.true[np.isin(self.believed.instances, which)]
        if not which or not pixels.size:
            return None
        most = Counter(pixels.tolist()).most_common(1)[0][0]
        return names[most] if most >= 0 else NOT_A_THING


def look_again(recording: Recording, moments: Collection[int]) -> Mapping[int, Look]:
    """Return what was believed and true at those of some moments at which the agent said what it believed.

    Raises:
        DamagedFileError: a film of the recording cannot be read.
    """
    wanted = {moment for moment in moments if _says(recording, moment)}
    if not wanted:
        return {}
    body = RecordedBody(recording)
    return {
        moment: Look(frame.segmentation, body.frame(moment).instances)
        for moment, frame in enumerate(recording.frames())
        if moment in wanted and frame.segmentation is not None
    }


def spread(moments: Iterable[int], most: int) -> list[int]:
    """Return at most so many of some moments, evenly spread over them."""
    everything = list(moments)
    if len(everything) <= most:
        return everything
    return [everything[k] for k in np.linspace(0, len(everything) - 1, most).round().astype(int)]


def _says(recording: Recording, moment: int) -> bool:
    return moment < len(recording.steps) and recording.steps[moment].detections is not None
