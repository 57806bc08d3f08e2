"""A map by the truth: where something stands is what stands there, as far as the agent has seen.

Only the obstacles are replaced. What the agent has not seen of the home stays unknown, or exploration would be replaced
too; what things are is perception's matter.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from uniteam.evaluation.truth_parts.true_floor import TrueFloor
from uniteam.evaluation.truth_parts.truth_family import truth_family
from uniteam.grid import Grid, Mask
from uniteam.interface import Agent, Perception
from uniteam.mind.agents.config import AgentConfig
from uniteam.mind.agents.heuristic_agent import HeuristicAgent
from uniteam.mind.mapping.clearing import Clear, MapCells
from uniteam.mind.mapping.projection import MappedFrame
from uniteam.world.task.environment import Environment


@dataclass(frozen=True)
class ClearByTheTruth:
    """Begins an episode in which the obstacles of every explored cell are the true ones.

    Attributes:
        environment: with the truth.
        own: begins the agent's own rule of what is taken back, which goes on.
    """

    environment: Environment
    own: Callable[[], Clear]

    def __call__(self) -> Clear:
        """Return what corrects the map after each frame."""
        return _TrueObstacles(self.environment, self.own())


class _TrueObstacles:
    def __init__(self, environment: Environment, own: Clear) -> None:
        self._environment, self._own = environment, own
        self._known: tuple[TrueFloor, Grid, tuple[int, ...]] | None = None
        self._obstacles: Mask = np.zeros((0, 0), dtype=np.bool_)

    def __call__(self, frame: MappedFrame, cells: MapCells) -> None:
        """Let the agent's own rule take back what it does, then put the true obstacles where it has seen."""
        self._own(frame, cells)
        cells.channels.obstacle[:] = self._true(cells) & cells.channels.explored
        cells.felt[:] = False

    def _true(self, cells: MapCells) -> Mask:
        """Return the (H, W) true obstacles, sampled anew where the map has grown or something has moved."""
        environment, (rows, columns) = self._environment, cells.felt.shape
        known = TrueFloor(environment.simulator.floor, environment.episode.start), cells.grid, (rows, columns)
        if known != self._known:
            self._known, self._obstacles = known, known[0].obstacles(cells.grid, (rows, columns))
        return self._obstacles


def with_true_map(config: AgentConfig, perception: Perception, environment: Environment) -> Agent:
    """Return an agent whose map has the true obstacles."""
    clear = ClearByTheTruth(environment, config.map.clear)
    return HeuristicAgent(replace(config, map=replace(config.map, clear=clear)), perception)


TRUE_MAP = truth_family(with_true_map, "an agent whose map has the true obstacles, as far as it has seen")
