"""With its map, its exploration or its navigation replaced, an agent does what only the truth lets it do."""

import numpy as np
import pytest

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.truth_parts.true_exploration import TrueGoalReceptacle, TrueObject
from uniteam.geometry import BasePose, transform_points
from uniteam.mind.agents.heuristic_agent import HeuristicAgent
from uniteam.world.task.environment import Environment
from uniteam.world.task.footprint import distance_to_footprint
from uniteam.world.task.splits import load_split


class Played:
    """An agent's first steps in an episode.

    Attributes:
        steps: how many.
        states: of the agent at each.
        blocked: how often the base was blocked.
        driven: how far it got, all motions together (m).
        found_at: the step at which the object was found; None where it was not.
    """

    def __init__(self, name: str, split: str, episode: int, steps: int, until_found: bool = False) -> None:
        homes = load_split(split)
        asked = homes.episodes[episode]
        self.environment = Environment(homes.homes[asked.home], asked, give_truth=True)
        agent = AgentSpec(name, "truth").make(self.environment)
        assert isinstance(agent, HeuristicAgent)
        self.agent = agent
        agent.reset(asked.instruction, asked.seed)
        observation = self.environment.reset()
        self.states, self.blocked, self.driven = list[str](), 0, 0.0
        self.found_at: int | None = None
        while not self.environment.is_over and len(self.states) < steps:
            decision, before = agent.act(observation), observation.base_to_start
            observation = self.environment.step(decision.action)
            self.states.append(decision.state)
            self.blocked += self.environment.events.blocked
            self.driven += before.distance_to(observation.base_to_start.x, observation.base_to_start.y)
            if self.found_at is None and self.environment.measures.find_object_phase_success:
                self.found_at = len(self.states)
                if until_found:
                    break

    def clearances(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return the explored cells, the obstacles and the true clearances (m), of all cells around the start."""
        bird_map, start = self.agent.board.bird_map, self.environment.episode.start
        middle = bird_map.to_cell(0.0, 0.0)
        near = slice(middle[0] - 60, middle[0] + 60), slice(middle[1] - 60, middle[1] + 60)
        explored, obstacle = bird_map.explored[near], bird_map.obstacle[near]
        world = start.matrix()
        true = np.zeros(explored.shape)
        for row, column in np.ndindex(*true.shape):
            x, y = bird_map.to_point(row + near[0].start, column + near[1].start)
            u, v = (world @ [x, y, 0.0, 1.0])[:2]
            true[row, column] = self.environment.simulator.floor.clearance(float(u), float(v))
        return explored, obstacle, true


def test_the_true_map_has_the_true_obstacles_where_the_agent_has_seen_and_nowhere_else() -> None:
    explored, obstacle, true = Played("true-map:baseline", "minival", 5, steps=14).clearances()
    assert np.count_nonzero(obstacle) > 100 and not obstacle[~explored].any()
    assert true[obstacle].max() <= 0.06
    assert true[explored & ~obstacle].min() > 0.0
    _, own, _ = Played("baseline", "minival", 5, steps=14).clearances()
    assert (own != obstacle).any() and not (true[explored & ~own].min() > 0.0)


def test_an_agent_that_is_told_where_things_are_finds_the_object_sooner() -> None:
    told = Played("true-exploration:uniteam-plus", "val", 44, steps=100, until_found=True)
    assert told.found_at is not None
    assert Played("uniteam-plus", "val", 44, steps=told.found_at + 30).found_at is None


def test_the_goals_that_are_told_lie_where_things_are() -> None:
    played = Played("true-exploration:baseline", "minival", 5, steps=1)
    environment, bird_map, here = played.environment, played.agent.board.bird_map, BasePose(0.0, 0.0, 0.0)
    for told, names in (
        (TrueObject(environment)(bird_map, here), [c.name for c in environment.episode.objects]),
        (TrueGoalReceptacle(environment)(bird_map, here), [c.name for c in environment.episode.goal_receptacles]),
    ):
        assert told is not None
        points = transform_points(
            environment.episode.start.matrix(), np.pad(bird_map.points_of(told.cells), ((0, 0), (0, 1)))
        )[:, :2]
        things = [environment.home.by_name[name] for name in names]
        away = np.array([distance_to_footprint(environment.home, thing, points) for thing in things])
        assert away.min(axis=0).max() < 0.1 and away.min(axis=1).max() < 0.05


def test_true_paths_are_never_blocked() -> None:
    true = Played("true-navigation:baseline", "minival", 3, steps=110)
    assert true.driven > 4.0 and true.blocked == 0
    assert Played("baseline", "minival", 3, steps=110).blocked > 0


@pytest.mark.parametrize("module", ["map", "exploration", "navigation"])
def test_each_is_played_by_its_name(module: str) -> None:
    assert AgentSpec(f"true-{module}:baseline", "noisy:1").needs_truth
