"""What to head for: goals chosen from the map, one small function each, tried in order.

A `ChooseGoal` looks at the map and returns a goal or None. An agent's search is a `SearchConfig`, which has a slot for
each: the defaults are the baseline's, and improvements put their own in their places.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from uniteam.geometry import BasePose
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.navigation.goals.frontier import FrontierConfig, border_of_explored, find_frontiers
from uniteam.mind.navigation.planning.plan import Plan
from uniteam.mind.navigation.planning.planner import Planner
from uniteam.mind.perception.vocabulary import ClassRole

ChooseGoal = Callable[[BirdsEyeMap, BasePose], Goal | None]
"""From the map and the robot (start frame) to a goal, or None when there is nothing of the kind."""


def object_on_start_receptacle(bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
    """Return the object's cells at which the start receptacle was seen too, to stand before and face."""
    cells = bird_map.object_on_start_receptacle(play=0)
    return Goal(GoalKind.OBJECT, cells, face=cells) if cells.any() else None


def object_beside_start_receptacle(bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
    """Return the object's cells at most one cell from the start receptacle, to stand before and face: `cell_play`."""
    cells = bird_map.object_on_start_receptacle(play=1)
    return Goal(GoalKind.OBJECT, cells, face=cells) if cells.any() else None


def nothing_elsewhere(bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
    """Return None: an object counts where the start receptacle was seen, as in HomeRobot."""
    return None


def start_receptacle_not_been_close(bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
    """Return the start receptacles' cells that the robot has not been within 1 m of: HomeRobot's exploration."""
    cells = bird_map.class_cells(ClassRole.START_RECEPTACLE) & ~bird_map.been_close
    return Goal(GoalKind.START_RECEPTACLE, cells) if cells.any() else None


def any_goal_receptacle(bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
    """Return all cells of the goal receptacle, to stand before the nearest and face it."""
    cells = bird_map.class_cells(ClassRole.GOAL_RECEPTACLE)
    return Goal(GoalKind.GOAL_RECEPTACLE, cells, face=cells) if cells.any() else None


def near_unexplored(bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
    """Return all that lies half a metre beyond the explored, to come near to: HomeRobot's exploration."""
    cells = border_of_explored(bird_map, base)
    return Goal(GoalKind.FRONTIER, cells) if cells.any() else None


def any_frontier(bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
    """Return all frontiers where nothing stands; the planner goes to the nearest: `clean_frontiers`."""
    cells = find_frontiers(bird_map, base, FrontierConfig())
    return Goal(GoalKind.FRONTIER, cells, distance=0.0) if cells.any() else None


Found = tuple[Goal, Plan]
"""What to head for, and how."""
Pursue = Callable[[Planner, BirdsEyeMap, BasePose, Sequence[ChooseGoal], GoalKind], Found | None]
"""From planner, map, robot, choices in order of preference (the frontier last) and the kind that ends the search to
what is headed for; None where there is nothing."""


def always(planner: Planner, plan: Plan) -> bool:
    """Carry every plan out, whatever comes of it."""
    return True


def never(planner: Planner, plan: Plan) -> bool:
    """Take nothing but the goal for the goal."""
    return False


def forget_probabilities(bird_map: BirdsEyeMap) -> None:
    """Forget how probable goal receptacles were that were seen on the way to the object; where they are is known."""
    bird_map.forget_probability(ClassRole.GOAL_RECEPTACLE)


def remember_probabilities(bird_map: BirdsEyeMap) -> None:
    """Keep what was seen on the way to the object as candidates with their probabilities: `early_goal_memory`."""


Approach = Callable[[Goal, BirdsEyeMap, BasePose], Goal]
"""From the goal of standing before a receptacle, the map and the robot to that of standing at a chosen side of it."""


def from_any_side(goal: Goal, bird_map: BirdsEyeMap, base: BasePose) -> Goal:
    """Return the goal as it is: whichever side is nearest will do."""
    return goal


def plan_first(planner: Planner, bird_map: BirdsEyeMap, base: BasePose, choices: Sequence[ChooseGoal]) -> Found | None:
    """Return the first choice's goal to which there is a path, and the plan.

    A goal that is reached counts: its plan's action is None. Where no goal has a path, what collisions taught is
    forgotten on the map. Where none has a path even then, the plan leads as near to the first one as possible; None
    when there is no goal at all. Whatever becomes of the plan is to be told to the planner (`begin`).
    """
    found = _first_reachable(planner, bird_map, base, choices)
    if found is not None and not found[1].reachable and bird_map.collision.any():
        planner.config.no_path(bird_map)
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


def any_goal_with_a_path(
    planner: Planner, bird_map: BirdsEyeMap, base: BasePose, choices: Sequence[ChooseGoal], target: GoalKind
) -> Found | None:
    """Head for the first choice to which there is a path, or else as near to the first as possible: `other_goals`."""
    return plan_first(planner, bird_map, base, choices)


def first_goal_or_frontier(
    planner: Planner, bird_map: BirdsEyeMap, base: BasePose, choices: Sequence[ChooseGoal], target: GoalKind
) -> Found | None:
    """Head for the first choice that there is, as HomeRobot does.

    Where it is what was searched for and there is no path to it, head for the frontier; where there is none to that
    either, or nothing to head for at all, take the robot to be where it should be. Before that, what collisions taught
    is forgotten, if anything is left of it.
    """
    found = _goal_or_frontier(planner, bird_map, base, choices, target)
    if found is None and bird_map.collision.any():
        planner.config.no_path(bird_map)
        found = _goal_or_frontier(planner, bird_map, base, choices, target)
    return found or _stop_here(bird_map, base, target)


def _goal_or_frontier(
    planner: Planner, bird_map: BirdsEyeMap, base: BasePose, choices: Sequence[ChooseGoal], target: GoalKind
) -> Found | None:
    goal = next((goal for choose in choices if (goal := choose(bird_map, base)) is not None), None)
    if goal is None:
        return None
    planner.notice(bird_map, base)
    plan = planner.plan(bird_map, base, goal)
    if plan.reachable or goal.kind is not target:
        return goal, plan
    if plan.has_place:
        planner.give_way(bird_map)
    frontier = choices[-1](bird_map, base)
    if frontier is None:
        return None
    plan = planner.plan(bird_map, base, frontier)
    return (frontier, plan) if plan.reachable else None


def _stop_here(bird_map: BirdsEyeMap, base: BasePose, target: GoalKind) -> Found:
    """Return the goal that is reached where the robot stands."""
    nothing = np.zeros((0, 2))
    here = np.array([[base.x, base.y]])
    plan = Plan(None, True, True, False, 0.0, None, here, nothing)
    return Goal(target, np.zeros(bird_map.shape, dtype=np.bool_)), plan


def while_it_leads_on(planner: Planner, plan: Plan) -> bool:
    """Carry out what gets the robot to its goal, or at least nearer: `other_goals`."""
    return planner.leads_on(plan)


NEARLY_THERE = 0.6
"""m along the path: a robot that is blocked so near to its goal has it within the arm's reach."""


def when_blocked_nearby(planner: Planner, plan: Plan) -> bool:
    """Take a robot that is blocked again and again near to the goal for one that is there: `blocked_arrival`."""
    return plan.reachable and planner.is_blocked_often and plan.distance <= NEARLY_THERE


@dataclass(frozen=True)
class SearchConfig:
    """What to head for, by what is known; the defaults are HomeRobot's (arXiv 2306.11565).

    Attributes:
        object: where the object is known.
        start_receptacle: where only start receptacles are known, while there is no object in the gripper.
        object_elsewhere: where neither is known, but an object that lies on something else.
        start_receptacle_again: instead of `start_receptacle`, once looks at them have shown nothing and were forgotten.
        goal_receptacle: where goal receptacles are known, with the object in the gripper.
        approach: at which side of the goal receptacle to stand.
        frontier: where nothing of all this is known.
        pursue: what is headed for where there is no path to the first choice.
        goes_on: whether a plan is carried out; else the robot turns round on the spot, and gives up.
        has_arrived: whether a plan that is not at its end yet is as good as there.
        recall: what becomes of the goal receptacles seen before, once the object is in the gripper.
    """

    object: ChooseGoal = object_on_start_receptacle
    start_receptacle: ChooseGoal = start_receptacle_not_been_close
    object_elsewhere: ChooseGoal = nothing_elsewhere
    start_receptacle_again: ChooseGoal = start_receptacle_not_been_close
    goal_receptacle: ChooseGoal = any_goal_receptacle
    approach: Approach = from_any_side
    frontier: ChooseGoal = near_unexplored
    pursue: Pursue = first_goal_or_frontier
    goes_on: Callable[[Planner, Plan], bool] = always
    has_arrived: Callable[[Planner, Plan], bool] = never
    recall: Callable[[BirdsEyeMap], None] = forget_probabilities

    def for_object(self) -> tuple[ChooseGoal, ...]:
        """Return what to head for while there is no object in the gripper, in order of preference."""
        return self.object, self.start_receptacle, self.object_elsewhere, self.frontier

    def for_another_look(self) -> "SearchConfig":
        """Return what to head for once looks at the start receptacles have shown nothing."""
        return replace(self, start_receptacle=self.start_receptacle_again)

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
