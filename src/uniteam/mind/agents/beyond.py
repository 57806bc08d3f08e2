"""What uniteam does beyond the report: the named improvements of `uniteam-plus`."""

from uniteam.mind.agents.config import BASELINE, AgentConfig
from uniteam.mind.agents.doubt import BelowScore
from uniteam.mind.agents.improvement import Improvement, Replacement, replacing
from uniteam.mind.agents.last_round import CLOSE, CLOSE_LOOK, LastRound
from uniteam.mind.manipulation.arm_reach import LEVEL_WRIST
from uniteam.mind.manipulation.leave_manipulation import fold_and_turn_back
from uniteam.mind.manipulation.load_footprint import LoadFootprint
from uniteam.mind.manipulation.pick.reach_out_pick import ReachOut
from uniteam.mind.manipulation.pick.step_back_pick import StepBack
from uniteam.mind.manipulation.pick.tilt_head import TiltHead
from uniteam.mind.manipulation.place.checked_arm_path import CheckedArmPath
from uniteam.mind.manipulation.place.drop_height import LOW_DROP
from uniteam.mind.manipulation.place.flat_ground import FlatGround
from uniteam.mind.manipulation.place.headroom import points_with_headroom
from uniteam.mind.manipulation.place.more_attempts import ATTEMPTS, LAST_CALL, LEAST_WORTH
from uniteam.mind.manipulation.place.motion import ExactMotion
from uniteam.mind.manipulation.place.occupied_surface import RoomAmongOthers
from uniteam.mind.manipulation.place.receptacle_mask import whole_mask
from uniteam.mind.manipulation.place.verify_place import LookWhereItLies, WatchRest
from uniteam.mind.manipulation.place.withdraw import stay
from uniteam.mind.mapping.clearing import ClearSeenThrough
from uniteam.mind.mapping.fine_obstacles import FineGrain
from uniteam.mind.mapping.low_obstacles import LOWEST_OBSTACLE
from uniteam.mind.mapping.projection import exact_pixels
from uniteam.mind.mapping.resolved_look import ResolvedLook
from uniteam.mind.mapping.visited import mark_line
from uniteam.mind.navigation.first_look import FULL_CIRCLE
from uniteam.mind.navigation.goals.exploration import (
    any_frontier,
    any_goal_with_a_path,
    object_beside_start_receptacle,
    when_blocked_nearby,
    while_it_leads_on,
)
from uniteam.mind.navigation.goals.failed_goals import FailedGoalMemory
from uniteam.mind.navigation.goals.object_elsewhere import ObjectElsewhere
from uniteam.mind.navigation.goals.surround_start_receptacle import SurroundStartReceptacle
from uniteam.mind.navigation.planning.clearance_cost import ClearancePrice
from uniteam.mind.navigation.planning.collision_mapping import before_the_rim, keep_collisions
from uniteam.mind.navigation.planning.long_strides import LongStrides
from uniteam.mind.navigation.planning.narrow_motion import ExactWhereNarrow, SpareNarrowWays
from uniteam.mind.navigation.planning.planner import plan_string_pulled
from uniteam.mind.navigation.planning.planner_config import turn_in_steps
from uniteam.mind.navigation.planning.traversible import OWN_CELLS
from uniteam.mind.navigation.planning.true_radius import true_radius
from uniteam.mind.perception.instance_memory import InstanceMemory
from uniteam.mind.skills.step_aside import AfterBlockedMotions
from uniteam.stretch import DEPTH_RANGE


def _true_radius(config: AgentConfig) -> AgentConfig:
    dilations = true_radius(config.map.cell_size)
    return Replacement("true_radius", (("planner.dilations", dilations),))(config)


