"""The agents as values: names, mixtures, descriptions, and what they make of imperfect eyes."""

import json
import math
import pickle
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, replace
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest
from worlds.arm_world import ArmWorld
from worlds.box_world import Box, observe, room

from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import (
    Action,
    Decision,
    Detection,
    DiscreteAction,
    Instruction,
    Observation,
    Segmentation,
)
from uniteam.mind.agents.beyond import BEYOND
from uniteam.mind.agents.config import BASELINE, AgentConfig
from uniteam.mind.agents.describe import describe
from uniteam.mind.agents.heuristic_agent import HeuristicAgent
from uniteam.mind.agents.improvement import Improvement, ImprovementError
from uniteam.mind.agents.improvements import IMPROVEMENTS, improved
from uniteam.mind.agents.registry import agent_config, describe_agent, make_agent
from uniteam.mind.agents.report import REPORT
from uniteam.mind.manipulation.place.after_release import WaitSteps
from uniteam.mind.manipulation.place.more_attempts import ATTEMPTS
from uniteam.mind.mapping.birds_eye_map import BirdsEyeMap
from uniteam.mind.navigation.goal import Goal
from uniteam.mind.perception.registry import needs_truth

INSTRUCTION = Instruction("cup", "table", "bed")
UNITEAM = improved(BASELINE, REPORT)
PLUS = improved(BASELINE, (*REPORT, *BEYOND))
IMPATIENT = {
    name: replace(config, place=replace(config.place, wait=WaitSteps(2)))
    for name, config in {"baseline": BASELINE, "uniteam": UNITEAM, "uniteam-plus": PLUS}.items()
}
CAMERA = PinholeCamera.from_horizontal_fov(120, 160, math.radians(42.0))
TABLE = Box((1.6, -0.8, 0.0), (2.4, 0.8, 0.7), "table")
CUP = Box((1.7, -0.04, 0.7), (1.78, 0.04, 0.8), "cup")
BED = Box((-2.4, -0.9, 0.0), (-0.9, 0.9, 0.5), "bed")
ROOM = room(-3.0, -2.5, 3.0, 2.5)


def drive(agent: HeuristicAgent, world: ArmWorld, most_steps: int = 400) -> list[Decision]:
    """Let an agent act until it stops."""
    agent.reset(INSTRUCTION, seed=3)
    decisions: list[Decision] = []
    while len(decisions) < most_steps:
        decision = agent.act(world.observe())
        decisions.append(decision)
        if decision.action is DiscreteAction.STOP:
            break
        world.do(decision.action)
    return decisions


def states(decisions: list[Decision]) -> list[str]:
    """Return the states in the order in which they came, repetitions left out."""
    return [d.state for i, d in enumerate(decisions) if i == 0 or decisions[i - 1].state != d.state]


class Eyes:
    """A perception made of a function."""

    def __init__(self, see: Callable[[Observation, Instruction], Segmentation]) -> None:
        self._see = see
        self._instruction = Instruction("", "", "")

    def reset(self, instruction: Instruction, seed: int) -> None:
        self._instruction = instruction

    def perceive(self, observation: Observation) -> Segmentation:
        return self._see(observation, self._instruction)


def see_truth(observation: Observation, instruction: Instruction) -> Segmentation:
    assert observation.truth is not None
    return observation.truth


@pytest.mark.parametrize("config", IMPATIENT.values(), ids=IMPATIENT.keys())
def test_the_machine_goes_from_looking_around_to_stop_in_one_room(config: AgentConfig) -> None:
    world = ArmWorld((*ROOM, TABLE, CUP, BED), BasePose(0.0, 0.0, math.pi / 2), camera=CAMERA)
    decisions = drive(HeuristicAgent(config, Eyes(see_truth)), world)
    assert states(decisions)[0] == "LOOK_AROUND"
    assert states(decisions)[-3:] == ["NAVIGATE_TO_RECEPTACLE", "PLACE", "DONE"]
    assert "PICK" in states(decisions)
    assert [d.state for d in decisions].count("LOOK_AROUND") <= config.first_turns
    assert decisions[-1].action is DiscreteAction.STOP
    assert world.released is not None
    x, y, z = world.released
    assert -2.4 < x < -0.9 and -0.9 < y < 0.9 and z > 0.5
    assert world.hits == []


