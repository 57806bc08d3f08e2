"""What things are taken for over several views: one frame's mistake is outvoted, and each thing keeps to itself."""

import math

import numpy as np
import pytest
from worlds.box_world import Box, observe
from worlds.filled import filled

from uniteam.geometry import BasePose
from uniteam.interface import Detection, Instruction, Observation, Segmentation
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.perception.filters import ScoreFilter, Thresholds
from uniteam.mind.perception.instance_memory import InstanceMemory, Remember, forget_instances

INSTRUCTION = Instruction("cup", "table", "bed")
LEFT = Box((1.4, 0.4, 0.0), (1.8, 0.9, 0.7), "left")
RIGHT = Box((1.4, -0.9, 0.0), (1.8, -0.4, 0.7), "right")
HERE = BasePose(0.0, 0.0, 0.0)


def around(angle: float) -> BasePose:
    """Return a stand 1.6 m from the boxes' middle, turned around it by an angle (rad) and facing it."""
    x, y = 1.6 - 1.6 * math.cos(angle), 1.6 * math.sin(angle)
    return BasePose(x, y, -angle)


def seen(base: BasePose, **scores: tuple[tuple[str, float], ...]) -> tuple[Segmentation, Observation]:
    """Return what a stand shows of the boxes, each with candidates of its own."""
    observation = observe((LEFT, RIGHT), base)
    truth = observation.truth
    assert truth is not None
    detections = tuple(Detection(scores[detection.name]) for detection in truth.detections)
    return Segmentation(truth.instances, detections), observation


def score_of(memory: Remember, base: BasePose, name: str, **scores: tuple[tuple[str, float], ...]) -> float:
    """Return what is believed of the left box once a frame has been remembered."""
    segmentation, observation = seen(base, **scores)
    believed = memory(segmentation, observation, INSTRUCTION)
    index = next(i for i, d in enumerate(segmentation.detections) if d.candidates == scores["left"])
    return dict(believed.detections[index].candidates)[name]


def test_a_first_look_says_what_the_detector_says() -> None:
    score = score_of(InstanceMemory()(), HERE, "table", left=(("table", 0.4),), right=(("table", 0.1),))
    assert score == pytest.approx(0.4)


def test_views_that_agree_make_it_surer_and_frames_of_one_view_do_not() -> None:
    frame = {"left": (("table", 0.4),), "right": (("table", 0.02),)}
    memory = InstanceMemory()()
    alone = [score_of(memory, HERE, "table", **frame) for _ in range(4)]
    assert alone == pytest.approx([0.4] * 4)
    more = [score_of(memory, around(angle), "table", **frame) for angle in (0.8, -0.8)]
    assert 0.4 < more[0] < more[1] < 1.0


def test_one_frame_that_is_wrong_is_outvoted() -> None:
    memory = InstanceMemory()()
    for angle in (0.6, 0.0):
        score_of(memory, around(angle), "bed", left=(("bed", 0.03),), right=(("bed", 0.03),))
    score = score_of(memory, around(-0.6), "bed", left=(("bed", 0.8),), right=(("bed", 0.03),))
    assert score < 0.5
    alone = score_of(InstanceMemory()(), around(-0.6), "bed", left=(("bed", 0.8),), right=(("bed", 0.03),))
    assert alone == pytest.approx(0.8)


def test_the_likelier_name_of_all_views_comes_first() -> None:
    memory = InstanceMemory()()
    for angle in (0.6, 0.0):
        score_of(
            memory, around(angle), "bed", left=(("table", 0.7), ("bed", 0.1)), right=(("table", 0.1), ("bed", 0.1))
        )
    wavering = seen(around(-0.6), left=(("bed", 0.5), ("table", 0.4)), right=(("bed", 0.1), ("table", 0.1)))
    believed = memory(*wavering, INSTRUCTION)
    assert {d.name for d in believed.detections if d.score > 0.3} == {"table"}


def test_things_beside_each_other_keep_apart() -> None:
    memory = InstanceMemory()()
    for angle in (0.5, 0.0, -0.5):
        left = score_of(memory, around(angle), "table", left=(("table", 0.9),), right=(("table", 0.02),))
    assert left > 0.9
    swapped, observation = seen(HERE, left=(("table", 0.5),), right=(("table", 0.5),))
    believed = memory(swapped, observation, INSTRUCTION)
    assert sorted(round(d.score, 1) for d in believed.detections)[0] < 0.3


def test_what_was_certain_stays_so_whatever_else_is_seen() -> None:
    memory = InstanceMemory()()
    for angle in (0.5, 0.0):
        score_of(memory, around(angle), "table", left=(("table", 1.0),), right=(("table", 1.0),))
    assert score_of(memory, around(-0.5), "table", left=(("table", 1.0),), right=(("table", 0.2),)) == 1.0


def test_an_object_does_not_become_the_receptacle_it_touches() -> None:
    memory = InstanceMemory()()
    score_of(memory, HERE, "table", left=(("table", 0.9),), right=(("table", 0.1),))
    segmentation, observation = seen(HERE, left=(("cup", 0.2),), right=(("cup", 0.2),))
    believed = memory(segmentation, observation, INSTRUCTION)
    for detection in filled(believed.detections):
        assert detection.candidates == (("cup", pytest.approx(0.2)),)


def test_a_small_object_is_told_by_each_frame_alone() -> None:
    memory = InstanceMemory()()
    for angle in (0.6, 0.0):
        score_of(memory, around(angle), "cup", left=(("cup", 0.02),), right=(("cup", 0.02),))
    assert score_of(memory, around(-0.6), "cup", left=(("cup", 0.6),), right=(("cup", 0.02),)) == 0.6


def test_what_is_small_in_view_says_little() -> None:
    far, near = BasePose(-8.0, 0.3, 0.0), HERE
    beliefs = []
    for memory in (InstanceMemory()(), InstanceMemory(clear=1e-6)()):
        score_of(memory, far, "bed", left=(("bed", 0.02),), right=(("bed", 0.02),))
        beliefs.append(score_of(memory, near, "bed", left=(("bed", 0.6),), right=(("bed", 0.02),)))
    assert beliefs[1] < 0.3 < 0.4 < beliefs[0] < 0.6


def test_the_switch_is_what_makes_an_agent_remember() -> None:
    assert BASELINE.remember is forget_instances
    frame = seen(HERE, left=(("table", 0.4),), right=(("table", 0.1),))
    assert BASELINE.remember()(*frame, INSTRUCTION) is frame[0]
    with_memory = improved(BASELINE, ["instance_memory"])
    believe, memory = ScoreFilter(Thresholds.single(0.45)), with_memory.remember()
    counts = []
    for angle in (0.8, 0.0, -0.8):
        segmentation, observation = seen(around(angle), left=(("table", 0.4),), right=(("table", 0.02),))
        counts.append(len(believe(memory(segmentation, observation, INSTRUCTION), observation, INSTRUCTION).detections))
    assert counts == [0, 1, 1]


def test_detections_without_depth_are_left_as_they_are() -> None:
    segmentation, observation = seen(HERE, left=(("table", 0.4),), right=(("table", 0.1),))
    blind = Observation(**{**vars(observation), "depth": np.zeros_like(observation.depth)})
    assert InstanceMemory()()(segmentation, blind, INSTRUCTION).detections == segmentation.detections
