"""What an agent does once nothing is left to head for."""

import math

import pytest
from worlds.arm_world import ArmWorld
from worlds.box_world import Box, room
from worlds.filled import filled

from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Decision, DiscreteAction, Instruction, Observation, Segmentation
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.heuristic_agent import HeuristicAgent
from uniteam.mind.agents.improvements import improved
from uniteam.mind.agents.last_round import LastRound, Relaxation

CAMERA = PinholeCamera.from_horizontal_fov(60, 80, math.radians(42.0))
TABLE = Box((0.9, -0.4, 0.0), (1.5, 0.4, 0.7), "table")


class Truth:
    """Sees what there is."""

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Do nothing."""

    def perceive(self, observation: Observation) -> Segmentation:
        assert observation.truth is not None
        return observation.truth


def search_an_empty_room(steps: int, *improvements: str) -> list[Decision]:
    """Let an agent search for a cup where there is none."""
    world = ArmWorld((*room(-1.5, -1.5, 1.5, 1.5), TABLE), BasePose(0.0, 0.0, 0.0), camera=CAMERA)
    agent = HeuristicAgent(improved(BASELINE, ("other_goals", "clean_frontiers", *improvements)), Truth())
    agent.reset(Instruction("cup", "table", "bed"), seed=1)
    decisions: list[Decision] = []
    while len(decisions) < steps and not (decisions and decisions[-1].action is DiscreteAction.STOP):
        decisions.append(agent.act(world.observe()))
        world.do(decisions[-1].action)
    return decisions


def test_last_round_goes_on_looking_where_others_give_up() -> None:
    given_up = search_an_empty_room(120)
    assert given_up[-1].action is DiscreteAction.STOP
    assert len(given_up) < 80
    assert all(d.action is not DiscreteAction.STOP for d in filled(search_an_empty_room(120, "last_round")))


def test_an_agent_that_has_seen_everything_goes_round_again() -> None:
    walls = (*room(-1.0, -1.0, 6.0, 1.0), Box((3.0, -1.0, 0.0), (3.2, 0.1, 2.5)))
    world = ArmWorld(walls, BasePose(0.0, 0.0, 0.0), camera=CAMERA)
    agent = HeuristicAgent(improved(BASELINE, ("other_goals", "clean_frontiers", "last_round")), Truth())
    agent.reset(Instruction("cup", "table", "bed"), seed=1)
    reasons: list[str] = []
    for _ in range(160):
        decision = agent.act(world.observe())
        reasons.append(decision.reason)
        world.do(decision.action)
    nothing_left = next(i for i, reason in enumerate(reasons) if reason.startswith("Nothing is left"))
    assert any("explore a frontier" in reason for reason in reasons[nothing_left:])


@pytest.mark.parametrize("rounds", [0, 4, 6])
def test_all_that_can_be_forgotten_is_forgotten_in_turn(rounds: int) -> None:
    relax = LastRound()
    assert {relax(rounds + i) for i in range(len(Relaxation))} == set(Relaxation)
