"""What an agent does where it is not sure of what it stands before."""

import math
from dataclasses import replace

from worlds.arm_world import ArmWorld
from worlds.box_world import Box, room

from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Decision, Detection, DiscreteAction, Instruction, Observation, Segmentation
from uniteam.mind.agents.beyond import BEYOND
from uniteam.mind.agents.config import BASELINE, AgentConfig
from uniteam.mind.agents.heuristic_agent import HeuristicAgent
from uniteam.mind.agents.improvements import improved
from uniteam.mind.agents.report import REPORT
from uniteam.mind.manipulation.place.after_release import WaitSteps

CAMERA = PinholeCamera.from_horizontal_fov(120, 160, math.radians(42.0))
ROOM = room(-3.5, -3.0, 3.5, 3.0)
TABLE = Box((1.8, -0.6, 0.0), (2.6, 0.6, 0.7), "table")
CUP = Box((1.9, -0.04, 0.7), (1.98, 0.04, 0.8), "cup")
BENCH = Box((-1.2, -0.3, 0.0), (-0.6, 0.3, 0.5), "bed")
BED = Box((-1.4, -2.9, 0.0), (0.4, -1.9, 0.5), "bed")
MIDDLE_OF_BENCH = (-0.9, 0.0)
FAIRLY_SURE = 0.75


class Eyes:
    """Is fairly sure of beds, and takes the bench for one where it is seen along x; from its sides it is none."""

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Do nothing."""

    def perceive(self, observation: Observation) -> Segmentation:
        assert observation.truth is not None
        *others, bench, bed = observation.truth.detections
        x, y = observation.camera_to_start[:2, 3] - MIDDLE_OF_BENCH
        of_bench = FAIRLY_SURE if abs(y) < abs(x) else 0.02
        scored = (*others, Detection(((bench.name, of_bench),)), Detection(((bed.name, FAIRLY_SURE),)))
        return replace(observation.truth, detections=scored)


def config(*left_out: str) -> AgentConfig:
    """Return uniteam-plus without some improvements, and without its patience after a release.

    Views that agree would make it surer; here each stands for itself. Of what the map holds, any bed will do.
    """
    left_out = ("instance_memory", "receptacle_probability", *left_out)
    names = [improvement.name for improvement in (*REPORT, *BEYOND) if improvement.name not in left_out]
    whole = improved(BASELINE, names)
    return replace(whole, place=replace(whole.place, wait=WaitSteps(2)))


def play(*left_out: str) -> tuple[ArmWorld, list[Decision]]:
    """Let an agent bring the cup to a bed; the bench is on its way."""
    world = ArmWorld((*ROOM, TABLE, CUP, BENCH, BED), BasePose(0.8, 0.0, math.pi), camera=CAMERA)
    agent = HeuristicAgent(config(*left_out), Eyes())
    agent.reset(Instruction("cup", "table", "bed"), seed=3)
    decisions: list[Decision] = []
    while len(decisions) < 300 and not (decisions and decisions[-1].action is DiscreteAction.STOP):
        decisions.append(agent.act(world.observe()))
        world.do(decisions[-1].action)
    return world, decisions


def said(decisions: list[Decision]) -> str:
    """Return all that was given as a reason."""
    return " ".join(decision.reason for decision in decisions)


def test_what_is_no_bed_from_its_side_is_left_for_what_is_one() -> None:
    world, decisions = play()
    assert world.released is not None
    assert BED.low[0] < world.released[0] < BED.high[0] and BED.low[1] < world.released[1] < BED.high[1]
    aside = [d for d in decisions if d.reason == "I am not sure of the bed and look from another side."]
    assert len(aside) >= 2, "it drove around the bench, and around the bed"
    assert "I try elsewhere" not in said(decisions), "nothing was tried at the bench"


def test_without_it_the_first_impression_counts() -> None:
    world, decisions = play("second_look")
    assert world.released is not None
    assert BENCH.low[0] < world.released[0] < BENCH.high[0] and BENCH.low[1] < world.released[1] < BENCH.high[1]
    assert "not sure" not in said(decisions)
