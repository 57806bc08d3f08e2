"""What the robot believes each thing to be, over all frames and views that showed it (`instance_memory`).

Things are told apart in space, as in ConceptGraphs (Gu et al., arXiv 2309.16650): what a detection shows is part of a
known instance where enough of its points fall into grains that the instance was seen in. An instance keeps the scores
of each view, and a detection's own scores give way to what all views together say: one frame that takes a bin for a
hamper does not make it one. That holds for furniture, which is large; a small object is told in its best view, and the
many from afar say nothing of it, so that it stays with each frame.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import Point3, grain_keys, pixels_of, transform_points
from uniteam.interface import Detection, Instruction, Observation, Segmentation
from uniteam.mind.perception.segments import change_detections

Remember = Callable[[Segmentation, Observation, Instruction], Segmentation]
"""From what one frame shows to what is believed of it after all that came before."""

GRAIN = 0.06
"""m; side of the grains in which an instance is kept."""
_LEAST_SCORE = 1e-3
_VIEW_DISTANCE, _VIEW_ANGLE = 0.5, np.radians(30.0)
"""A camera that has moved or turned around an instance by less has the same view of it."""


def forget_instances() -> Remember:
    """Begin an episode in which each frame stands for itself, as in HomeRobot."""
    return _as_it_is


def _as_it_is(segmentation: Segmentation, observation: Observation, instruction: Instruction) -> Segmentation:
    return segmentation


@dataclass(frozen=True)
class InstanceMemory:
    """Begins an episode in which instances are remembered.

    Attributes:
        overlap: a detection belongs to the instance that holds at least this share of its grains, or of which it holds
            so much.
        prior: of a detection's being what was asked for, where nothing is known.
        agreement: n views that agree weigh as n to this power of independent ones: 1 if they were, 0 if one said all.
        clear: the share of the frame from which on a view weighs in full; a smaller one weighs less, since what is far
            looks like nothing in particular, which says little against its being what was asked for.
        most_points: of a detection that are looked at.
    """

    overlap: float = 0.3
    prior: float = 0.08
    agreement: float = 0.5
    clear: float = 0.03
    most_points: int = 600

    def __call__(self) -> Remember:
        """Return a memory that holds nothing yet."""
        return _Memory(self)


@dataclass
class _View:
    """What was seen from a place, (x, y) (m) from the instance: the sums of the scores by name, and how many frames.

    Its size is the largest share of a frame that the instance took.
    """

    place: NDArray[np.float64]
    scores: dict[str, float]
    frames: int
    size: float


@dataclass
class _Instance:
    """A thing: the grains it fills, sorted, the box (m, start frame) that they lie in, and the views of it."""

    grains: NDArray[np.int64]
    low: Point3
    high: Point3
    views: list[_View] = field(default_factory=list)

    def share(self, other: "_Instance") -> float:
        """Return which share of the smaller of two things lies in the larger one's grains."""
        ranges = zip(self.low, self.high, other.low, other.high, strict=True)
        if any(low > their_high or their_low > high for low, high, their_low, their_high in ranges):
            return 0.0
        fewer, more = sorted((self.grains, other.grains), key=len)
        place = np.minimum(np.searchsorted(more, fewer), len(more) - 1)
        return float(np.mean(more[place] == fewer))

    def take(self, other: "_Instance") -> None:
        """Add the grains of what is seen of it."""
        self.grains = np.union1d(self.grains, other.grains)
        self.low = _each(min, self.low, other.low)
        self.high = _each(max, self.high, other.high)