def test_every_decision_gives_a_reason_that_is_a_sentence_and_an_overlay_that_can_be_drawn() -> None:
    world = ArmWorld((*ROOM, TABLE, CUP, BED), BasePose(0.0, 0.0, 0.0), camera=CAMERA)
    agent = HeuristicAgent(UNITEAM, Eyes(see_truth))
    agent.reset(INSTRUCTION, seed=1)
    for _ in range(40):
        decision = agent.act(world.observe())
        assert decision.reason[0].isupper() and decision.reason.endswith(".")
        explanation = agent.explain()
        assert explanation.segmentation is not None and explanation.overlay is not None
        overlay = explanation.overlay
        assert overlay.labels.ndim == 2 and overlay.labels.any()
        world.do(decision.action)


def test_verify_pick_returns_to_the_search_and_the_baseline_carries_nothing_to_the_bed() -> None:
    """The thing that perception calls a cup is none, so the gripper stays empty."""
    fake = Box(CUP.low, CUP.high, "cup")
    worlds = [
        ArmWorld((*ROOM, TABLE, fake, BED), BasePose(0.0, 0.0, 0.0), camera=CAMERA, target="nothing") for _ in range(2)
    ]
    baseline = drive(HeuristicAgent(BASELINE, Eyes(see_truth)), worlds[0], 150)
    better = drive(HeuristicAgent(improved(BASELINE, {"verify_pick"}), Eyes(see_truth)), worlds[1], 150)
    assert "PLACE" in states(baseline)
    after_pick = states(better)[states(better).index("PICK") + 1]
    assert after_pick in ("FIND_OBJECT", "NAVIGATE_TO_OBJECT")
    assert "PLACE" not in states(better)
    picks = [i for i, d in enumerate(better) if d.action is DiscreteAction.SNAP_OBJECT]
    assert len(picks) >= 2


def doubtful(observation: Observation, instruction: Instruction) -> Segmentation:
    """Waver over every thing, name the bed's neighbour a bed too, and see a cup in the wall with little certainty."""
    truth = see_truth(observation, instruction)
    detections = tuple(
        Detection(((d.name, 0.62), ("lamp", 0.3))) if d.name != "lamp" else Detection((("bed", 0.3), ("lamp", 0.2)))
        for d in truth.detections
    )
    ghost = Detection((("cup", 0.1), ("vase", 0.05)))
    instances = truth.instances.copy()
    instances[:4, :4] = len(detections)
    return Segmentation(instances, (*detections, ghost))


@pytest.mark.parametrize("config", IMPATIENT.values(), ids=IMPATIENT.keys())
def test_wavering_and_wrong_detections_go_through_filters_and_machine_to_the_right_end(config: AgentConfig) -> None:
    lamp = Box((-1.4, 1.9, 0.0), (-1.0, 2.3, 0.6), "lamp")
    world = ArmWorld((*ROOM, TABLE, CUP, BED, lamp), BasePose(0.0, 0.0, 0.0), camera=CAMERA)
    decisions = drive(HeuristicAgent(config, Eyes(doubtful)), world)
    assert states(decisions)[-1] == "DONE"
    assert world.released is not None
    assert -2.4 < world.released[0] < -0.9 and -0.9 < world.released[1] < 0.9


def blind(observation: Observation, instruction: Instruction) -> Segmentation:
    return Segmentation(np.full(observation.depth.shape, -1, dtype=np.int16), ())


def test_blind_eyes_keep_the_baseline_exploring_and_other_goals_and_clean_frontiers_give_up_in_the_end() -> None:
    ends = []
    for names in ((), ("other_goals", "clean_frontiers")):
        world = ArmWorld((*room(-1.5, -1.5, 1.5, 1.5), CUP), BasePose(0.0, 0.0, 0.0), camera=CAMERA)
        decisions = drive(HeuristicAgent(improved(IMPATIENT["baseline"], names), Eyes(blind)), world, 200)
        assert set(states(decisions)) <= {"LOOK_AROUND", "FIND_OBJECT", "DONE"}
        ends.append(decisions[-1])
    assert ends[0].state == "FIND_OBJECT"
    assert ends[1].action is DiscreteAction.STOP and "give up" in ends[1].reason


def test_with_nothing_to_head_for_the_baseline_picks_where_it_stands() -> None:
    """The robot is walled in, and beyond the walls is nothing that it could head for."""
    config = replace(IMPATIENT["baseline"], search=replace(BASELINE.search, frontier=_nothing))
    world = ArmWorld((*ROOM,), BasePose(0.0, 0.0, 0.0), camera=CAMERA)
    decisions = drive(HeuristicAgent(config, Eyes(blind)), world, 100)
    assert [state for state in states(decisions) if state in ("PICK", "PLACE", "DONE")] == ["PICK", "PLACE", "DONE"]


