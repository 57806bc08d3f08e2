"""What an agent is made of: values and strategies of one machine."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from uniteam.mind.agents.improvement import Improvement
from uniteam.mind.manipulation.pick.look_around_pick import LookAround
from uniteam.mind.manipulation.pick.pick import PickConfig, feel_the_gripper, snap_once, trust_the_snap
from uniteam.mind.manipulation.place.baseline_place import DriveInOneGo, extend_blindly
from uniteam.mind.manipulation.place.drop_height import DropClear, FixedDrop
from uniteam.mind.manipulation.place.edge_margin import SafeFromEdges
from uniteam.mind.manipulation.place.place import PlaceConfig
from uniteam.mind.manipulation.place.placing_points import densest_slab
from uniteam.mind.manipulation.place.stepwise_place import CloseInStepwise
from uniteam.mind.manipulation.place.surface_fallback import OntoFlatSurface
from uniteam.mind.mapping.birds_eye_map import MapConfig
from uniteam.mind.navigation.goals.centre_approach import CentreApproach
from uniteam.mind.navigation.goals.exploration import (
    FIND_OBJECT,
    FIND_RECEPTACLE,
    ChooseGoal,
    goal_receptacle,
    start_receptacle_not_been_close,
)
from uniteam.mind.navigation.goals.goal_or_frontier import StuckDetector, Trail, never_stuck
from uniteam.mind.navigation.goals.receptacle_probability import MostProbableReceptacle
from uniteam.mind.navigation.goals.surround_start_receptacle import SurroundStartReceptacle
from uniteam.mind.navigation.planning.collision_mapping import COLLISION_MAPPING
from uniteam.mind.navigation.planning.planner import PlannerConfig
from uniteam.mind.perception.filters import Filter, FloorFilter, ScoreFilter, Thresholds
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.mind.skills.step_aside import BlockedOften, never_step_aside


@dataclass(frozen=True)
class AgentConfig:
    """The values and strategies of an agent; `BASELINE` and `UNITEAM` are two of them.

    Attributes:
        filters: which detections to believe, one after the other.
        map: how frames become the map.
        planner: how to drive.
        find_object: what to head for while there is no object in the gripper, in order of preference.
        find_receptacle: what to head for with the object in the gripper, in order of preference.
        pick: how to pick.
        place: how to place.
        gives_way: after how many blocked motions in a row to step aside.
        is_stuck: when to leave what the robot heads for, for a frontier.
        first_turns: turns of 30 degrees to look around with at first.
    """

    filters: tuple[Filter, ...]
    map: MapConfig
    planner: PlannerConfig
    find_object: tuple[ChooseGoal, ...]
    find_receptacle: tuple[ChooseGoal, ...]
    pick: PickConfig
    place: PlaceConfig
    gives_way: Callable[[int], bool] = never_step_aside
    is_stuck: Callable[[Trail], bool] = never_stuck
    first_turns: int = 12

    def with_improvements(self, improvements: frozenset[Improvement] | set[Improvement]) -> "AgentConfig":
        """Return this configuration with some of UniTeam's improvements, in the order in which they are defined."""
        config = self
        for improvement in Improvement:
            if improvement in improvements:
                config = _IMPROVERS[improvement](config)
        return config


BASELINE = AgentConfig(
    filters=(ScoreFilter(Thresholds.single(0.45)),),
    map=MapConfig(),
    planner=PlannerConfig(),
    find_object=FIND_OBJECT,
    find_receptacle=FIND_RECEPTACLE,
    pick=PickConfig(bring_into_view=snap_once, is_grasped=trust_the_snap),
    place=PlaceConfig(
        choose_points=densest_slab, close_in=DriveInOneGo(), release=FixedDrop(), fall_back=extend_blindly
    ),
)
"""HomeRobot's heuristic agent (arXiv 2306.11565)."""

UNITEAM_THRESHOLDS = Thresholds(
    {ClassRole.OBJECT: 0.35, ClassRole.START_RECEPTACLE: 0.45, ClassRole.GOAL_RECEPTACLE: 0.55}, other=0.45
)
"""A missed object ends the episode, so little evidence is enough to go and look; a wrong goal receptacle costs it."""

FARTHEST_SIGHT = 10.0
"""How far the camera measures depth (m)."""


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
    return replace(config, map=replace(config.map, class_depths=(to_object, to_start, FARTHEST_SIGHT)))


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


_IMPROVERS: dict[Improvement, Callable[[AgentConfig], AgentConfig]] = {
    Improvement.CLASS_THRESHOLDS: _class_thresholds,
    Improvement.FLOOR_FILTER: _floor_filter,
    Improvement.GOAL_OR_FRONTIER: _goal_or_frontier,
    Improvement.SURROUND_START_RECEPTACLE: _surround_start_receptacle,
    Improvement.RECEPTACLE_PROBABILITY: _receptacle_probability,
    Improvement.EARLY_GOAL_MEMORY: _early_goal_memory,
    Improvement.CENTRE_APPROACH: _centre_approach,
    Improvement.COLLISION_MAPPING: _collision_mapping,
    Improvement.LOOK_AROUND_PICK: _look_around_pick,
    Improvement.VERIFY_PICK: _verify_pick,
    Improvement.STEPWISE_PLACE: _stepwise_place,
    Improvement.EDGE_MARGIN: _edge_margin,
    Improvement.SURFACE_FALLBACK: _surface_fallback,
    Improvement.DROP_HEIGHT: _drop_height,
}
