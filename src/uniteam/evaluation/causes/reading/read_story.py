"""Read what happened from a recording."""

from collections.abc import Iterator, Mapping
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.causes.reading.belief import Look, look_again
from uniteam.evaluation.causes.reading.driving import bases_of, read_standstill, width_of_way
from uniteam.evaluation.causes.reading.grasps import grasp_steps, moment_before_grasp, read_grasps
from uniteam.evaluation.causes.reading.releases import moment_of_belief, read_release, release_step
from uniteam.evaluation.causes.reading.targets import moments_to_look, read_target
from uniteam.evaluation.causes.story import Phase, Story, Target, Touch
from uniteam.evaluation.recording.recording import Recording

MOVED_FAR = 0.1
"""m; what falls asleep on furniture moves less."""
MOST_GRASPS = 40
"""Attempts to grasp of which the picture is looked into, the last ones."""


def read_story(recording: Recording) -> Story:
    """Return what happened in a recorded episode.

    Pictures are drawn again where it must be known what was believed of which thing: at most a few dozen of each thing
    that counts.

    Raises:
        DamagedFileError: the recording's home or films cannot be read.
    """
    bases, taken_at = bases_of(recording), _taken_at(recording)
    looks = look_again(recording, _moments(recording, taken_at))
    objects, receptacles = _targets(recording, looks, bases, taken_at)
    release = read_release(recording, looks)
    held = recording.steps[-1].held if recording.steps else None
    x, y = bases[-1]
    return Story(
        instruction=recording.episode.instruction,
        measures=recording.result.measures,
        traceback=recording.result.traceback,
        phases=tuple(_phases(recording)),
        last_words=recording.steps[-1].decision.reason if recording.steps else "",
        end=(float(x), float(y)),
        objects=objects,
        receptacles=receptacles,
        grasps=read_grasps(recording, looks),
        taken_at=taken_at,
        held=held,
        release=release,
        standstill=read_standstill(bases, [step.events.blocked for step in recording.steps]),
        touches=tuple(_touches(recording, bases)),
        way=None if recording.result.measures.place_success else _way(recording, bases, taken_at),
        has_said=any(step.detections is not None for step in recording.steps),
        moved_alone=_moved_alone(recording),
    )


def _taken_at(recording: Recording) -> int | None:
    names = {candidate.name for candidate in recording.episode.objects}
    return next((step.step for step in recording.steps if step.events.grasped in names), None)


def _moments(recording: Recording, taken_at: int | None) -> set[int]:
    """Return the moments at which it must be known what was believed."""
    episode, end = recording.episode, len(recording.steps)
    belief = moment_of_belief(recording, release_step(recording))
    return {
        *moments_to_look(recording, [c.name for c in episode.objects], end if taken_at is None else taken_at + 1),
        *moments_to_look(recording, [c.name for c in episode.goal_receptacles], end),
        *(moment_before_grasp(recording, step) for step in grasp_steps(recording)[-MOST_GRASPS:]),
        *([] if belief is None else [belief]),
    }


def _targets(
    recording: Recording, looks: Mapping[int, Look], bases: NDArray[np.float64], taken_at: int | None
) -> tuple[tuple[Target, ...], tuple[Target, ...]]:
    """Return candidate objects and goal receptacles."""
    episode, count = recording.episode, len(bases)
    until = count if taken_at is None else taken_at + 1
    asked = episode.instruction
    objects = tuple(
        read_target(recording, c.name, asked.object_category, looks, bases, (0, until)) for c in episode.objects
    )
    receptacles = tuple(
        read_target(recording, c.name, asked.goal_receptacle, looks, bases, (taken_at or 0, count))
        for c in episode.goal_receptacles
    )
    return objects, receptacles


def _phases(recording: Recording) -> Iterator[Phase]:
    for state, group in groupby(recording.steps, lambda step: step.decision.state):
        steps = [step.step for step in group]
        yield Phase(state, steps[0], steps[-1])


def _touches(recording: Recording, bases: NDArray[np.float64]) -> Iterator[Touch]:
    for step in recording.steps:
        what = step.events.touches.robot_scene
        if what is not None:
            x, y = bases[step.step]
            yield Touch(step.step, what, step.decision.state, (float(x), float(y)))


def _way(recording: Recording, bases: NDArray[np.float64], taken_at: int | None) -> float | None:
    if not recording.steps:
        return None
    episode, held = recording.episode, recording.steps[-1].held
    sought = episode.objects if taken_at is None else episode.goal_receptacles
    final = recording.objects.at(len(recording.steps))
    poses = {name: pose for name, pose in final.items() if name != held}
    x, y = bases[-1]
    ends = [point for candidate in sought for point in candidate.view_points]
    return width_of_way(recording.home, poses, (float(x), float(y)), ends)


def _moved_alone(recording: Recording) -> str | None:
    """Return a candidate object that was moved far before the robot had touched or grasped anything."""
    firsts = (step.step for step in recording.steps if step.events.hit is not None or step.events.grasped is not None)
    first = next(firsts, len(recording.steps))
    for candidate in recording.episode.objects:
        (_, start), *later = recording.objects.of(candidate.name)
        if any(m <= first and np.linalg.norm(pose[:3, 3] - start[:3, 3]) > MOVED_FAR for m, pose in later):
            return candidate.name
    return None
