"""Which object the gripper takes when it snaps: the rule is a value of the task.

`challenge` is the evaluator's own (habitat-lab's OVMM branch, `_snap_closest_valid_object`): it knows what is asked,
so the gripper cannot take a wrong thing. `honest` knows nothing: the gripper takes what it is pointed at. `arm` is no
snap: the gripper takes what its fingers close around, and opens as wide as a Stretch's.
"""

from collections.abc import Callable, Collection, Iterable, Mapping

from uniteam.errors import UnknownNameError
from uniteam.stretch import FULL_OPENING, GRASP_RANGE
from uniteam.world.simulation.graspable import Graspable, GraspRule
from uniteam.world.simulation.held_object import hold_as_it_lies
from uniteam.world.task.episode import Episode

EpisodeGraspRule = Callable[[Episode], GraspRule]
"""From an episode to the rule that holds while it is played."""


def challenge(episode: Episode) -> GraspRule:
    """Take the nearest candidate object in range, if anything of the asked class is in the picture."""
    return take_candidate(episode.instruction.object_category, {candidate.name for candidate in episode.objects})


def honest(episode: Episode) -> GraspRule:
    """Take the nearest small object in range that the camera points at, whatever it is; the episode does not matter."""
    return GraspRule(take_what_is_pointed_at)


def arm(episode: Episode) -> GraspRule:
    """Take what the closing fingers enclose, whatever it is, and hold it as it lies; the episode does not matter."""
    return GraspRule(take_what_is_enclosed, hold_as_it_lies, FULL_OPENING)


GRASP_RULES: Mapping[str, EpisodeGraspRule] = {"challenge": challenge, "honest": honest, "arm": arm}


def grasp_rule_named(name: str) -> EpisodeGraspRule:
    """Return a grasp rule; raises UnknownNameError."""
    if name not in GRASP_RULES:
        raise UnknownNameError("grasp rule", name, GRASP_RULES)
    return GRASP_RULES[name]


def take_candidate(category: str, candidates: Collection[str]) -> GraspRule:
    """Return the rule that takes the nearest of some instances in range, if any instance of a class is in view."""

    def rule(things: Iterable[Graspable]) -> str | None:
        everything = tuple(things)
        if not any(thing.is_in_view and thing.category == category for thing in everything):
            return None
        return _nearest(thing for thing in everything if thing.name in candidates)

    return GraspRule(rule)


def take_what_is_enclosed(things: Iterable[Graspable]) -> str | None:
    """Return the small object that the closing fingers would have between them."""
    return next((thing.name for thing in things if thing.is_enclosed), None)


def take_what_is_pointed_at(things: Iterable[Graspable]) -> str | None:
    """Return the nearest small object in range with a pixel in the middle of the picture."""
    return _nearest(thing for thing in things if thing.is_in_centre)


def _nearest(things: Iterable[Graspable]) -> str | None:
    in_range = ((thing.distance, thing.name) for thing in things if thing.distance <= GRASP_RANGE)
    return min(in_range, default=(0.0, None))[1]