@dataclass
class InvisibleWall(ArmWorld):
    """A wall before the table that blocks the robot and that no camera sees.

    Attributes:
        in_a_row: how many drives have been blocked one after the other.
        longest: the most that there were in a row.
    """

    in_a_row: int = 0
    longest: int = 0

    def do(self, action: Action) -> None:
        before = self.base
        super().do(action)
        if action is not DiscreteAction.MOVE_FORWARD:
            return
        is_blocked = self.base.x > 0.6 and -0.6 < self.base.y < 0.6
        self.base = before if is_blocked else self.base
        self.in_a_row = self.in_a_row + 1 if is_blocked else 0
        self.longest = max(self.longest, self.in_a_row)


def drive_at_the_wall(*improvements: str, boxes: tuple[Box, ...]) -> tuple[InvisibleWall, list[Decision]]:
    world = InvisibleWall(boxes, BasePose(0.0, 0.0, 0.0), camera=CAMERA)
    config = improved(replace(BASELINE, first_turns=0), improvements)
    return world, drive(HeuristicAgent(config, Eyes(see_truth)), world, 120)


@pytest.mark.parametrize("name", ["goal_or_frontier", "step_aside", "collision_mapping"])
def test_the_baseline_drives_at_an_invisible_wall_for_ever_and_each_of_these_leaves_it(name: str) -> None:
    boxes = (*ROOM, TABLE, CUP)
    stuck, _ = drive_at_the_wall(boxes=boxes)
    leaving, decisions = drive_at_the_wall(name, boxes=boxes)
    assert stuck.longest > 100
    assert leaving.longest < 25
    assert "FIND_OBJECT" in states(decisions)


def test_one_seed_gives_one_trace_and_another_seed_another() -> None:
    agent = make_agent("random")
    observation = observe((), BasePose(0.0, 0.0, 0.0))

    def actions(seed: int) -> list[Action]:
        agent.reset(INSTRUCTION, seed)
        return [agent.act(observation).action for _ in range(40)]

    assert actions(4) == actions(4)
    assert actions(4) != actions(5)


def test_the_random_agent_chooses_every_discrete_action_about_as_often() -> None:
    agent = make_agent("random")
    agent.reset(INSTRUCTION, 0)
    observation = observe((), BasePose(0.0, 0.0, 0.0))
    counts = Counter(agent.act(observation).action for _ in range(2000))
    assert set(counts) == set(DiscreteAction)
    assert min(counts.values()) > 140 and max(counts.values()) < 260


def test_the_report_has_fourteen_improvements_and_each_of_all_changes_the_baseline() -> None:
    assert len(REPORT) == 14
    for improvement in (*REPORT, *BEYOND):
        assert improved(BASELINE, [improvement]) != BASELINE, improvement
        assert improvement.summary and IMPROVEMENTS.get(improvement.name) is improvement


def test_the_order_in_which_improvements_are_applied_makes_no_difference() -> None:
    backwards = BASELINE
    for improvement in reversed((*REPORT, *BEYOND)):
        backwards = improvement.apply(backwards)
    assert backwards == PLUS
    assert improved(BASELINE, [i.name for i in (*BEYOND, *REPORT)]) == PLUS


@pytest.mark.parametrize("improvement", (*REPORT, *BEYOND), ids=lambda improvement: improvement.name)
def test_an_improvement_does_not_fit_where_it_has_been_applied_already(improvement: Improvement) -> None:
    with pytest.raises(ImprovementError, match=improvement.name):
        improvement.apply(improvement.apply(BASELINE))


def _nothing(bird_map: BirdsEyeMap, base: BasePose) -> Goal | None:
    return None


def test_an_improvement_that_would_take_the_place_of_something_of_ones_own_says_so() -> None:
    own = replace(BASELINE, search=replace(BASELINE.search, goal_receptacle=_nothing))
    with pytest.raises(ImprovementError, match=r"'search.goal_receptacle'.*any_goal_receptacle.*has _nothing there"):
        improved(own, ["receptacle_probability"])
    assert improved(own, ["centre_approach"]).search.goal_receptacle is _nothing


def test_an_improvement_of_ones_own_is_applied_after_the_built_in_ones() -> None:
    def wait(config: AgentConfig) -> AgentConfig:
        return replace(config, first_turns=config.place.attempts)

    patient = Improvement("patient", "waits longer", wait)
    assert improved(BASELINE, [patient, "more_attempts"]).first_turns == ATTEMPTS


