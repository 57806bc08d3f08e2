"""Navigation by the truth: to what the agent heads for, along the oracle's paths over the true floor, exactly."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import lru_cache, partial

import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.truth_parts.true_floor import TrueFloor
from uniteam.evaluation.truth_parts.truth_family import truth_family
from uniteam.geometry import BasePose, Point2
from uniteam.interface import ACTION_LIMITS, Action, Agent, Perception
from uniteam.mind.agents.config import AgentConfig
from uniteam.mind.agents.heuristic_agent import HeuristicAgent
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal
from uniteam.mind.navigation.planning.distance_field import straight_distance
from uniteam.mind.navigation.planning.plan import Plan
from uniteam.mind.navigation.planning.planner import Planner
from uniteam.mind.navigation.planning.planner_config import PlannerConfig
from uniteam.world.oracle.base_driving import to_point
from uniteam.world.oracle.true_paths import PathField
from uniteam.world.physics.navigable_floor import CELL_SIZE, NavigableFloor
from uniteam.world.task.environment import Environment

ARRIVED = ACTION_LIMITS.least_move
"""m; a place so near needs no drive."""


@dataclass(frozen=True)
class _Stand:
    """Where on the floor the robot is to stand: (x, y) (m, world), and whether that is as near as was asked for."""

    point: Point2
    is_near_enough: bool


class TruePlanner(Planner):
    """Plans on the true floor, whatever the map says; goals are cells of the map, and facing them is the agent's own.

    What is held does not widen the base.
    """

    def __init__(self, environment: Environment, config: PlannerConfig) -> None:
        """Take the environment that the agent acts in."""
        super().__init__(config)
        self._environment = environment

    def plan(self, bird_map: BirdsEyeMap, base: BasePose, goal: Goal) -> Plan:
        """Return the next step towards a goal; nothing is changed by asking. Takes what `Planner.plan` does."""
        true = TrueFloor(self._environment.simulator.floor, self._environment.episode.start)
        here = true.start.compose(base)
        stand = self._nearest_stand(true, here, bird_map, goal)
        way = [] if stand is None else _field(true.floor, stand.point).path_from(here.x, here.y)
        path = true.to_start(np.array([(here.x, here.y), *way]))
        distance = float(np.hypot(*np.diff(path, axis=0).T).sum())
        is_near_enough = stand is not None and stand.is_near_enough
        short_term_goal, action = None, None
        if distance > ARRIVED:
            short_term_goal, action = (float(path[1, 0]), float(path[1, 1])), _first_motion(here, way)
        elif is_near_enough:
            action = self.turn_to_face(bird_map, base, goal)
        points = bird_map.points_of(goal.cells)
        return Plan(action, action is None, is_near_enough, False, distance, short_term_goal, path, points)

    def _nearest_stand(self, true: TrueFloor, here: BasePose, bird_map: BirdsEyeMap, goal: Goal) -> _Stand | None:
        """Return the nearest place near enough to the goal, else that nearest to it; None where there is no place."""
        costs = _field(true.floor, (here.x, here.y)).costs
        places = np.argwhere(np.isfinite(costs))
        centres = np.array([true.floor.to_point(0, 0)]) + places[:, ::-1] * CELL_SIZE
        to_goal = _distances(goal, bird_map, true.to_start(centres))
        if not np.isfinite(to_goal).any():
            return None
        for distance in self._distances(goal):
            near = to_goal <= distance
            if near.any():
                best = np.argmin(np.where(near, costs[places[:, 0], places[:, 1]], np.inf))
                return _Stand((float(centres[best, 0]), float(centres[best, 1])), True)
        x, y = centres[np.argmin(to_goal)]
        return _Stand((float(x), float(y)), False)


@lru_cache(maxsize=4)
def _field(floor: NavigableFloor, goal: Point2) -> PathField:
    """Return the ways to a goal, which are asked for again where the robot turns or goes on to the same place."""
    return PathField(floor, goal)


def _distances(goal: Goal, bird_map: BirdsEyeMap, points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return how far (m) (N, 2) points of the start frame are from a goal; infinite where it is not to be stood."""
    to_goal = straight_distance(goal.cells, bird_map.cell_size)
    if goal.shunned is not None:
        to_goal = np.where(goal.shunned, np.float32(np.inf), to_goal)
    columns, rows = np.floor((points - bird_map.origin) / bird_map.cell_size).astype(int).T
    inside = (rows >= 0) & (columns >= 0) & (rows < bird_map.shape[0]) & (columns < bird_map.shape[1])
    return np.where(inside, to_goal[np.where(inside, rows, 0), np.where(inside, columns, 0)], np.inf)


def _first_motion(here: BasePose, way: Iterable[Point2]) -> Action | None:
    """Return the first motion along points (m, world)."""
    return next((motion for point in way for motion in to_point(here, point)), None)


def with_true_navigation(config: AgentConfig, perception: Perception, environment: Environment) -> Agent:
    """Return an agent that drives along true paths."""
    return HeuristicAgent(replace(config, make_planner=partial(TruePlanner, environment)), perception)


TRUE_NAVIGATION = truth_family(with_true_navigation, "an agent that drives along paths of the true floor, exactly")
