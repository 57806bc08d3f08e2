"""The last time that a candidate object was let go of, and what became of it."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from uniteam.evaluation.causes.reading.belief import Look
from uniteam.evaluation.causes.reading.falls import Bounds, falls_through
from uniteam.evaluation.causes.reading.places import box_of, distances_to, is_wall_between, to_rectangle
from uniteam.evaluation.causes.story import Release
from uniteam.evaluation.recording.recording import Recording
from uniteam.geometry import Point2
from uniteam.interface import Joints
from uniteam.stretch import JOINT_LIMITS, gripper_to_base
from uniteam.world.homes.home import Home, Instance

BEFORE = 5
"""Steps before the release in which a touch counts as one of it."""
STAYING = 0.02
"""What moves less (m) is still where it was."""
SUNKEN = 0.05
"""What is not more below a surface than this (m) may lie on it: surfaces are not flat to the millimetre."""
BESIDE_IT = 1.0
"""A wall before a receptacle that is farther away (m) is not in the way of what was let go of."""


def release_step(recording: Recording) -> int | None:
    """Return the step at which a candidate object was let go of last; None for never."""
    names = {candidate.name for candidate in recording.episode.objects}
    return next((step.step for step in reversed(recording.steps) if step.events.released in names), None)


def moment_of_belief(recording: Recording, step: int | None) -> int | None:
    """Return the last moment before a release at which the agent believed to see the goal receptacle."""
    category = recording.episode.instruction.goal_receptacle
    before = recording.steps[: 0 if step is None else step + 1]
    return next((s.step for s in reversed(before) if any(d.name == category for d in s.detections or ())), None)


def read_release(recording: Recording, looks: Mapping[int, Look]) -> Release | None:
    """Return the last release of a candidate object; `looks` are pictures by moment."""
    step = release_step(recording)
    name = None if step is None else recording.steps[step].events.released
    if step is None or name is None:
        return None
    home, episode = recording.home, recording.episode
    low, high = box_of(home, name, recording.objects.at(step)[name])
    middle = (low + high)[:2] / 2
    place = (float(middle[0]), float(middle[1]))
    goals = [home.by_name[candidate.name] for candidate in episode.goal_receptacles]
    belief = moment_of_belief(recording, step)
    look = None if belief is None else looks.get(belief)
    believed = None if look is None else look.taken_for(episode.instruction.goal_receptacle, _names(recording))
    goal = _goal_of(home, goals, place, believed, float(low[2]))
    rests_on = recording.steps[-1].resting_on
    x, y, z = recording.objects.at(len(recording.steps))[name][:3, 3]
    return Release(
        step=step,
        name=name,
        place=place,
        bottom=float(low[2]),
        side=float((high - low)[:2].max()),
        arm=recording.true_joints(step).arm,
        highest=float(low[2]) + _rise(recording.true_joints(step)),
        touched=_touched(recording, step),
        goal=goal.name,
        to_goal=_distance(home, goal, place),
        goal_lowest=_lowest_surface(home, goal),
        goal_highest=max(_surfaces(home, goal)),
        goal_side=max(home.model_of(goal).size[:2]),
        above=_right_below(recording, step, name, (float(low[0]), float(high[0])), (float(low[1]), float(high[1]))),
        is_wall_between=_is_behind_wall(recording, step, place, goal, float(low[2])),
        believed=believed,
        rests_on=rests_on,
        rests_at=(float(x), float(y), float(z)),
        is_over_goal=any(_is_over(recording, name, each) for each in goals),
        stay_steps=_stay_steps(recording, name),
        rest_steps=_rest_steps(recording, {each.name for each in goals}),
        has_fallen_through=falls_through(home, goal, _lowest_surface(home, goal), _fall(recording, step, name)),
    )


def _names(recording: Recording) -> tuple[str, ...]:
    return recording.header.instances


def _lowest_surface(home: Home, goal: Instance) -> float:
    return min(_surfaces(home, goal))


def _surfaces(home: Home, goal: Instance) -> list[float]:
    """Return the heights (m) of a receptacle's surfaces, or that of its bounding box where it has none."""
    model = home.model_of(goal)
    return [goal.position[2] + height for height in [s.height for s in model.surfaces] or [model.size[2]]]


