"""The fourteen improvements of the UniTeam report (arXiv 2312.08611), as it describes them."""

from dataclasses import replace

from uniteam.mind.agents.config import BASELINE, AgentConfig
from uniteam.mind.agents.improvement import Improvement, ImprovementError, replacing
from uniteam.mind.manipulation.pick.look_around_pick import LookAround
from uniteam.mind.manipulation.pick.verify_pick import feel_the_gripper
from uniteam.mind.manipulation.place.drop_height import ClearSurface
from uniteam.mind.manipulation.place.edge_margin import EDGE_SAMPLES, EdgeMargin
from uniteam.mind.manipulation.place.stepwise_place import CloseInStepwise
from uniteam.mind.manipulation.place.surface_fallback import OntoFlatSurface
from uniteam.mind.navigation.goals.centre_approach import CentreApproach
from uniteam.mind.navigation.goals.exploration import (
    remember_probabilities,
)
from uniteam.mind.navigation.goals.goal_or_frontier import StuckDetector
from uniteam.mind.navigation.goals.receptacle_probability import MostProbableReceptacle
from uniteam.mind.navigation.goals.surround_start_receptacle import SurroundStartReceptacle
from uniteam.mind.navigation.planning.collision_mapping import COLLISION_MAPPING
from uniteam.mind.perception.filters import FloorFilter, ScoreFilter
from uniteam.mind.perception.threshold_file import read_thresholds


def _class_thresholds(config: AgentConfig) -> AgentConfig:
    if any(f not in config.filters for f in BASELINE.filters):
        raise ImprovementError(
            "improvement 'class_thresholds' replaces the baseline's one threshold for all classes, which this "
            "configuration does not have; leave the improvement out"
        )
    ours = ScoreFilter(read_thresholds())
    return replace(config, filters=tuple(ours if f in BASELINE.filters else f for f in config.filters))


def _floor_filter(config: AgentConfig) -> AgentConfig:
    if any(isinstance(f, FloorFilter) for f in config.filters):
        raise ImprovementError(
            "improvement 'floor_filter' adds a FloorFilter, which this configuration has already; leave the "
            "improvement out"
        )
    return replace(config, filters=(*config.filters, FloorFilter()))


REPORT: tuple[Improvement, ...] = (
    Improvement(
        "class_thresholds",
        "a confidence threshold for each kind of class or single class in place of one",
        _class_thresholds,
    ),
    Improvement("floor_filter", "receptacles and objects detected at floor level are dropped", _floor_filter),
    replacing(
        "goal_or_frontier",
        "when progress stalls or the robot oscillates, the frontier is chosen over the goal",
        is_stuck=StuckDetector(),
    ),
    replacing(
        "surround_start_receptacle",
        "each start receptacle is looked at from several sides",
        search__start_receptacle=SurroundStartReceptacle(),
    ),
    replacing(
        "receptacle_probability",
        "the map's most probable reachable goal receptacle is chosen, not the nearest",
        search__goal_receptacle=MostProbableReceptacle(),
    ),
    replacing(
        "early_goal_memory",
        "goal receptacles seen on the way to the object are candidates with their probabilities",
        search__recall=remember_probabilities,
    ),
    replacing(
        "collision_mapping",
        "a collision is written into the obstacle map at the last short-term goal, and planning uses it",
        planner__collisions=COLLISION_MAPPING,
    ),
    replacing(
        "centre_approach",
        "the robot ends near the centre of the goal receptacle's side, facing it",
        search__approach=CentreApproach(),
    ),
    replacing(
        "look_around_pick",
        "when the object is not in view at the pick, the robot turns left and right before it snaps",
        pick__look_around=LookAround(),
    ),
    replacing("verify_pick", "a failed grasp is felt, and other places are tried", pick__is_grasped=feel_the_gripper),
    replacing(
        "stepwise_place",
        "the robot closes in on the receptacle in small steps, measuring again each time",
        place__close_in=CloseInStepwise(),
    ),
    replacing(
        "edge_margin",
        "the placing point keeps away from the receptacle's edges",
        place__choose_points__samples=EDGE_SAMPLES,
        place__choose_points__weigh=EdgeMargin(),
    ),
    replacing(
        "surface_fallback",
        "with the receptacle out of sight, a flat surface in reach is used",
        place__fall_back=OntoFlatSurface(),
    ),
    replacing(
        "drop_height",
        "a large object is released from higher up, so that it clears the receptacle",
        place__release__height_for=ClearSurface(),
    ),
)
"""The fourteen of the UniTeam report (arXiv 2312.08611), as it describes them."""
