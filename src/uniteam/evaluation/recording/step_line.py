"""A step as a line of JSON: what was decided and why, and what came of it."""

from dataclasses import dataclass

import msgspec
import numpy as np

from uniteam.errors import InvalidInputError
from uniteam.evaluation.recording.action_data import ActionData, action_from_data, action_to_data
from uniteam.geometry import Point2
from uniteam.interface import Decision, Detection
from uniteam.world.simulation.step_events import StepEvents
from uniteam.world.simulation.touches import Touches
from uniteam.world.task.measures import Measures


@dataclass(frozen=True)
class MapLine:
    """Of a map, what is not in the arrays: where it lies, and how much of the arrays is its own.

    Attributes:
        origin: (x, y) of its first corner (m, start frame).
        cell_size: m.
        shape: rows and columns.
        changed: how many cells differ from the map before.
        goal: how many points the goal has.
        path: how many points the path has.
        short_term_goal: (x, y) (m, start frame), or None.
    """

    origin: Point2
    cell_size: float
    shape: tuple[int, int]
    changed: int
    goal: int
    path: int
    short_term_goal: Point2 | None = None


@dataclass(frozen=True)
class RecordedStep:
    """One step but for its images and poses.

    Attributes:
        step: its number, from 0.
        decision: what the agent decided.
        detections: what its perception answered; the segmentation's pixels are indices of them. None for an agent that
            does not say.
        map: where its map lies; None for an agent without one.
        events: what the action came to (truth).
        measures: after it (truth).
        held: the instance in the gripper after it (truth), or None.
        resting_on: what the object that was let go of last touches, once it lies still: names of instances, "wall",
            "floor" (truth); None before that, while it moves, and while the gripper holds something.
    """

    step: int
    decision: Decision
    detections: tuple[Detection, ...] | None
    map: MapLine | None
    events: StepEvents
    measures: Measures
    held: str | None
    resting_on: tuple[str, ...] | None


class TruthData(msgspec.Struct, forbid_unknown_fields=True):
    """What the agent was not told."""

    blocked: bool
    robot_scene: str | None
    obj_scene: str | None
    robot_obj: str | None
    grasped: str | None
    released: str | None
    held: str | None
    resting_on: tuple[str, ...] | None
    measures: Measures


class StepData(msgspec.Struct, forbid_unknown_fields=True):
    """A line."""

    step: int
    action: ActionData
    state: str
    reason: str
    detections: tuple[tuple[tuple[str, float], ...], ...] | None
    map: MapLine | None
    truth: TruthData


def _plain(value: object) -> object:
    """Return a number of NumPy, which agents hand on, as Python's own."""
    if isinstance(value, np.generic):
        return value.item()
    raise TypeError(f"a step cannot hold a {type(value).__name__}")


_ENCODER = msgspec.json.Encoder(enc_hook=_plain)
_DECODER = msgspec.json.Decoder(StepData)


def step_to_line(step: RecordedStep) -> bytes:
    """Return a step as a line of JSON, with its line feed."""
    touches = step.events.touches
    data = StepData(
        step=step.step,
        action=action_to_data(step.decision.action),
        state=text(step.decision.state),
        reason=text(step.decision.reason),
        detections=None if step.detections is None else tuple(map(_candidates, step.detections)),
        map=step.map,
        truth=TruthData(
            step.events.blocked, touches.robot_scene, touches.obj_scene, touches.robot_obj,
            step.events.grasped, step.events.released, step.held, step.resting_on, step.measures,
        ),
    )  # fmt: skip
    return _ENCODER.encode(data) + b"\n"


def step_from_line(line: bytes) -> RecordedStep:
    """Return the step that `step_to_line` wrote.

    Raises:
        ValueError: the line is no step.
    """
    try:
        data = _DECODER.decode(line)
        detections = None if data.detections is None else tuple(Detection(c) for c in data.detections)
        action = action_from_data(data.action)
    except (msgspec.MsgspecError, InvalidInputError, RecursionError) as error:
        raise ValueError(f"a step of it is none: {error}") from error
    truth = data.truth
    touches = Touches(truth.robot_scene, truth.obj_scene, truth.robot_obj)
    return RecordedStep(
        step=data.step,
        decision=Decision(action, data.state, data.reason),
        detections=detections,
        map=data.map,
        events=StepEvents(truth.blocked, touches, truth.grasped, truth.released),
        measures=truth.measures,
        held=truth.held,
        resting_on=truth.resting_on,
    )


def text(words: object) -> str:
    """Return an agent's own words as they can be written: what is no text (half of a surrogate pair) is replaced."""
    return str(words).encode(errors="replace").decode()


def _candidates(detection: Detection) -> tuple[tuple[str, float], ...]:
    return tuple((text(name), float(score)) for name, score in detection.candidates)