BEYOND: tuple[Improvement, ...] = (
    replacing(
        "step_aside", "blocked again and again, the robot steps aside at random", steps_aside=AfterBlockedMotions()
    ),
    Improvement("true_radius", "paths keep the base's true radius from obstacles where they can", _true_radius),
    replacing(
        "tilt_head",
        "when the object is not in view at the pick, the head looks up and down for it",
        pick__tilt_head=TiltHead(),
    ),
    replacing(
        "step_back_pick",
        "when the object is not in view at the pick, the robot draws back until it is",
        pick__step_back=StepBack(look=TiltHead()),
    ),
    replacing(
        "reach_out_pick",
        "an object in view beyond reach is driven to, and the arm lifted and extended to it",
        pick__reach_out=ReachOut(),
    ),
    replacing(
        "headroom",
        "placing points have room above them, so walls, fronts and flanks are none",
        place__choose_points__candidates=points_with_headroom,
    ),
    replacing(
        "flat_ground",
        "placing points with level ground around them are preferred",
        place__choose_points__bonus=FlatGround(),
    ),
    replacing(
        "checked_arm_path",
        "the arm takes only paths on which it touches nothing seen, from higher up where it must",
        place__find_path=CheckedArmPath(),
    ),
    replacing(
        "more_attempts",
        "where nothing can be placed well, the robot tries other places as long as there are steps before it lets go",
        place__attempts=ATTEMPTS,
        place__last_call=LAST_CALL,
        place__least_worth=LEAST_WORTH,
    ),
    replacing(
        "level_wrist",
        "the object is released with the wrist level, from which the gripper gets farther and higher",
        place__release__wrist_pitch=LEVEL_WRIST,
    ),
    replacing(
        "far_sight",
        "goal receptacles are mapped from as far as depth is measured",
        map__class_depths=(*BASELINE.map.class_depths[:2], DEPTH_RANGE),
    ),
    replacing(
        "wide_collisions",
        "with collision_mapping, a collision is written before the base's rim, and wider when blocked again",
        planner__felt_at=before_the_rim,
    ),
    replacing(
        "full_circle", "the first look goes all around, whatever is seen", first_turns=12, first_look=FULL_CIRCLE
    ),
    replacing(
        "string_pulled_path",
        "paths are pulled straight, and smaller dilations tried only in the step that has no other path",
        make_planner=plan_string_pulled,
    ),
    replacing(
        "near_enough",
        "a goal is reached 0.1 m before, and up to 0.95 m from it where nothing nearer is free",
        planner__tolerance=0.10,
        planner__patience=(0.25, 0.45),
    ),
    replacing("own_disc", "all that lies under the base is free, since it stands there", planner__own_cells=OWN_CELLS),
    replacing("straight_face", "the goal is faced to 15 degrees, not to 20", planner__face=turn_in_steps),
    replacing("clean_frontiers", "frontiers are where nothing seen stands in the way", search__frontier=any_frontier),
    replacing(
        "other_goals",
        "where there is no path to a goal, others are tried, and the robot gives up rather than act in vain",
        search__pursue=any_goal_with_a_path,
        search__goes_on=while_it_leads_on,
    ),
    replacing(
        "blocked_arrival",
        "blocked again and again within 0.6 m of the goal, the robot has arrived",
        search__has_arrived=when_blocked_nearby,
    ),
    replacing(
        "cell_play",
        "an object one cell beside its start receptacle is taken to lie on it",
        search__object=object_beside_start_receptacle,
    ),
    replacing(
        "turn_back",
        "the base turns back once the arm is folded",
        pick__leave=fold_and_turn_back,
        place__leave=fold_and_turn_back,
    ),
    replacing(
        "exact_labels",
        "each pixel marks the map by its own depth and label, where HomeRobot's blocks share one depth",
        map__project=exact_pixels,
    ),
    replacing(
        "driven_line", "the line that the robot drove stays free, not only where it stood", map__mark_visited=mark_line
    ),
    replacing(
        "exact_motion",
        "placing, the base turns and drives by what is asked for, and the robot knows where it has got to",
        place__motion=ExactMotion(),
    ),
    replacing("whole_mask", "the goal receptacle is seen to the rim of its mask", place__receptacle=whole_mask),
    replacing("still_arm", "the arm stays where it let go", place__withdraw=stay),
    replacing(
        "occupied_surface",
        "placing points leave room between what is held and the other things on the surface",
        place__choose_points__missing_room=RoomAmongOthers(),
    ),
    replacing(
        "verify_place",
        "after the release the robot looks where the object lies, and picks it up again where that is wrong",
        place__wait=WatchRest(),
        place__verify=LookWhereItLies(),
    ),
    replacing(
        "resolved_look",
        "a receptacle counts as looked at where pixels showed it near enough, and nothing hid it",
        map__looks=ResolvedLook(),
    ),
    replacing(
        "low_obstacles",
        "what is lower than 10 cm and stops the base is mapped too",
        map__min_obstacle_height=LOWEST_OBSTACLE,
    ),
    replacing(
        "clearing",
        "what the map holds is taken back where the floor is seen again and again and nothing above it",
        map__clear=ClearSeenThrough(),
    ),
    replacing(
        "clearance_cost",
        "a path keeps away from obstacles where that is no long way round",
        planner__price=ClearancePrice(),
    ),
    replacing(
        "narrow_motion",
        "turns from 5 degrees and drives from 0.1 m where 30 degrees and 0.25 m do not fit",
        planner__move=ExactWhereNarrow(),
        planner__spares=SpareNarrowWays(),
        map__fine_obstacles=FineGrain(),
    ),
    replacing(
        "long_strides",
        "exact turns, and drives of up to a metre where the way ahead is straight and clear",
        planner__stride=LongStrides(),
    ),
    replacing(
        "failed_goal_memory",
        "a place that could not be reached is avoided, the longer the more often it failed",
        failed_goals=FailedGoalMemory(),
    ),
    replacing(
        "load_footprint",
        "the load is part of the footprint on which the robot drives and turns, where there is a way so wide",
        footprint=LoadFootprint(),
    ),
    replacing(
        "last_round",
        "steps that are left are used: what failed is tried again, and what was looked at is looked at closer",
        relax=LastRound(),
        search__start_receptacle_again=SurroundStartReceptacle(farthest=CLOSE),
        map__closer_looks=ResolvedLook(farthest=CLOSE_LOOK),
        planner__no_path=keep_collisions,
    ),
    replacing(
        "instance_memory",
        "what a piece of furniture is taken for is decided by all views of it together, not by each frame",
        remember=InstanceMemory(),
    ),
    replacing(
        "object_elsewhere",
        "after a long search, an object is taken wherever it lies",
        search__object_elsewhere=ObjectElsewhere(),
    ),
    replacing(
        "second_look",
        "what the robot is not sure of is looked at from another side before it is picked or placed on",
        doubts=BelowScore(),
    ),
    replacing("low_drop", "a small object is released close above the surface", place__release__least_height=LOW_DROP),
)
"""What uniteam does beyond the report."""
