"""Which detections to believe: functions from a segmentation to one that holds only those.

A filter drops detections and candidates; what is left is taken at its word: a detection is what its best candidate is.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import partial

import numpy as np
from numpy.typing import NDArray

from uniteam.interface import Detection, Instruction, Observation, Segmentation
from uniteam.mind.perception.segments import change_detections, keep_detections
from uniteam.mind.perception.vocabulary import ClassRole, roles_of, roles_of_name

Filter = Callable[[Segmentation, Observation, Instruction], Segmentation]


@dataclass(frozen=True)
class Fall:
    """How a threshold falls while an episode goes on: who has searched for long should do with less evidence.

    Attributes:
        first_step, last_step: between these steps it falls in a straight line, before and after it does not.
        to: the share of it that is left in the end.
    """

    first_step: int
    last_step: int
    to: float

    def share(self, step: int) -> float:
        """Return which share of the threshold is left at a step."""
        return float(np.interp(step, (self.first_step, self.last_step), (1.0, self.to)))


@dataclass(frozen=True)
class Thresholds:
    """The lowest score that is believed, by what a class is to the instruction, or by its name where that is known.

    The baseline has one for everything, UniTeam's `class_thresholds` one for each role, which may fall.

    Attributes:
        by_role: of the instruction's classes.
        other: of every other class.
        by_class: of single classes; goes before the others.
        falls: how those of a role fall with the steps; of a role that is left out they do not.
    """

    by_role: Mapping[ClassRole, float]
    other: float
    by_class: Mapping[str, float] = field(default_factory=dict)
    falls: Mapping[ClassRole, Fall] = field(default_factory=dict)

    @staticmethod
    def single(threshold: float) -> "Thresholds":
        """Return one threshold for everything, as HomeRobot's baseline has it."""
        return Thresholds({role: threshold for role in ClassRole}, threshold)

    def of(self, name: str, instruction: Instruction, step: int = 0) -> float:
        """Return the threshold of a class at a step; the lowest of its roles' where it plays several."""
        roles = roles_of_name(name, instruction)
        of_roles = (self.by_class.get(name, self.by_role[role]) * self._share(role, step) for role in roles)
        return min(of_roles, default=self.by_class.get(name, self.other))

    def _share(self, role: ClassRole, step: int) -> float:
        return self.falls[role].share(step) if role in self.falls else 1.0


@dataclass(frozen=True)
class ScoreFilter:
    """Drops the candidates whose score is below their class's threshold, and the detections that have none left."""

    thresholds: Thresholds

    def __call__(self, segmentation: Segmentation, observation: Observation, instruction: Instruction) -> Segmentation:
        """Return what is believed of the segmentation."""
        believed = partial(self._believed, instruction=instruction, step=observation.step)
        return change_detections(segmentation, [believed(d) for d in segmentation.detections])

    def _believed(self, detection: Detection, instruction: Instruction, step: int) -> Detection | None:
        of = partial(self.thresholds.of, instruction=instruction, step=step)
        candidates = tuple((name, score) for name, score in detection.candidates if score >= of(name))
        return Detection(candidates, detection.embedding) if candidates else None


@dataclass(frozen=True)
class FloorFilter:
    """Drops what lies on the floor, receptacles that end below a height and objects that begin at it: `floor_filter`.

    Attributes:
        lowest_receptacle: a receptacle whose highest seen part is lower (m above the floor) is dropped.
        lowest_object: an object whose lowest seen part is lower (m above the floor) is dropped.
    """

    lowest_receptacle: float = 0.15
    lowest_object: float = 0.06

    def __call__(self, segmentation: Segmentation, observation: Observation, instruction: Instruction) -> Segmentation:
        """Return the segmentation without the instruction's classes that lie on the floor."""
        indices = [i for i, d in enumerate(segmentation.detections) if roles_of(d, instruction)]
        if not indices:
            return segmentation
        above_floor = heights(observation)
        keep = np.ones(len(segmentation.detections), dtype=bool)
        for index in indices:
            on_object = (segmentation.instances == index) & (observation.depth > 0)
            roles = roles_of(segmentation.detections[index], instruction)
            keep[index] = self._stands_high(above_floor[on_object], roles)
        return keep_detections(segmentation, keep)

    def _stands_high(self, heights: NDArray[np.float32], roles: tuple[ClassRole, ...]) -> bool:
        if heights.size == 0:
            return True
        if ClassRole.OBJECT in roles:
            return percentile_reaches(heights, 5, self.lowest_object)
        return percentile_reaches(heights, 95, self.lowest_receptacle)


def percentile_reaches(values: NDArray[np.float32], percent: int, bound: float) -> bool:
    """Return whether a percentile of (N,) values is at least a bound.

    It lies between two neighbours of the sorted values, so it need be known only where they lie on both sides.
    """
    below, rank = len(values) - np.count_nonzero(values >= bound), percent / 100 * (len(values) - 1)
    if abs(below - rank) > 2:
        return bool(below < rank)
    return bool(np.percentile(values, percent) >= bound)


def heights(observation: Observation) -> NDArray[np.float32]:
    """Return the (H, W) height (m above the floor) of what each pixel shows."""
    camera, to_start = observation.camera, observation.camera_to_start.astype(np.float32)
    u = (np.arange(camera.width, dtype=np.float32) - np.float32(camera.cx)) / np.float32(camera.fx)
    v = (np.arange(camera.height, dtype=np.float32) - np.float32(camera.cy)) / np.float32(camera.fy)
    rising = to_start[2, 0] * u[None, :] + to_start[2, 1] * v[:, None] + to_start[2, 2]
    return observation.depth * rising + to_start[2, 3]
