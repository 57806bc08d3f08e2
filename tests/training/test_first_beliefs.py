"""From which score on to believe, by what came first in whole searches."""

from pathlib import Path

import pytest
from worlds.box_world import Box, observe

from uniteam.geometry import BasePose
from uniteam.interface import Detection, Instruction, Observation, Segmentation
from uniteam.mind.perception.instance_memory import forget_instances
from uniteam.mind.perception.threshold_file import read_thresholds
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.training.first_beliefs import (
    Belief,
    BesideTheTruth,
    best_thresholds,
    share_right_first,
    write_thresholds,
)

INSTRUCTION = Instruction("cup", "table", "bed")
TABLE = Box((1.0, -0.5, 0.0), (1.6, 0.5, 0.7), "table")
CUP = Box((1.2, -0.05, 0.7), (1.3, 0.05, 0.82), "cup")
LOST_CUP = Box((1.2, 1.2, 0.0), (1.3, 1.3, 0.12), "cup")
STAND = BasePose(-0.6, 0.0, 0.0)

WRONG, RIGHT = False, True


class TakesAllFor:
    """Says of everything that it is one thing, with one score."""

    def __init__(self, name: str, score: float) -> None:
        self._detection = Detection(((name, score),))

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Remember nothing."""

    def perceive(self, observation: Observation) -> Segmentation:
        truth = observation.truth
        assert truth is not None
        return Segmentation(truth.instances, (self._detection,) * len(truth.detections))


def noted(role: ClassRole, name: str, *boxes: Box) -> list[Belief]:
    beside = BesideTheTruth(TakesAllFor(name, 0.4), forget_instances())
    beside.reset(INSTRUCTION, 0)
    beside.perceive(observe(boxes, STAND))
    return beside.beliefs[role]


def test_a_detection_is_right_where_it_covers_a_thing_of_the_class() -> None:
    assert noted(ClassRole.START_RECEPTACLE, "table", TABLE, CUP) == [Belief(0.4, RIGHT), Belief(0.4, WRONG)]
    assert noted(ClassRole.GOAL_RECEPTACLE, "bed", TABLE, CUP) == [Belief(0.4, WRONG), Belief(0.4, WRONG)]


def test_an_object_counts_only_where_the_robot_would_look_for_it() -> None:
    assert noted(ClassRole.OBJECT, "cup", TABLE, CUP, LOST_CUP) == [Belief(0.4, WRONG), Belief(0.4, RIGHT)]
    assert noted(ClassRole.OBJECT, "cup", LOST_CUP) == []


def test_the_agent_is_told_the_truth_all_the_same() -> None:
    beside = BesideTheTruth(TakesAllFor("bed", 0.9), forget_instances())
    beside.reset(INSTRUCTION, 0)
    assert [d.name for d in beside.perceive(observe((TABLE, CUP), STAND)).detections] == ["table", "cup"]


def test_the_first_that_is_believed_decides() -> None:
    early_mistake = [Belief(0.3, WRONG), Belief(0.6, RIGHT)]
    late_mistake = [Belief(0.3, RIGHT), Belief(0.6, WRONG)]
    nothing: list[Belief] = []
    episodes = [early_mistake, late_mistake, nothing]
    assert share_right_first(episodes, 0.2) == pytest.approx(1 / 3)
    assert share_right_first(episodes[:1], 0.5) == 1.0 and share_right_first(episodes[1:2], 0.5) == 0.0
    assert share_right_first(episodes, 0.7) == 0.0


def test_the_threshold_lies_in_the_middle_of_those_that_are_best() -> None:
    one = {role: [Belief(0.3, WRONG), Belief(0.7, RIGHT)] for role in ClassRole}
    two = {role: [Belief(0.4, WRONG), Belief(0.8, RIGHT)] for role in ClassRole}
    found = best_thresholds([one, two])
    for role in ClassRole:
        threshold, share = found[role]
        assert share == 1.0 and threshold == pytest.approx(0.55, abs=0.03)


def test_fitted_thresholds_take_the_place_of_the_packages_and_fall_as_they_do(tmp_path: Path) -> None:
    write_thresholds(tmp_path / "thresholds.json", {role: (0.2 + 0.1 * role, 0.9) for role in ClassRole})
    fitted = read_thresholds(tmp_path / "thresholds.json")
    assert [fitted.by_role[role] for role in ClassRole] == pytest.approx([0.2, 0.3, 0.4])
    assert fitted.falls == read_thresholds().falls and fitted.falls
