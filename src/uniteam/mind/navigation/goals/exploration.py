"""What to head for: goals chosen from the map, one small function each, tried in order.

A `ChooseGoal` looks at the map and returns a goal or None. An agent's search is a `SearchConfig`, which has a slot for
each: the defaults are the baseline's, and improvements put their own in their places.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from uniteam.geometry import BasePose
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.navigation.goals.frontier import FrontierConfig, find_frontiers
from uniteam.mind.navigation.planning.planner import Plan, Planner
from uniteam.mind.perception.vocabulary import ClassRole

ChooseGoal = Callable[[BirdsEyeMap, BasePose], Goal | None]
"""From the map and the robot (start frame) to a goal, or None when there is nothing of the kind."""


def object_on_start_receptacle(bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
    """Return the cells of the object that lie on the start receptacle, to stand before and face."""
    cells = bird_map.object_on_start_receptacle()
    return Goal(GoalKind.OBJECT, cells, face=cells) if cells.any() else None


def start_receptacle_not_been_close(bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
    """Return the start receptacles' cells that the robot has not been within 1 m of: HomeRobot's exploration."""
    cells = bird_map.class_cells(ClassRole.START_RECEPTACLE) & ~bird_map.been_close
    return Goal(GoalKind.START_RECEPTACLE, cells) if cells.any() else None


def any_goal_receptacle(bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
    """Return all cells of the goal receptacle, to stand before the nearest and face it."""
    cells = bird_map.class_cells(ClassRole.GOAL_RECEPTACLE)
    return Goal(GoalKind.GOAL_RECEPTACLE, cells, face=cells) if cells.any() else None


def any_frontier(bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
    """Return all frontiers; the planner goes to the nearest."""
    cells = find_frontiers(bird_map, base, FrontierConfig())
    return Goal(GoalKind.FRONTIER, cells, distance=0.0) if cells.any() else None


Approach = Callable[[Goal, BirdsEyeMap, BasePose], Goal]
"""From the goal of standing before a receptacle, the map and the robot to that of standing at a chosen side of it."""


def from_any_side(goal: Goal, bird_map: BirdsEyeMap, base: BasePose) -> Goal:
    """Return the goal as it is: whichever side is nearest will do."""
    return goal


@dataclass(frozen=True)
class SearchConfig:
    """What to head for, by what is known; the defaults are HomeRobot's (arXiv 2306.11565).

    Attributes:
        object: where the object is known.
        start_receptacle: where only start receptacles are known, while there is no object in the gripper.
        goal_receptacle: where goal receptacles are known, with the object in the gripper.
        approach: at which side of the goal receptacle to stand.
        frontier: where nothing of all this is known.
    """

    object: ChooseGoal = object_on_start_receptacle
    start_receptacle: ChooseGoal = start_receptacle_not_been_close
    goal_receptacle: ChooseGoal = any_goal_receptacle
    approach: Approach = from_any_side
    frontier: ChooseGoal = any_frontier

    def for_object(self) -> tuple[ChooseGoal, ...]:
        """Return what to head for while there is no object in the gripper, in order of preference."""
        return self.object, self.start_receptacle, self.frontier

    def for_receptacle(self) -> tuple[ChooseGoal, ...]:
        """Return what to head for with the object in the gripper, in order of preference.

        Where the chosen side cannot be reached, or placing from there has failed, any other side will do.
        """
        if self.approach is from_any_side:
            return self.goal_receptacle, self.frontier
        return self._approached_receptacle, self.goal_receptacle, self.frontier

    def _approached_receptacle(self, bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
        goal = self.goal_receptacle(bird_map, base)
        return None if goal is None else self.approach(goal, bird_map, base)


def plan_first(
    planner: Planner, bird_map: BirdsEyeMap, base: BasePose, choices: Sequence[ChooseGoal]
) -> tuple[Goal, Plan] | None:
    """Return the first choice's goal to which there is a path, and the plan.

    A goal that is reached counts: its plan's action is None. Where no goal has a path, what collisions taught is
    forgotten on the map. Where none has a path even then, the plan leads as near to the first one as possible; None
    when there is no goal at all. Whatever becomes of the plan is to be told to the planner (`begin`).
    """
    found = _first_reachable(planner, bird_map, base, choices)
    if found is not None and not found[1].reachable and bird_map.collision.any():
        planner.config.collisions.no_path(bird_map)
        found = _first_reachable(planner, bird_map, base, choices)
    return found


def _first_reachable(
    planner: Planner, bird_map: BirdsEyeMap, base: BasePose, choices: Sequence[ChooseGoal]
) -> tuple[Goal, Plan] | None:
    """Return the first choice to which there is a path, or else the first one that has a goal.

    What blocked the last motion is written into the map once there is a goal to plan for: the first goal is chosen on
    the map on which that motion was.
    """
    nearest: tuple[Goal, Plan] | None = None
    for choose in choices:
        goal = choose(bird_map, base)
        if goal is None:
            continue
        planner.notice(bird_map, base)
        plan = planner.plan(bird_map, base, goal)
        if plan.reachable:
            return goal, plan
        nearest = nearest or (goal, plan)
    return nearest
