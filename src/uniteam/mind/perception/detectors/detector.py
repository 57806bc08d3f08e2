"""From a detector of named things to a perception."""

import hashlib
from collections import OrderedDict
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from uniteam.interface import Detection, Instruction, Observation, Segmentation

KEPT_FRAMES = 256
"""Frames whose detections are kept: a robot that comes back to where it was, or stands still, sees the same again."""
MOST_DETECTIONS = 200
"""Of one frame; the surest are kept."""


def ranked(names: Sequence[str], scores: NDArray[np.floating]) -> tuple[tuple[str, float], ...]:
    """Return a detection's candidates: the names with their scores, the highest first."""
    return tuple(sorted(zip(names, map(float, scores), strict=True), key=lambda one: -one[1]))


@dataclass(frozen=True)
class Found:
    """One thing that a detector found.

    Attributes:
        mask: (H, W) bool, the pixels that show it.
        detection: what it may be.
    """

    mask: NDArray[np.bool_]
    detection: Detection


class Detector(Protocol):
    """Whatever finds named things in a frame; a function of the frame and the names."""

    def detect(self, observation: Observation, names: tuple[str, ...]) -> Sequence[Found]:
        """Return what was found, in any order; masks may overlap, candidates bear the names that were asked for."""


class DetectorPerception:
    """Asks a detector for the names of the instruction."""

    def __init__(self, detector: Detector) -> None:
        """Take a detector; `reset` gives the names."""
        self._detector = detector
        self._names: tuple[str, ...] = ()
        self._kept: OrderedDict[bytes, Segmentation] = OrderedDict()

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Take a new vocabulary; there is nothing else to forget."""
        self._names = asked_names(instruction)

    def perceive(self, observation: Observation) -> Segmentation:
        """Return what the detector finds; where masks overlap, the surer one has the pixel."""
        key = _key(observation, self._names)
        if key not in self._kept:
            found = self._detector.detect(observation, self._names)
            self._kept[key] = paint(found, observation.depth.shape)
            if len(self._kept) > KEPT_FRAMES:
                self._kept.popitem(last=False)
        self._kept.move_to_end(key)
        return self._kept[key]


@dataclass(frozen=True)
class DetectorFactory:
    """Makes perceptions of a detector.

    Attributes:
        load: returns the detector; called when a perception is made.
        libraries: packages whose version results depend on.
        outside_modules: modules of others whose source they depend on.
    """

    load: Callable[[], Detector]
    libraries: tuple[str, ...] = ()
    outside_modules: tuple[str, ...] = ()

    def __call__(self) -> DetectorPerception:
        """Return a new perception; raises UnavailableError where a library or the weights are missing."""
        return DetectorPerception(self.load())


def asked_names(instruction: Instruction) -> tuple[str, ...]:
    """Return the classes of an instruction, each once."""
    asked = (instruction.object_category, instruction.start_receptacle, instruction.goal_receptacle)
    return tuple(dict.fromkeys(name for name in asked if name))


def as_words(name: str) -> str:
    """Return a class's name as people write it: "chest of drawers"."""
    return name.replace("_", " ").strip().lower()


def paint(found: Iterable[Found], shape: tuple[int, ...]) -> Segmentation:
    """Return the segmentation of what was found in a frame of a shape (H, W), without what is wholly covered."""
    surest = sorted(found, key=lambda one: one.detection.score, reverse=True)[:MOST_DETECTIONS]
    instances = np.full(shape, -1, dtype=np.int16)
    detections: list[Detection] = []
    for one in surest:
        left = one.mask & (instances < 0)
        if left.any():
            instances[left] = len(detections)
            detections.append(one.detection)
    instances.flags.writeable = False
    return Segmentation(instances, tuple(detections))


def _key(observation: Observation, names: tuple[str, ...]) -> bytes:
    """Return a digest of all that a detection depends on."""
    together = hashlib.blake2b("\0".join(names).encode(), digest_size=16)
    together.update(observation.rgb.tobytes())
    together.update(observation.depth.tobytes())
    return together.digest()
