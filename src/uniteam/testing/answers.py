"""What is wrong with an answer: a decision, what is behind it, a segmentation; empty where nothing is."""

import numpy as np

from uniteam.errors import InvalidActionError
from uniteam.interface import (
    ACTION_LIMITS,
    BaseDisplacement,
    Decision,
    Detection,
    DiscreteAction,
    Explanation,
    MapOverlay,
    Observation,
    Segmentation,
)
from uniteam.world.task.check_action import checked_action

_SLACK = 1e-9


def decision_problem(decision: object, observation: Observation) -> str:
    """Return what keeps something from being a decision that a body can carry out as it is."""
    if not isinstance(decision, Decision):
        return f"must return a Decision, but returned {_kind(decision)}"
    for field in ("state", "reason"):
        words = getattr(decision, field)
        if not isinstance(words, str) or not words:
            return f"returned a Decision whose {field} is {words!r}; give it a few words"
    try:
        action = checked_action(decision.action)
    except InvalidActionError as error:
        return f"returned a Decision whose action is none: {error}"
    if isinstance(action, DiscreteAction):
        return ""
    return _displacement_problem(action if isinstance(action, BaseDisplacement) else action.base)


def _displacement_problem(base: BaseDisplacement) -> str:
    farthest = max(abs(base.x), abs(base.y))
    if farthest > ACTION_LIMITS.most_move + _SLACK:
        return (
            f"asks for a move of {farthest:g} m, which is cut to ACTION_LIMITS.most_move, {ACTION_LIMITS.most_move} m"
        )
    if abs(base.heading) > ACTION_LIMITS.most_turn + _SLACK:
        most = f"{ACTION_LIMITS.most_turn:.4f} rad"
        return f"asks for a turn of {base.heading:g} rad, which is cut to ACTION_LIMITS.most_turn, {most}"
    return ""


def explanation_problem(explanation: object, observation: Observation) -> str:
    """Return what keeps something from being the explanation of a decision upon an observation."""
    if not isinstance(explanation, Explanation):
        return f"must return an Explanation, but returned {_kind(explanation)}"
    problem = ""
    if explanation.segmentation is not None:
        problem = segmentation_problem(explanation.segmentation, observation)
    if not problem and explanation.overlay is not None:
        problem = _overlay_problem(explanation.overlay)
    return problem


def _overlay_problem(overlay: MapOverlay) -> str:
    if overlay.labels.ndim != 2 or overlay.labels.dtype != np.uint8:
        return f"returned a map whose labels are {_shape(overlay.labels)}; they must be (H, W) uint8"
    for field in ("goal", "path"):
        points = getattr(overlay, field)
        if points.ndim != 2 or points.shape[1] != 2 or points.dtype != np.float64:
            return f"returned a map whose {field} is {_shape(points)}; it must be (N, 2) float64"
    return "" if overlay.cell_size > 0.0 else f"returned a map whose cell_size is {overlay.cell_size}; it must be in m"


def segmentation_problem(segmentation: object, observation: Observation) -> str:
    """Return what keeps something from being the segmentation of an observation."""
    if not isinstance(segmentation, Segmentation):
        return f"must return a Segmentation, but returned {_kind(segmentation)}"
    if segmentation.instances.shape != observation.depth.shape:
        return (
            f"returned instances of {segmentation.instances.shape} for a frame of {observation.depth.shape}; "
            "resize them to the frame, by nearest neighbour"
        )
    if not isinstance(segmentation.detections, tuple):
        return f"returned detections in {_kind(segmentation.detections)}; they must be a tuple of Detection"
    problems = (_detection_problem(i, detection) for i, detection in enumerate(segmentation.detections))
    return next((problem for problem in problems if problem), "")


def _detection_problem(index: int, detection: object) -> str:
    if not isinstance(detection, Detection):
        return f"returned as detection {index} {_kind(detection)}; it must be a Detection"
    if not all(name for name, _ in detection.candidates):
        return f"returned a detection {index} with a candidate without a name"
    scores = [score for _, score in detection.candidates]
    if scores != sorted(scores, reverse=True):
        return f"returned a detection {index} whose candidates have the scores {scores}; put the best first"
    embedding = detection.embedding
    if embedding is not None and not (
        isinstance(embedding, np.ndarray) and embedding.ndim == 1 and embedding.dtype == np.float32
    ):
        return f"returned a detection {index} whose embedding is {_shape(embedding)}; it must be (D,) float32"
    return ""


def _kind(value: object) -> str:
    return "None" if value is None else f"a {type(value).__name__}"


def _shape(array: object) -> str:
    return f"{array.shape} {array.dtype}" if isinstance(array, np.ndarray) else _kind(array)