def _fall(recording: Recording, step: int, name: str) -> Iterator[Bounds]:
    """Yield the bounds of an object (m, world) from a moment on."""
    for moment in range(step, len(recording.steps) + 1):
        yield box_of(recording.home, name, recording.objects.at(moment)[name])


def _rise(joints: Joints) -> float:
    """Return how much (m) lift and wrist could raise what the gripper holds, which hangs from the grasp centre."""
    highest = replace(joints, lift=JOINT_LIMITS[1].lift, wrist_pitch=max(joints.wrist_pitch, 0.0))
    return float(gripper_to_base(highest)[2, 3] - gripper_to_base(joints)[2, 3])


def _right_below(recording: Recording, step: int, name: str, xs: Point2, ys: Point2) -> str | None:
    """Return the highest movable thing below the middle of a rectangle that does not lie on the floor."""
    x, y = sum(xs) / 2, sum(ys) / 2
    tops = {}
    for other, pose in recording.objects.at(step).items():
        low, high = box_of(recording.home, other, pose)
        if other != name and low[0] <= x <= high[0] and low[1] <= y <= high[1] and low[2] > 0.05:
            tops[other] = float(high[2])
    return max(tops, key=lambda other: tops[other], default=None)


def _goal_of(home: Home, goals: Sequence[Instance], place: Point2, believed: str | None, height: float) -> Instance:
    """Return the receptacle that an object was meant for: the one in view before, or the nearest behind no wall."""
    meant = next((goal for goal in goals if goal.name == believed), None)
    if meant is not None:
        return meant
    return min(goals, key=lambda goal: (_is_walled(home, goal, place, height), _distance(home, goal, place)))


def _distance(home: Home, goal: Instance, place: Point2) -> float:
    return float(distances_to(home, goal, np.array([place]))[0])


def _is_walled(home: Home, goal: Instance, place: Point2, height: float) -> bool:
    x, y = to_rectangle(home, goal, np.array([place]))[0]
    return is_wall_between(home, place, (float(x), float(y)), height)


def _is_behind_wall(recording: Recording, step: int, place: Point2, goal: Instance, height: float) -> bool:
    """Return whether a wall is between base and object, or between the object and a receptacle near it."""
    home, base = recording.home, recording.base_to_world(step)
    is_near = _distance(home, goal, place) <= BESIDE_IT
    return is_wall_between(home, (base.x, base.y), place, height) or (is_near and _is_walled(home, goal, place, height))


def _touched(recording: Recording, step: int) -> str | None:
    """Return what arm and gripper touched last in the steps up to one, or what the object did; None for nothing."""
    touches = [each.events.touches for each in recording.steps[max(0, step - BEFORE) : step + 1]]
    whats = [*(touch.obj_scene for touch in touches), *(touch.robot_scene for touch in touches)]
    return next((what for what in reversed(whats) if what is not None), None)


def _is_over(recording: Recording, name: str, goal: Instance) -> bool:
    """Return whether an object is above a receptacle at the end."""
    low, high = box_of(recording.home, name, recording.objects.at(len(recording.steps))[name])
    middle = (low + high)[None, :2] / 2
    is_inside = float(distances_to(recording.home, goal, middle)[0]) == 0.0
    return is_inside and float(low[2]) >= _lowest_surface(recording.home, goal) - SUNKEN


def _stay_steps(recording: Recording, name: str) -> int:
    """Return for how many steps to the end an object was where it is in the end."""
    track = recording.objects.of(name)
    final = track[-1][1][:3, 3]
    moved = [at for at, pose in track if np.linalg.norm(pose[:3, 3] - final) > STAYING]
    later = [at for at, _ in track if not moved or at > moved[-1]]
    return len(recording.steps) - later[0]


def _rest_steps(recording: Recording, goals: Iterable[str]) -> int:
    """Return for how many steps to the end what was let go of lay still on one of the goals."""
    wanted, count = set(goals), 0
    for step in reversed(recording.steps):
        if not wanted & set(step.resting_on or ()):
            break
        count += 1
    return count
