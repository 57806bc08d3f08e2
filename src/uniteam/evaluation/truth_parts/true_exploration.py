"""Exploration by the truth: the agent is told where the objects and the goal receptacles that count are."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from uniteam.evaluation.truth_parts.true_floor import TrueFloor
from uniteam.evaluation.truth_parts.truth_family import truth_family
from uniteam.geometry import BasePose, transform_points
from uniteam.grid import Mask
from uniteam.interface import Agent, Perception
from uniteam.mind.agents.config import AgentConfig
from uniteam.mind.agents.heuristic_agent import HeuristicAgent
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.world.homes.home import Home
from uniteam.world.task.environment import Environment

SPACING = 0.02
"""m; how far apart the points are by which a thing is marked on the map."""
OBJECT_SIDE = 0.1
"""m; of the square that is marked around the middle of an object."""


@dataclass(frozen=True)
class TrueObject:
    """Heads for the objects that count, wherever they lie now."""

    environment: Environment

    def __call__(self, bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
        """Return the goal of standing before any of them and facing it; None where none lies on the map."""
        simulator, names = self.environment.simulator, [c.name for c in self.environment.episode.objects]
        square = _rectangle(OBJECT_SIDE, OBJECT_SIDE)
        points = np.concatenate([simulator.object_pose(name)[:2, 3] + square for name in names])
        cells = _marked(bird_map, self.environment, points)
        return Goal(GoalKind.OBJECT, cells, face=cells) if cells.any() else None


@dataclass(frozen=True)
class TrueGoalReceptacle:
    """Heads for the goal receptacles that count."""

    environment: Environment

    def __call__(self, bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
        """Return the goal of standing before any of them and facing it; None where none lies on the map."""
        names = [candidate.name for candidate in self.environment.episode.goal_receptacles]
        points = np.concatenate([_footprint(self.environment.home, name) for name in names])
        cells = _marked(bird_map, self.environment, points)
        return Goal(GoalKind.GOAL_RECEPTACLE, cells, face=cells) if cells.any() else None


def _footprint(home: Home, name: str) -> NDArray[np.float64]:
    """Return (N, 2) points (m, world) all over the floor that a piece of furniture covers."""
    piece = home.by_name[name]
    width, depth, _ = home.model_of(piece).size
    local = _rectangle(width, depth)
    return transform_points(piece.model_to_world(), np.column_stack([local, np.zeros(len(local))]))[:, :2]


def _rectangle(width: float, depth: float) -> NDArray[np.float64]:
    """Return (N, 2) points (m) all over a rectangle around the origin."""
    sides = (np.linspace(-side / 2, side / 2, 2 + int(side / SPACING)) for side in (width, depth))
    return np.stack(np.meshgrid(*sides), axis=-1).reshape(-1, 2)


def _marked(bird_map: BirdsEyeMap, environment: Environment, points: NDArray[np.float64]) -> Mask:
    """Return the (H, W) cells of the map that hold any of (N, 2) points (m, world)."""
    in_start = TrueFloor(environment.simulator.floor, environment.episode.start).to_start(points)
    columns, rows = np.floor((in_start - bird_map.origin) / bird_map.cell_size).astype(int).T
    inside = (rows >= 0) & (columns >= 0) & (rows < bird_map.shape[0]) & (columns < bird_map.shape[1])
    cells = np.zeros(bird_map.shape, dtype=np.bool_)
    cells[rows[inside], columns[inside]] = True
    return cells


def with_true_exploration(config: AgentConfig, perception: Perception, environment: Environment) -> Agent:
    """Return an agent that knows where to go."""
    goals = replace(config.search, object=TrueObject(environment), goal_receptacle=TrueGoalReceptacle(environment))
    return HeuristicAgent(replace(config, search=goals), perception)


TRUE_EXPLORATION = truth_family(with_true_exploration, "an agent that is told where object and goal receptacles are")