class _Memory:
    """The instances of an episode."""

    def __init__(self, config: InstanceMemory) -> None:
        self._config = config
        self._instances: list[_Instance] = []

    def __call__(self, segmentation: Segmentation, observation: Observation, instruction: Instruction) -> Segmentation:
        """Return the segmentation with the scores that all views of what may be an asked receptacle together give."""
        asked = {instruction.start_receptacle, instruction.goal_receptacle}
        believed = [
            self._believed(detection, observation, segmentation.instances == index)
            if any(name in asked for name, _ in detection.candidates)
            else detection
            for index, detection in enumerate(segmentation.detections)
        ]
        return change_detections(segmentation, believed)

    def _believed(self, detection: Detection, observation: Observation, mask: NDArray[np.bool_]) -> Detection:
        """Return a detection, which shows the pixels of a mask, with what is believed of its instance."""
        points = _points(observation, mask, self._config.most_points)
        if len(points) == 0:
            return detection
        instance = self._instance_of(detection, _seen(points))
        size = np.count_nonzero(mask) / mask.size
        _add_view(instance, detection, size, (observation.camera_to_start[:3, 3] - points.mean(axis=0))[:2])
        scores = [(name, self._belief(instance, name)) for name, _ in detection.candidates]
        return Detection(tuple(sorted(scores, key=lambda pair: -pair[1])), detection.embedding)

    def _instance_of(self, detection: Detection, seen: _Instance) -> _Instance:
        """Return the known instance that a detection shows most of, with its grains added, or a new one."""
        names = {name for name, _ in detection.candidates}
        alike = [instance for instance in self._instances if names & instance.views[0].scores.keys()]
        best = max(alike, key=seen.share, default=None)
        if best is None or seen.share(best) < self._config.overlap:
            self._instances.append(seen)
            return seen
        best.take(seen)
        return best

    def _belief(self, instance: _Instance, name: str) -> float:
        """Return how probable a name is, by all views of an instance."""
        prior = _logit(self._config.prior)
        weights = [min(1.0, view.size / self._config.clear) for view in instance.views]
        evidence = sum(
            weight * (_logit(view.scores.get(name, 0.0) / view.frames) - prior)
            for weight, view in zip(weights, instance.views, strict=True)
        )
        evidence *= max(1.0, sum(weights)) ** (self._config.agreement - 1.0)
        return float(1.0 / (1.0 + np.exp(-(prior + evidence))))


def _points(observation: Observation, mask: NDArray[np.bool_], most: int) -> NDArray[np.float64]:
    """Return the (N, 3) points (m, start frame) of an (H, W) mask's pixels, evenly thinned to at most so many."""
    rows, columns = pixels_of(mask & (observation.depth > 0), most)
    depth = observation.depth[rows, columns].astype(np.float64)
    return transform_points(observation.camera_to_start, observation.camera.unproject_pixels(rows, columns, depth))


def _seen(points: NDArray[np.float64]) -> _Instance:
    """Return what a detection shows, by its (N, 3) points (m, start frame)."""
    low, high = points.min(axis=0) - GRAIN, points.max(axis=0) + GRAIN
    return _Instance(np.unique(grain_keys(points, GRAIN)), tuple(low.tolist()), tuple(high.tolist()))


def _each(choose: Callable[[float, float], float], one: Point3, other: Point3) -> Point3:
    return choose(one[0], other[0]), choose(one[1], other[1]), choose(one[2], other[2])


def _add_view(instance: _Instance, detection: Detection, size: float, from_it: NDArray[np.float64]) -> None:
    """Add a detection's scores to those of the view it belongs to.

    Args:
        instance: what it shows.
        detection: has the scores.
        size: the share of the frame that it takes.
        from_it: (x, y) (m) leads from it to the camera.
    """
    view = next((view for view in instance.views if _is_same_view(view.place, from_it)), None)
    if view is None:
        view = _View(from_it, {}, 0, 0.0)
        instance.views.append(view)
    view.frames += 1
    view.size = max(view.size, size)
    for name, score in detection.candidates:
        view.scores[name] = view.scores.get(name, 0.0) + score


def _is_same_view(one: NDArray[np.float64], other: NDArray[np.float64]) -> bool:
    lengths = float(np.linalg.norm(one)), float(np.linalg.norm(other))
    cosine = one @ other / max(lengths[0] * lengths[1], 1e-9)
    return bool(abs(lengths[0] - lengths[1]) < _VIEW_DISTANCE and cosine > np.cos(_VIEW_ANGLE))


def _logit(score: float) -> float:
    """Return the logarithm of a score's odds; a score of 1 is certain, and remains so whatever else is seen."""
    return float("inf") if score >= 1.0 else float(np.log(max(score, _LEAST_SCORE) / (1.0 - max(score, _LEAST_SCORE))))
