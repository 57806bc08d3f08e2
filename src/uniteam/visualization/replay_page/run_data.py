"""One recording as the page carries it."""

from collections.abc import Callable, Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import InvalidInputError
from uniteam.evaluation.recording.recording import Recording
from uniteam.evaluation.recording.step_line import RecordedStep
from uniteam.visualization.captions import MILESTONES, describe_action
from uniteam.visualization.narration import Narrator
from uniteam.visualization.replay_page.map_changes import map_data
from uniteam.visualization.replay_page.packing import packed
from uniteam.visualization.replay_page.picture_film import film_data

COLLISIONS = {
    "robot_scene_colls": "arm or gripper touched the scene",
    "obj_scene_colls": "what the gripper held touched something",
    "robot_obj_colls": "arm or gripper touched a small object",
}
"""The measures that count steps, in words."""


def run_data(recording: Recording, advance: Callable[[], None]) -> dict[str, Any]:
    """Return a recording as plain data.

    Args:
        recording: of one episode.
        advance: called for each moment, once it has been drawn.

    Raises:
        InvalidInputError: no step was taken.
        DamagedFileError: a part of the recording cannot be read.
    """
    steps, result, told = recording.steps, recording.result, recording.header.configuration
    if not steps:
        raise InvalidInputError(f"in '{recording.path}' no step was taken, so that there is nothing to show")
    return {
        "agent": recording.header.agent,
        "about": {
            "split": recording.split_name,
            "episode": result.episode,
            "home": result.home,
            "perception": str(told.get("perception", "")),
            "camera": str(told.get("camera", "")),
            "grasp": str(told.get("grasp", "")),
            "uniteam": recording.header.uniteam,
        },
        "steps": len(steps),
        "success": result.measures.overall_success,
        "failure": result.failure,
        "decisions": _decisions(steps),
        "measures": _measures(steps),
        "story": _story(steps),
        "robot": _robot(recording),
        "truth": _truth(recording),
        "map": map_data(list(recording.maps())),
        "pictures": film_data(recording, advance),
    }


def _decisions(steps: tuple[RecordedStep, ...]) -> dict[str, Any]:
    """Return each state, reason and action once, and which of them each step has."""
    return {
        "state": _told_once(step.decision.state for step in steps),
        "reason": _told_once(step.decision.reason for step in steps),
        "action": _told_once(describe_action(step.decision.action) for step in steps),
    }


def _told_once(words: Iterable[str]) -> dict[str, Any]:
    numbers: dict[str, int] = {}
    own = [numbers.setdefault(word, len(numbers)) for word in words]
    return {"words": list(numbers), "steps": packed(np.array(own, np.uint16))}


def _measures(steps: tuple[RecordedStep, ...]) -> dict[str, Any]:
    """Return after which step each measure is reached, and how often something has been touched after each step."""
    reached = {
        words: next((step.step for step in steps if getattr(step.measures, name)), None)
        for name, words in MILESTONES.items()
    }
    return {
        "reached": [{"words": words, "step": step} for words, step in reached.items()],
        "touched": [
            {"words": words, "counts": packed(np.array([getattr(s.measures, name) for s in steps], np.uint16))}
            for name, words in COLLISIONS.items()
        ],
        "blocked": packed(np.array([step.events.blocked for step in steps], np.uint8)),
        "held": [None if step.held is None else step.held.replace("_", " ") for step in steps],
    }


def _story(steps: tuple[RecordedStep, ...]) -> list[dict[str, Any]]:
    """Return what matters, as `uniteam run` tells it."""
    story: list[dict[str, Any]] = []
    narrator = Narrator(lambda step, kind, words: story.append({"step": step, "kind": kind, "words": words}))
    for step in steps:
        narrator.tell(step.step, step)
    return story


def _robot(recording: Recording) -> dict[str, Any]:
    """Return where the robot believed to be at each moment and where its camera looked: x, y (m), two headings."""
    moments = range(len(recording.steps) + 1)
    bases = [recording.base_to_start(moment) for moment in moments]
    forward = [recording.camera_to_start(moment)[:2, 2] for moment in moments]
    rows = [(b.x, b.y, b.heading, np.arctan2(f[1], f[0])) for b, f in zip(bases, forward, strict=True)]
    return {"poses": packed(np.array(rows, np.float32))}


def _truth(recording: Recording) -> dict[str, Any]:
    """Return where what counts lay, in the frame in which the robot believed to be: x, y (m)."""
    base, believed = recording.base_to_world(0), recording.base_to_start(0)
    world_to_start = believed.matrix() @ np.linalg.inv(base.matrix())
    instances = {instance.name: instance for instance in recording.home.instances}
    episode = recording.episode
    return {
        "objects": [_moves(recording, candidate.name, world_to_start) for candidate in episode.objects],
        "goals": [
            _seen_from_start(np.array(instances[goal.name].position), world_to_start)
            for goal in episode.goal_receptacles
            if goal.name in instances
        ],
    }


def _moves(recording: Recording, name: str, world_to_start: NDArray[np.float64]) -> list[list[float]]:
    """Return the moments from which an object lay elsewhere than before, with where: moment, x, y."""
    moves: list[list[float]] = []
    for moment in range(len(recording.steps) + 1):
        where = _seen_from_start(recording.objects.at(moment)[name][:3, 3], world_to_start)
        if not moves or moves[-1][1:] != where:
            moves.append([moment, *where])
    return moves


def _seen_from_start(point: NDArray[np.float64], world_to_start: NDArray[np.float64]) -> list[float]:
    x, y, *_ = world_to_start @ np.append(point, 1.0)
    return [round(float(x), 2), round(float(y), 2)]
