"""Paths of the arm: how it gets over a point, whether it touches anything seen, and how it follows them."""

from dataclasses import dataclass, fields, replace
from itertools import pairwise

from uniteam.interface import DiscreteAction, Joints
from uniteam.mind.manipulation.arm_clearance import Load, SweepConfig, is_sweep_free
from uniteam.mind.skills.skill import Skill, discrete, move_joints
from uniteam.mind.skills.view import Points, View
from uniteam.stretch import JOINT_LIMITS

TOP = JOINT_LIMITS[1].lift


@dataclass(frozen=True)
class ArmPath:
    """Joint positions to go through, one after the other, the last being where the gripper lets go."""

    stations: tuple[Joints, ...]

    @property
    def end(self) -> Joints:
        """Where the gripper lets go."""
        return self.stations[-1]


def path_to(now: Joints, end: Joints) -> ArmPath:
    """Return the path that extends the arm at the height of its end, once the wrist has been levelled high up."""
    raised = replace(now, lift=TOP, arm=0.0)
    level = replace(raised, wrist_pitch=end.wrist_pitch)
    return ArmPath((raised, level, replace(end, arm=0.0), end))


def is_path_free(path: ArmPath, surroundings: Points, load: Load, config: SweepConfig) -> bool:
    """Return whether the arm touches nothing seen along a path; to its first station it moves within the base."""
    on_the_way = (joints for start, end in pairwise(path.stations) for joints in _between(start, end))
    return all(is_sweep_free(surroundings, joints, load, config) for joints in (path.end, *on_the_way))


def _between(start: Joints, end: Joints, parts: int = 4) -> tuple[Joints, ...]:
    fractions = (part / parts for part in range(1, parts + 1))
    return tuple(_mixed(start, end, fraction) for fraction in fractions)


def _mixed(start: Joints, end: Joints, fraction: float) -> Joints:
    away = end - start
    return Joints(*(getattr(start, f.name) + fraction * getattr(away, f.name) for f in fields(Joints)))


def follow(view: View, path: ArmPath) -> Skill[View]:
    """Bring the arm along a path."""
    for station in path.stations:
        view = yield from move_joints(view, station, _words(view.observation.joints, station))
    return view


def _words(start: Joints, end: Joints) -> str:
    if abs(end.wrist_pitch - start.wrist_pitch) > 0.01:
        return "I level the wrist, so that the gripper reaches farther and higher."
    if end.arm > start.arm:
        return f"I extend the arm to {end.arm:.2f} m over the receptacle."
    return f"I bring the lift to {end.lift:.2f} m."


def let_go(view: View) -> Skill[View]:
    """Open the gripper."""
    name = view.instruction.object_category.replace("_", " ")
    return (yield discrete(DiscreteAction.DESNAP_OBJECT, f"I let go of the {name}."))
