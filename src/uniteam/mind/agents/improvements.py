"""The named changes that make UniTeam out of the baseline (the UniTeam report, arXiv 2312.08611)."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

from uniteam.errors import InvalidInputError
from uniteam.mind.agents.config import AgentConfig
from uniteam.mind.manipulation.pick.look_around_pick import LookAround
from uniteam.mind.manipulation.pick.pick import feel_the_gripper
from uniteam.mind.manipulation.place.drop_height import DropClear
from uniteam.mind.manipulation.place.edge_margin import SafeFromEdges
from uniteam.mind.manipulation.place.stepwise_place import CloseInStepwise
from uniteam.mind.manipulation.place.surface_fallback import OntoFlatSurface
from uniteam.mind.navigation.goals.centre_approach import CentreApproach
from uniteam.mind.navigation.goals.exploration import (
    goal_receptacle,
    start_receptacle_not_been_close,
)
from uniteam.mind.navigation.goals.goal_or_frontier import StuckDetector
from uniteam.mind.navigation.goals.receptacle_probability import MostProbableReceptacle
from uniteam.mind.navigation.goals.surround_start_receptacle import SurroundStartReceptacle
from uniteam.mind.navigation.planning.collision_mapping import COLLISION_MAPPING
from uniteam.mind.perception.filters import FloorFilter, ScoreFilter, Thresholds
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.mind.skills.step_aside import BlockedOften
from uniteam.registry import Registry
from uniteam.stretch import DEPTH_RANGE


@dataclass(frozen=True)
class Improvement:
    """One change of a configuration, which can be switched on and off by its name.

    Attributes:
        name: by which it is asked for.
        summary: what changes, in one line.
        apply: from a configuration to the improved one.
    """

    name: str
    summary: str
    apply: Callable[[AgentConfig], AgentConfig]


def _checked(name: str, value: object) -> Improvement:
    if isinstance(value, Improvement):
        return value
    raise InvalidInputError(f"improvement '{name}' must be an Improvement, got {type(value).__name__}")


IMPROVEMENTS: Registry[Improvement] = Registry("improvement", "uniteam.improvements", _checked)


def improved(config: AgentConfig, names: Iterable[str]) -> AgentConfig:
    """Return a configuration with some improvements: built-in ones in the order in which they are defined, then others.

    Raises:
        UnknownNameError: an improvement that there is none of, with the nearest valid name.
        InvalidInputError: an improvement that makes something else of a configuration.
    """
    wanted = dict.fromkeys(names)
    chosen = {name: IMPROVEMENTS.get(name) for name in wanted}
    ordered = [improvement.name for improvement in REPORT if improvement.name in chosen]
    for name in (*ordered, *(name for name in chosen if name not in ordered)):
        config = chosen[name].apply(config)
        if not isinstance(config, AgentConfig):
            raise InvalidInputError(
                f"improvement '{name}' must return an AgentConfig, but returned {type(config).__name__}"
            )
    return config


UNITEAM_THRESHOLDS = Thresholds(
    {ClassRole.OBJECT: 0.35, ClassRole.START_RECEPTACLE: 0.45, ClassRole.GOAL_RECEPTACLE: 0.55}, other=0.45
)
"""A missed object ends the episode, so little evidence is enough to go and look; a wrong goal receptacle costs it."""


def _class_thresholds(config: AgentConfig) -> AgentConfig:
    others = tuple(f for f in config.filters if not isinstance(f, ScoreFilter))
    return replace(config, filters=(ScoreFilter(UNITEAM_THRESHOLDS), *others))


def _floor_filter(config: AgentConfig) -> AgentConfig:
    return replace(config, filters=(*config.filters, FloorFilter()))


def _goal_or_frontier(config: AgentConfig) -> AgentConfig:
    return replace(config, is_stuck=StuckDetector(), gives_way=BlockedOften())


def _surround_start_receptacle(config: AgentConfig) -> AgentConfig:
    around = SurroundStartReceptacle()
    choices = tuple(around if c is start_receptacle_not_been_close else c for c in config.find_object)
    return replace(config, find_object=choices)


def _receptacle_probability(config: AgentConfig) -> AgentConfig:
    probable = MostProbableReceptacle()
    choices = tuple(probable if c is goal_receptacle else c for c in config.find_receptacle)
    return replace(config, find_receptacle=choices)


def _early_goal_memory(config: AgentConfig) -> AgentConfig:
    to_object, to_start, _ = config.map.class_depths
    return replace(config, map=replace(config.map, class_depths=(to_object, to_start, DEPTH_RANGE)))


def _centre_approach(config: AgentConfig) -> AgentConfig:
    receptacle, *others = config.find_receptacle
    return replace(config, find_receptacle=(CentreApproach(receptacle), *others))


def _collision_mapping(config: AgentConfig) -> AgentConfig:
    """Keep collisions, and plan with what they teach: a base of 0.3 m asks for six cells, not for three."""
    return replace(config, planner=replace(config.planner, collisions=COLLISION_MAPPING, dilations=(6, 5, 4, 3, 2, 1)))


def _look_around_pick(config: AgentConfig) -> AgentConfig:
    return replace(config, pick=replace(config.pick, bring_into_view=LookAround()))


def _verify_pick(config: AgentConfig) -> AgentConfig:
    return replace(config, pick=replace(config.pick, is_grasped=feel_the_gripper))


def _stepwise_place(config: AgentConfig) -> AgentConfig:
    return replace(config, place=replace(config.place, close_in=CloseInStepwise(), attempts=4))


def _edge_margin(config: AgentConfig) -> AgentConfig:
    return replace(config, place=replace(config.place, choose_points=SafeFromEdges()))


def _surface_fallback(config: AgentConfig) -> AgentConfig:
    return replace(config, place=replace(config.place, fall_back=OntoFlatSurface()))


def _drop_height(config: AgentConfig) -> AgentConfig:
    return replace(config, place=replace(config.place, release=DropClear()))


REPORT = (
    Improvement(
        "class_thresholds",
        "a confidence threshold for each kind of class in place of one",
        _class_thresholds,
    ),
    Improvement(
        "floor_filter",
        "receptacles and objects detected at floor level are dropped",
        _floor_filter,
    ),
    Improvement(
        "goal_or_frontier",
        "when progress stalls, the frontier is chosen over an unreachable goal; blocked often, the robot steps aside",
        _goal_or_frontier,
    ),
    Improvement(
        "surround_start_receptacle",
        "each start receptacle is looked at from several sides",
        _surround_start_receptacle,
    ),
    Improvement(
        "receptacle_probability",
        "the map keeps probabilities; the most probable reachable receptacle is chosen, not the nearest",
        _receptacle_probability,
    ),
    Improvement(
        "early_goal_memory",
        "goal receptacles seen on the way to the object are remembered",
        _early_goal_memory,
    ),
    Improvement(
        "collision_mapping",
        "a collision is written into the map and stays, and paths keep the base's true radius where they can",
        _collision_mapping,
    ),
    Improvement(
        "centre_approach",
        "the robot ends near the centre of the receptacle's side, facing it",
        _centre_approach,
    ),
    Improvement(
        "look_around_pick",
        "when the object is not in view at the pick, the robot turns and tries again",
        _look_around_pick,
    ),
    Improvement(
        "verify_pick",
        "a failed grasp is felt, and other places are tried",
        _verify_pick,
    ),
    Improvement(
        "stepwise_place",
        "the robot closes in on the receptacle in small steps, measuring again each time",
        _stepwise_place,
    ),
    Improvement(
        "edge_margin",
        "the placing point keeps away from the receptacle's edges",
        _edge_margin,
    ),
    Improvement(
        "surface_fallback",
        "with the receptacle out of sight, a flat surface in reach is used",
        _surface_fallback,
    ),
    Improvement(
        "drop_height",
        "with the wrist level, the object is released high enough to clear the receptacle",
        _drop_height,
    ),
)
"""The fourteen improvements of the report, in the order in which they are applied."""

for _improvement in REPORT:
    IMPROVEMENTS.register(_improvement.name, _improvement)