def test_an_improvement_that_makes_no_configuration_is_refused() -> None:
    forgetful = Improvement("forgetful", "returns nothing", lambda config: None)  # type: ignore[arg-type,return-value]
    with pytest.raises(ImprovementError, match="'forgetful' must return an AgentConfig, but returned NoneType"):
        improved(BASELINE, [forgetful])


def test_an_improvement_of_ones_own_that_fails_is_named() -> None:
    misspelt = Improvement("quick", "looks around less", lambda config: replace(config, first_turn=3))  # type: ignore[call-arg]
    with pytest.raises(ImprovementError, match=r"improvement 'quick' failed \(TypeError: .*first_turn"):
        improved(BASELINE, [misspelt])


def test_every_improvement_can_be_found_by_its_name_where_it_is_done() -> None:
    mind = Path(str(files("uniteam.mind")))
    text = "".join(p.read_text() for p in mind.rglob("*.py") if p.parent.name != "agents") + " ".join(
        p.name for p in mind.rglob("*.py")
    )
    assert [i.name for i in (*REPORT, *BEYOND) if i.name not in text] == []


def test_any_mixture_can_be_named_from_either_end() -> None:
    without = agent_config("uniteam", without=["edge_margin", "verify_pick"])
    with_ = agent_config("baseline", with_=[i.name for i in REPORT if i.name not in ("edge_margin", "verify_pick")])
    assert without == with_
    assert agent_config("uniteam") == UNITEAM
    assert agent_config("uniteam", without=[i.name for i in REPORT]) == BASELINE
    assert agent_config("random") is None


def test_what_a_configuration_of_ones_own_has_cannot_be_taken_away_and_what_it_lacks_need_not_be() -> None:
    own = "worlds.house_guest:sharp_edged"
    assert agent_config(own, without=["verify_pick"]) == improved(BASELINE, ["edge_margin"])
    assert agent_config("baseline", without=["edge_margin"]) == BASELINE
    with pytest.raises(InvalidInputError, match=r"'edge_margin' cannot be taken away from agent 'worlds\.house_guest:"):
        agent_config(own, without=["edge_margin"])


@pytest.mark.parametrize(("added", "removed"), [(("edge_margin",), ()), ((), ("edge_margin",))])
def test_an_agent_without_a_configuration_refuses_improvements(
    added: tuple[str, ...], removed: tuple[str, ...]
) -> None:
    for call in (make_agent, describe_agent):
        with pytest.raises(InvalidInputError, match=r"'random' is not made of a configuration.*\(edge_margin\)"):
            call("random", "truth", added, removed)


@pytest.mark.parametrize("name", ["baseline", "uniteam", "uniteam-plus", "random"])
def test_every_agent_is_described_in_json_and_improvements_show(name: str) -> None:
    text = json.dumps(describe_agent(name))
    assert f'"agent": "{name}"' in text
    if name != "random":
        assert json.dumps(describe_agent("baseline", with_=["drop_height"])) != json.dumps(describe_agent("baseline"))
        assert "EdgeMargin" in json.dumps(describe_agent("uniteam"))


def test_what_no_configuration_holds_cannot_be_described() -> None:
    with pytest.raises(InvalidInputError, match="cannot be described"):
        describe(np.zeros(3))


@pytest.mark.parametrize(
    ("call", "nearest"),
    [
        (lambda: make_agent("unitem"), "uniteam"),
        (lambda: make_agent("baseline", perception="trut"), "truth"),
        (lambda: make_agent("uniteam", without=["edge_margins"]), "edge_margin"),
        (lambda: make_agent("random", with_=["verify_pik"]), "verify_pick"),
        (lambda: needs_truth("thruth"), "truth"),
    ],
)
def test_a_misspelt_name_is_answered_with_the_nearest(call: Callable[[], object], nearest: str) -> None:
    with pytest.raises(UnknownNameError, match=f"did you mean '{nearest}'"):
        call()


def test_truth_is_needed_by_the_perception_of_that_name() -> None:
    assert needs_truth("truth")
    agent = make_agent("baseline")
    agent.reset(INSTRUCTION, 0)
    seen = observe((TABLE,), BasePose(0.0, 0.0, 0.0))
    with pytest.raises(InvalidInputError):
        agent.act(Observation(**{**vars(seen), "truth": None}))


def test_an_agent_that_may_be_in_the_midst_of_a_skill_says_what_to_send_in_its_place() -> None:
    with pytest.raises(TypeError, match="send its AgentConfig or AgentSpec instead"):
        pickle.dumps(make_agent("baseline"))
