"""What an agent is made of: values and strategies of one machine."""

from collections.abc import Callable
from dataclasses import dataclass, field

from uniteam.mind.agents.doubt import Doubt, trust_what_is_seen
from uniteam.mind.agents.last_round import Relaxation, give_up
from uniteam.mind.manipulation.arm_clearance import Load
from uniteam.mind.manipulation.load_footprint import base_alone
from uniteam.mind.manipulation.pick.pick import BASELINE_PICK, PickConfig
from uniteam.mind.manipulation.place.baseline_place import DriveInOneGo, extend_blindly, straight_path
from uniteam.mind.manipulation.place.drop_height import Release
from uniteam.mind.manipulation.place.place import PlaceConfig
from uniteam.mind.manipulation.place.placing_points import PointRule
from uniteam.mind.mapping.map_config import MapConfig
from uniteam.mind.navigation.first_look import HOMEROBOT_TURNS, FirstLook
from uniteam.mind.navigation.goals.exploration import SearchConfig
from uniteam.mind.navigation.goals.failed_goals import FailedGoals, remember_no_goals
from uniteam.mind.navigation.goals.goal_or_frontier import Trail, never_stuck
from uniteam.mind.navigation.planning.planner import Planner
from uniteam.mind.navigation.planning.planner_config import PlannerConfig
from uniteam.mind.navigation.planning.ring_planner import plan_by_ring
from uniteam.mind.perception.filters import Filter, ScoreFilter, Thresholds
from uniteam.mind.perception.instance_memory import Remember, forget_instances
from uniteam.mind.skills.step_aside import never_step_aside


@dataclass(frozen=True)
class AgentConfig:
    """The values and strategies of an agent; `improved` (improvements.py) returns changed ones.

    Attributes:
        filters: which detections to believe, one after the other.
        map: how frames become the map.
        planner: how to drive.
        search: what to head for.
        pick: how to pick.
        place: how to place.
        steps_aside: after how many blocked motions in a row to step aside.
        is_stuck: when to leave what the robot heads for, for a frontier.
        footprint: how much room (m) the robot needs around its axis with a load.
        failed_goals: how places are remembered that could not be reached.
        relax: after how many rounds what is forgotten once nothing is left to head for; None gives up.
        first_turns: turns of 30 degrees to look around with at first.
        first_look: to which side they are, and when fewer are enough.
        make_planner: makes the planner of an episode.
        doubts: what is looked at from another side before it is acted on.
        remember: makes an episode's memory of what single things were taken for, before the filters.
    """

    filters: tuple[Filter, ...]
    map: MapConfig
    planner: PlannerConfig
    search: SearchConfig
    pick: PickConfig
    place: PlaceConfig
    steps_aside: Callable[[int], bool] = never_step_aside
    is_stuck: Callable[[Trail], bool] = never_stuck
    footprint: Callable[[Load], float] = base_alone
    failed_goals: Callable[[], FailedGoals] = remember_no_goals
    relax: Callable[[int], Relaxation | None] = give_up
    first_turns: int = HOMEROBOT_TURNS
    first_look: FirstLook = field(default_factory=FirstLook)
    make_planner: Callable[[PlannerConfig], Planner] = plan_by_ring
    doubts: Doubt = trust_what_is_seen
    remember: Callable[[], Remember] = forget_instances


BASELINE = AgentConfig(
    filters=(ScoreFilter(Thresholds.single(0.45)),),
    map=MapConfig(),
    planner=PlannerConfig(),
    search=SearchConfig(),
    pick=BASELINE_PICK,
    place=PlaceConfig(
        choose_points=PointRule(),
        close_in=DriveInOneGo(),
        find_path=straight_path,
        release=Release(),
        fall_back=extend_blindly,
    ),
)
"""HomeRobot's heuristic agent (arXiv 2306.11565)."""
