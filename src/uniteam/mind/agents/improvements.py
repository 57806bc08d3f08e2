"""The named changes of the baseline, each of which can be switched on and off: the UniTeam report's, and those beyond.

An improvement puts something in the place of what the baseline does there. Where a configuration does something else
there already, the improvement does not fit, and says so. All that are built in change different places, so any set of
them gives one configuration, whatever the order.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any

from uniteam.errors import InvalidInputError, UniteamError
from uniteam.mind.agents.config import BASELINE, AgentConfig
from uniteam.mind.agents.last_round import LastRound
from uniteam.mind.manipulation.arm_reach import LEVEL_WRIST
from uniteam.mind.manipulation.leave_manipulation import fold_and_turn_back
from uniteam.mind.manipulation.load_footprint import LoadFootprint
from uniteam.mind.manipulation.pick.look_around_pick import LookAround
from uniteam.mind.manipulation.pick.reach_out_pick import ReachOut
from uniteam.mind.manipulation.pick.tilt_head import TiltHead
from uniteam.mind.manipulation.pick.verify_pick import feel_the_gripper
from uniteam.mind.manipulation.place.checked_arm_path import CheckedArmPath
from uniteam.mind.manipulation.place.drop_height import LOW_DROP, ClearSurface
from uniteam.mind.manipulation.place.edge_margin import EDGE_SAMPLES, EdgeMargin
from uniteam.mind.manipulation.place.flat_ground import FlatGround
from uniteam.mind.manipulation.place.headroom import points_with_headroom
from uniteam.mind.manipulation.place.motion import ExactMotion
from uniteam.mind.manipulation.place.occupied_surface import RoomAmongOthers
from uniteam.mind.manipulation.place.receptacle_mask import whole_mask
from uniteam.mind.manipulation.place.stepwise_place import CloseInStepwise
from uniteam.mind.manipulation.place.surface_fallback import OntoFlatSurface
from uniteam.mind.manipulation.place.verify_place import LookWhereItLies, WatchRest
from uniteam.mind.manipulation.place.withdraw import stay
from uniteam.mind.mapping.clearing import ClearSeenThrough
from uniteam.mind.mapping.fine_obstacles import FineGrain
from uniteam.mind.mapping.projection import exact_pixels
from uniteam.mind.mapping.resolved_look import ResolvedLook
from uniteam.mind.mapping.visited import mark_line
from uniteam.mind.navigation.first_look import FULL_CIRCLE
from uniteam.mind.navigation.goals.centre_approach import CentreApproach
from uniteam.mind.navigation.goals.exploration import (
    any_frontier,
    any_goal_with_a_path,
    object_beside_start_receptacle,
    remember_probabilities,
    when_blocked_nearby,
    while_it_leads_on,
)
from uniteam.mind.navigation.goals.failed_goals import FailedGoalMemory
from uniteam.mind.navigation.goals.goal_or_frontier import StuckDetector
from uniteam.mind.navigation.goals.receptacle_probability import MostProbableReceptacle
from uniteam.mind.navigation.goals.surround_start_receptacle import SurroundStartReceptacle
from uniteam.mind.navigation.planning.clearance_cost import ClearancePrice
from uniteam.mind.navigation.planning.collision_mapping import COLLISION_MAPPING, before_the_rim, keep_collisions
from uniteam.mind.navigation.planning.long_strides import LongStrides
from uniteam.mind.navigation.planning.narrow_motion import ExactWhereNarrow, SpareNarrowWays
from uniteam.mind.navigation.planning.planner import plan_string_pulled
from uniteam.mind.navigation.planning.planner_config import turn_in_steps
from uniteam.mind.navigation.planning.traversible import OWN_CELLS
from uniteam.mind.navigation.planning.true_radius import true_radius
from uniteam.mind.perception.filters import FloorFilter, ScoreFilter
from uniteam.mind.perception.threshold_file import read_thresholds
from uniteam.mind.skills.step_aside import AfterBlockedMotions
from uniteam.registry import Registry
from uniteam.stretch import DEPTH_RANGE


class ImprovementError(UniteamError):
    """An improvement that does not fit the configuration it is applied to."""


@dataclass(frozen=True)
class Improvement:
    """One change of a configuration.

    Attributes:
        name: by which it is switched on and off.
        summary: what changes, in half a sentence.
        apply: returns the changed configuration; raises ImprovementError where it does not fit.
    """

    name: str
    summary: str
    apply: Callable[[AgentConfig], AgentConfig]


def improved(config: AgentConfig, improvements: Iterable[str | Improvement]) -> AgentConfig:
    """Return a configuration with improvements, given as values, names or references, each applied once.

    The built-in ones are applied first, in their order; then the others in the order of their names.

    Raises:
        UnknownNameError: there is none of a name; the message offers the nearest.
        ImprovementError: one that does not fit, fails, or makes something else than a configuration.
    """
    given = (i if isinstance(i, Improvement) else IMPROVEMENTS.get(i) for i in improvements)
    chosen = {improvement.name: improvement for improvement in given}
    for improvement in sorted(chosen.values(), key=_place_in_order):
        config = _applied(improvement, config)
    return config


def _applied(improvement: Improvement, config: AgentConfig) -> AgentConfig:
    try:
        changed = improvement.apply(config)
    except UniteamError:
        raise
    except Exception as error:  # whatever an improvement of the user's raises
        raise ImprovementError(f"improvement '{improvement.name}' failed ({type(error).__name__}: {error})") from error
    if not isinstance(changed, AgentConfig):
        raise ImprovementError(
            f"improvement '{improvement.name}' must return an AgentConfig, but returned {type(changed).__name__}"
        )
    return changed


def _place_in_order(improvement: Improvement) -> tuple[int, str]:
    built_in = [other.name for other in (*REPORT, *BEYOND)]
    return built_in.index(improvement.name) if improvement.name in built_in else len(built_in), improvement.name


@dataclass(frozen=True)
class Replacement:
    """Puts values in the place of the baseline's.

    Attributes:
        name: of the improvement, for the error's sentence.
        slots: each a path of fields through the configuration ("search.approach"), and what is put there.
    """

    name: str
    slots: tuple[tuple[str, object], ...]

    def __call__(self, config: AgentConfig) -> AgentConfig:
        """Return the changed configuration; raises ImprovementError where a slot holds something else."""
        for path, ours in self.slots:
            self._check(path, config)
            config = _filled(config, path.split("."), ours)
        return config

    def _check(self, path: str, config: AgentConfig) -> None:
        held, theirs = _held(config, path), _held(BASELINE, path)
        if held != theirs:
            raise ImprovementError(
                f"improvement '{self.name}' replaces the baseline's '{path}' ({_words(theirs)}), but this "
                f"configuration has {_words(held)} there; leave the improvement out"
            )


def _held(config: AgentConfig, path: str) -> object:
    part: object = config
    for slot in path.split("."):
        part = getattr(part, slot, None)
    return part


def _filled(part: Any, path: list[str], ours: object) -> Any:
    slot, *rest = path
    return replace(part, **{slot: _filled(getattr(part, slot), rest, ours) if rest else ours})


def _words(value: object) -> str:
    return str(getattr(value, "__qualname__", value))


def _replacing(name: str, summary: str, **slots: object) -> Improvement:
    """Return the improvement that fills slots; in their paths "__" stands for a dot."""
    paths = ((path.replace("__", "."), ours) for path, ours in slots.items())
    return Improvement(name, summary, Replacement(name, tuple(paths)))


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


def _true_radius(config: AgentConfig) -> AgentConfig:
    dilations = true_radius(config.map.cell_size)
    return Replacement("true_radius", (("planner.dilations", dilations),))(config)


REPORT: tuple[Improvement, ...] = (
    Improvement(
        "class_thresholds",
        "a confidence threshold for each kind of class or single class in place of one",
        _class_thresholds,
    ),
    Improvement("floor_filter", "receptacles and objects detected at floor level are dropped", _floor_filter),
    _replacing(
        "goal_or_frontier",
        "when progress stalls or the robot oscillates, the frontier is chosen over the goal",
        is_stuck=StuckDetector(),
    ),
    _replacing(
        "surround_start_receptacle",
        "each start receptacle is looked at from several sides",
        search__start_receptacle=SurroundStartReceptacle(),
    ),
    _replacing(
        "receptacle_probability",
        "the map's most probable reachable goal receptacle is chosen, not the nearest",
        search__goal_receptacle=MostProbableReceptacle(),
    ),
    _replacing(
        "early_goal_memory",
        "goal receptacles seen on the way to the object are candidates with their probabilities",
        search__recall=remember_probabilities,
    ),
    _replacing(
        "collision_mapping",
        "a collision is written into the obstacle map at the last short-term goal, and planning uses it",
        planner__collisions=COLLISION_MAPPING,
    ),
    _replacing(
        "centre_approach",
        "the robot ends near the centre of the goal receptacle's side, facing it",
        search__approach=CentreApproach(),
    ),
    _replacing(
        "look_around_pick",
        "when the object is not in view at the pick, the robot turns left and right before it snaps",
        pick__look_around=LookAround(),
    ),
    _replacing("verify_pick", "a failed grasp is felt, and other places are tried", pick__is_grasped=feel_the_gripper),
    _replacing(
        "stepwise_place",
        "the robot closes in on the receptacle in small steps, measuring again each time",
        place__close_in=CloseInStepwise(),
    ),
    _replacing(
        "edge_margin",
        "the placing point keeps away from the receptacle's edges",
        place__choose_points__samples=EDGE_SAMPLES,
        place__choose_points__weigh=EdgeMargin(),
    ),
    _replacing(
        "surface_fallback",
        "with the receptacle out of sight, a flat surface in reach is used",
        place__fall_back=OntoFlatSurface(),
    ),
    _replacing(
        "drop_height",
        "a large object is released from higher up, so that it clears the receptacle",
        place__release__height_for=ClearSurface(),
    ),
)
"""The fourteen of the UniTeam report (arXiv 2312.08611), as it describes them."""

BEYOND: tuple[Improvement, ...] = (
    _replacing(
        "step_aside", "blocked again and again, the robot steps aside at random", steps_aside=AfterBlockedMotions()
    ),
    Improvement("true_radius", "paths keep the base's true radius from obstacles where they can", _true_radius),
    _replacing(
        "tilt_head",
        "when the object is not in view at the pick, the head looks up and down for it",
        pick__tilt_head=TiltHead(),
    ),
    _replacing(
        "reach_out_pick",
        "an object in view beyond reach is driven to, and the arm lifted and extended to it",
        pick__reach_out=ReachOut(),
    ),
    _replacing(
        "headroom",
        "placing points have room above them, so walls, fronts and flanks are none",
        place__choose_points__candidates=points_with_headroom,
    ),
    _replacing(
        "flat_ground",
        "placing points with level ground around them are preferred",
        place__choose_points__bonus=FlatGround(),
    ),
    _replacing(
        "checked_arm_path",
        "the arm takes only paths on which it touches nothing seen, from higher up where it must",
        place__find_path=CheckedArmPath(),
    ),
    _replacing(
        "more_attempts",
        "where nothing can be placed, the robot tries up to four places before it lets go",
        place__attempts=4,
    ),
    _replacing(
        "level_wrist",
        "the object is released with the wrist level, from which the gripper gets farther and higher",
        place__release__wrist_pitch=LEVEL_WRIST,
    ),
    _replacing(
        "far_sight",
        "goal receptacles are mapped from as far as depth is measured",
        map__class_depths=(*BASELINE.map.class_depths[:2], DEPTH_RANGE),
    ),
    _replacing(
        "wide_collisions",
        "with collision_mapping, a collision is written before the base's rim, and wider when blocked again",
        planner__felt_at=before_the_rim,
    ),
    _replacing(
        "full_circle", "the first look goes all around, whatever is seen", first_turns=12, first_look=FULL_CIRCLE
    ),
    _replacing(
        "string_pulled_path",
        "paths are pulled straight, and smaller dilations tried only in the step that has no other path",
        make_planner=plan_string_pulled,
    ),
    _replacing(
        "near_enough",
        "a goal is reached 0.1 m before, and up to 0.75 m from it where nothing nearer is free",
        planner__tolerance=0.10,
        planner__patience=0.25,
    ),
    _replacing("own_disc", "all that lies under the base is free, since it stands there", planner__own_cells=OWN_CELLS),
    _replacing("straight_face", "the goal is faced to 15 degrees, not to 20", planner__face=turn_in_steps),
    _replacing("clean_frontiers", "frontiers are where nothing seen stands in the way", search__frontier=any_frontier),
    _replacing(
        "other_goals",
        "where there is no path to a goal, others are tried, and the robot gives up rather than act in vain",
        search__pursue=any_goal_with_a_path,
        search__goes_on=while_it_leads_on,
    ),
    _replacing(
        "blocked_arrival",
        "blocked again and again within 0.6 m of the goal, the robot has arrived",
        search__has_arrived=when_blocked_nearby,
    ),
    _replacing(
        "cell_play",
        "an object one cell beside its start receptacle is taken to lie on it",
        search__object=object_beside_start_receptacle,
    ),
    _replacing(
        "turn_back",
        "the base turns back once the arm is folded",
        pick__leave=fold_and_turn_back,
        place__leave=fold_and_turn_back,
    ),
    _replacing(
        "exact_labels",
        "each pixel marks the map by its own depth and label, where HomeRobot's blocks share one depth",
        map__project=exact_pixels,
    ),
    _replacing(
        "driven_line", "the line that the robot drove stays free, not only where it stood", map__mark_visited=mark_line
    ),
    _replacing(
        "exact_motion",
        "placing, the base turns and drives by what is asked for, and the robot knows where it has got to",
        place__motion=ExactMotion(),
    ),
    _replacing("whole_mask", "the goal receptacle is seen to the rim of its mask", place__receptacle=whole_mask),
    _replacing("still_arm", "the arm stays where it let go", place__withdraw=stay),
    _replacing(
        "occupied_surface",
        "placing points leave room between what is held and the other things on the surface",
        place__choose_points__missing_room=RoomAmongOthers(),
    ),
    _replacing(
        "verify_place",
        "after the release the robot looks where the object lies, and picks it up again where that is wrong",
        place__wait=WatchRest(),
        place__verify=LookWhereItLies(),
    ),
    _replacing(
        "resolved_look",
        "a receptacle counts as looked at where pixels showed it near enough, and nothing hid it",
        map__looks=ResolvedLook(),
    ),
    _replacing(
        "clearing",
        "what the map holds is taken back where the floor is seen again and again and nothing above it",
        map__clear=ClearSeenThrough(),
    ),
    _replacing(
        "clearance_cost",
        "a path keeps away from obstacles where that is no long way round",
        planner__price=ClearancePrice(),
    ),
    _replacing(
        "narrow_motion",
        "turns from 5 degrees and drives from 0.1 m where 30 degrees and 0.25 m do not fit",
        planner__move=ExactWhereNarrow(),
        planner__spares=SpareNarrowWays(),
        map__fine_obstacles=FineGrain(),
    ),
    _replacing(
        "long_strides",
        "exact turns, and drives of up to a metre where the way ahead is straight and clear",
        planner__stride=LongStrides(),
    ),
    _replacing(
        "failed_goal_memory",
        "a place that could not be reached is avoided, the longer the more often it failed",
        failed_goals=FailedGoalMemory(),
    ),
    _replacing(
        "load_footprint",
        "the load is part of the footprint on which the robot drives and turns, where there is a way so wide",
        footprint=LoadFootprint(),
    ),
    _replacing(
        "last_round",
        "steps that are left are used: what failed is tried again, and what was looked at is looked at again",
        relax=LastRound(),
        planner__no_path=keep_collisions,
    ),
    _replacing("low_drop", "a small object is released close above the surface", place__release__least_height=LOW_DROP),
)
"""What uniteam does beyond the report."""


def _checked(name: str, value: object) -> Improvement:
    if not isinstance(value, Improvement):
        raise InvalidInputError(
            f"improvement '{name}' must be an uniteam.mind.agents.improvements.Improvement(name, summary, apply), "
            f"got {type(value).__name__}"
        )
    return value


IMPROVEMENTS: Registry[Improvement] = Registry("improvement", "uniteam.improvements", _checked)
for _improvement in (*REPORT, *BEYOND):
    IMPROVEMENTS.register(_improvement.name, _improvement)
