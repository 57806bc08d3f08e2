"""What an agent is made of: values and strategies of one machine."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from uniteam.mind.agents.improvement import Improvement
from uniteam.mind.manipulation.edges import SafeFromEdges
from uniteam.mind.manipulation.look_around import LookAround
from uniteam.mind.manipulation.one_go import DriveInOneGo, extend_blindly
from uniteam.mind.manipulation.pick import PickConfig, feel_the_gripper, snap_once, trust_the_snap
from uniteam.mind.manipulation.place import PlaceConfig
from uniteam.mind.manipulation.release import DropClear, FixedDrop
from uniteam.mind.manipulation.stepwise import CloseInStepwise
from uniteam.mind.manipulation.surface import densest_slab
from uniteam.mind.manipulation.surface_fallback import OntoFlatSurface
from uniteam.mind.mapping.birds_eye_map import MapConfig
from uniteam.mind.navigation.collision_memory import COLLISION_MAPPING
from uniteam.mind.navigation.exploration import FIND_OBJECT, FIND_RECEPTACLE, ChooseGoal
from uniteam.mind.navigation.planner import PlannerConfig
from uniteam.mind.perception.filters import Filter, FloorFilter, ScoreFilter, Thresholds
from uniteam.mind.perception.vocabulary import ClassRole


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
        first_turns: turns of 30 degrees to look around with at first.
    """

    filters: tuple[Filter, ...]
    map: MapConfig
    planner: PlannerConfig
    find_object: tuple[ChooseGoal, ...]
    find_receptacle: tuple[ChooseGoal, ...]
    pick: PickConfig
    place: PlaceConfig
    first_turns: int = 12

    def with_improvements(self, improvements: frozenset[Improvement] | set[Improvement]) -> "AgentConfig":
        """Return this configuration with some of UniTeam's improvements, in the order in which they are defined."""
        config = self
        for improvement in Improvement:
            if improvement in improvements and improvement in _IMPROVERS:
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


def _class_thresholds(config: AgentConfig) -> AgentConfig:
    others = tuple(f for f in config.filters if not isinstance(f, ScoreFilter))
    return replace(config, filters=(ScoreFilter(UNITEAM_THRESHOLDS), *others))


def _floor_filter(config: AgentConfig) -> AgentConfig:
    return replace(config, filters=(*config.filters, FloorFilter()))


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
    Improvement.COLLISION_MAPPING: _collision_mapping,
    Improvement.LOOK_AROUND_PICK: _look_around_pick,
    Improvement.VERIFY_PICK: _verify_pick,
    Improvement.STEPWISE_PLACE: _stepwise_place,
    Improvement.EDGE_MARGIN: _edge_margin,
    Improvement.SURFACE_FALLBACK: _surface_fallback,
    Improvement.DROP_HEIGHT: _drop_height,
}
