"""Whether an episode makes sense in its home: what is asked, what counts as done, and from where it is seen."""

import math
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import fields
from itertools import product

import numpy as np

from uniteam.errors import UnknownNameError
from uniteam.geometry import BasePose
from uniteam.interface import Joints
from uniteam.stretch import JOINT_LIMITS
from uniteam.world.homes.home import Home
from uniteam.world.task.episode import Candidate, Certificate, Episode

FARTHEST_VIEW = 10.0
"""No view point is farther than this (m) from the middle of what is seen, be it ever so large."""
MOST_SEED = 2**53

_SLACK = 1e-6


def episode_problems(episode: Episode, home: Home) -> Iterator[str]:
    """Yield what is wrong with an episode, a clause each that names the field."""
    if episode.home != home.name:
        yield f"home: it is played in '{episode.home}', not in '{home.name}'"
    yield from _start_problems(episode.start, home)
    if not isinstance(episode.seed, int) or not 0 <= episode.seed <= MOST_SEED:
        yield f"seed: it must be a whole number from 0 to {MOST_SEED}"
    instruction = episode.instruction
    if instruction.start_receptacle == instruction.goal_receptacle:
        yield f"instruction: start and goal are both '{instruction.goal_receptacle}'; nothing would have to be moved"
    yield from _category_problems(episode, home)
    names = tuple(candidate.name for candidate in episode.objects)
    goals = tuple(candidate.name for candidate in episode.goal_receptacles)
    yield from _named("objects", names, instruction.object_category, home)
    yield from _named("start_receptacles", episode.start_receptacles, instruction.start_receptacle, home)
    yield from _named("goal_receptacles", goals, instruction.goal_receptacle, home)
    for candidate in (*episode.objects, *episode.goal_receptacles):
        yield from _view_problems(candidate, home)
    if episode.certificate is not None:
        yield from _certificate_problems(episode.certificate, names, goals)


def _start_problems(start: BasePose, home: Home) -> Iterator[str]:
    if not _is_pose(start):
        yield "start: x, y and heading must be finite numbers"
    elif not any(room.contains(start.x, start.y) for room in home.stage.rooms):
        yield f"start: ({start.x:g}, {start.y:g}) is outside every room"


def _category_problems(episode: Episode, home: Home) -> Iterator[str]:
    """Yield the classes of the instruction that the home holds nothing of."""
    furniture = {i.category for i in home.instances if home.model_of(i).role == "receptacle"}
    for field, kind, held in (
        ("object_category", "object category", {i.category for i in home.instances if i.movable}),
        ("start_receptacle", "receptacle category", furniture),
        ("goal_receptacle", "receptacle category", furniture),
    ):
        category = getattr(episode.instruction, field)
        if category not in held:
            yield f"instruction.{field}: {UnknownNameError(kind, str(category), held)}"


def _named(field: str, names: tuple[str, ...], category: str, home: Home) -> Iterator[str]:
    """Yield what is wrong with the names of instances that should be of a category: objects move, the others do not."""
    if not names:
        yield f"{field}: there is none"
    yield from (f"{field}: '{name}' is named twice" for name in _twice(names))
    for name in names:
        if name not in home.by_name:
            yield f"{field}: '{name}' is nothing that its home holds"
            continue
        instance = home.by_name[name]
        if instance.category != category:
            yield f"{field}: '{name}' is of class '{instance.category}', not '{category}'"
        elif instance.movable != (field == "objects"):
            yield f"{field}: '{name}' {'moves' if instance.movable else 'cannot be moved'}"


def _view_problems(candidate: Candidate, home: Home) -> Iterator[str]:
    if not candidate.view_points:
        yield f"view_points: '{candidate.name}' has none, so that it could never be found"
    elif candidate.name in home.by_name:
        points = np.array(candidate.view_points, np.float64)
        x, y, _ = home.by_name[candidate.name].position
        if not (np.hypot(points[:, 0] - x, points[:, 1] - y) <= FARTHEST_VIEW).all():
            yield f"view_points: one of '{candidate.name}' is farther than {FARTHEST_VIEW:.0f} m from it"


def _certificate_problems(certificate: Certificate, objects: Iterable[str], goals: Iterable[str]) -> Iterator[str]:
    if certificate.object not in objects:
        yield f"certificate.object: '{certificate.object}' is none of its objects"
    if certificate.receptacle not in goals:
        yield f"certificate.receptacle: '{certificate.receptacle}' is none of its goal receptacles"
    for field in ("grasp", "release"):
        if not _is_pose(getattr(certificate, field)):
            yield f"certificate.{field}: x, y and heading must be finite numbers"
    low, high = JOINT_LIMITS
    for posture, joint in product(("grasp_joints", "release_joints"), (field.name for field in fields(Joints))):
        position = getattr(getattr(certificate, posture), joint)
        if not getattr(low, joint) - _SLACK <= position <= getattr(high, joint) + _SLACK:
            yield f"certificate.{posture}: {joint} is beyond its range"


def _is_pose(pose: BasePose) -> bool:
    return all(isinstance(v, float | int) and math.isfinite(v) for v in (pose.x, pose.y, pose.heading))


def _twice(names: Iterable[str]) -> Iterator[str]:
    return (name for name, count in Counter(names).items() if count > 1)
