"""The attempts to grasp."""

from collections.abc import Mapping

import numpy as np

from uniteam.evaluation.causes.reading.belief import Look
from uniteam.evaluation.causes.reading.places import box_of
from uniteam.evaluation.causes.story import Grasp
from uniteam.evaluation.recording.recording import Recording
from uniteam.interface import DiscreteAction
from uniteam.stretch import gripper_to_base

REMEMBERED = 40
"""Steps before a grasp of which what the agent believed may be why it grasps: it turns, folds and looks in between."""


def grasp_steps(recording: Recording) -> list[int]:
    """Return the steps at which it grasped with nothing in the gripper."""
    held = [None, *(step.held for step in recording.steps)]
    return [
        step.step
        for step in recording.steps
        if step.decision.action is DiscreteAction.SNAP_OBJECT and held[step.step] is None
    ]


def moment_before_grasp(recording: Recording, step: int) -> int:
    """Return the last moment, of the few before a grasp, at which it believed to see the object; else its own."""
    category = recording.episode.instruction.object_category
    before = recording.steps[max(0, step - REMEMBERED) : step + 1]
    return next((s.step for s in reversed(before) if any(d.name == category for d in s.detections or ())), step)


def read_grasps(recording: Recording, looks: Mapping[int, Look]) -> tuple[Grasp, ...]:
    """Return the attempts; `looks` are pictures by moment."""
    return tuple(
        _grasp(recording, step, looks.get(moment_before_grasp(recording, step))) for step in grasp_steps(recording)
    )


def _grasp(recording: Recording, step: int, look: Look | None) -> Grasp:
    base, poses = recording.base_to_world(step), recording.objects.at(step)
    gripper = (base.matrix() @ gripper_to_base(recording.true_joints(step)))[:2, 3]
    distances = {}
    for candidate in recording.episode.objects:
        low, high = box_of(recording.home, candidate.name, poses[candidate.name])
        distances[candidate.name] = float(np.hypot(*((low + high)[:2] / 2 - gripper)))
    in_view = {name: bool(recording.visible_pixels(name)[step]) for name in distances}
    nearest = min(distances, key=lambda name: (not in_view[name], distances[name]))
    category = recording.episode.instruction.object_category
    believed = None if look is None else look.taken_for(category, recording.header.instances)
    thing = recording.home.by_name.get(believed or "")
    return Grasp(
        step=step,
        nearest=nearest,
        distance=distances[nearest],
        is_in_view=in_view[nearest],
        believed=believed,
        is_of_class=thing is not None and thing.category == category,
        took=recording.steps[step].events.grasped,
        place=(base.x, base.y),
    )
