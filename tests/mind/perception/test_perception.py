"""What perception believes, and what the filters leave of it."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from worlds.box_world import Box, observe

from uniteam.errors import DamagedFileError, InvalidInputError, UnknownNameError
from uniteam.geometry import BasePose
from uniteam.interface import Detection, Instruction, Observation, Segmentation
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.perception.filters import FloorFilter, ScoreFilter, Thresholds, percentile_reaches
from uniteam.mind.perception.registry import make_perception
from uniteam.mind.perception.threshold_file import read_thresholds
from uniteam.mind.perception.truth import visible_truth
from uniteam.mind.perception.vocabulary import ClassRole, roles_of

INSTRUCTION = Instruction("cup", "table", "bed")
TABLE = Box((1.0, -0.5, 0.0), (1.6, 0.5, 0.7), "table")


def names(segmentation: Segmentation) -> list[str]:
    return [detection.name for detection in segmentation.detections]


def with_candidates(*candidates: tuple[tuple[str, float], ...]) -> tuple[Segmentation, Observation]:
    """Return a frame with a detection a column, and the empty room it is from."""
    observation = observe((), BasePose(0.0, 0.0, 0.0))
    instances = np.full(observation.depth.shape, -1, dtype=np.int16)
    for index in range(len(candidates)):
        instances[:, index] = index
    return Segmentation(instances, tuple(Detection(c) for c in candidates)), observation


def believed(config_filters: tuple, segmentation: Segmentation, observation: Observation) -> Segmentation:
    for believe in config_filters:
        segmentation = believe(segmentation, observation, INSTRUCTION)
    return segmentation


def test_truth_leaves_out_what_covers_fewer_than_twenty_pixels() -> None:
    observation = observe((TABLE,), BasePose(0.0, 0.0, 0.0))
    truth = observation.truth
    assert truth is not None
    instances = truth.instances.copy()
    instances[0, :19], instances[1, :20] = 1, 2
    crowded = Segmentation(instances, (*truth.detections, Detection((("pen", 1.0),)), Detection((("fork", 1.0),))))
    far = observation.depth.copy()
    far[:2] = 5.0
    seen = visible_truth(_changed(observation, truth=crowded, depth=far))
    assert names(seen) == ["table", "fork"]
    assert seen.instances[1, 0] == 1 and seen.instances[0, 0] == -1
    assert seen.detections[0].score == 1.0 and seen.detections[0].embedding is None


def test_truth_leaves_out_what_is_beyond_the_depth_cameras_range() -> None:
    observation = observe((TABLE,), BasePose(0.0, 0.0, 0.0))
    blind = _changed(observation, depth=np.zeros_like(observation.depth))
    assert visible_truth(blind).detections == ()


def test_truth_is_asked_for_and_missing() -> None:
    observation = _changed(observe((TABLE,), BasePose(0.0, 0.0, 0.0)), truth=None)
    with pytest.raises(InvalidInputError, match="give_truth"):
        visible_truth(observation)


def test_a_misspelt_perception_is_answered_with_the_nearest() -> None:
    with pytest.raises(UnknownNameError, match="did you mean 'truth'"):
        make_perception("truht")


def test_the_baseline_believes_everything_from_0_45() -> None:
    segmentation, observation = with_candidates((("cup", 0.46),), (("cup", 0.44),), (("bed", 0.45),))
    assert names(believed(BASELINE.filters, segmentation, observation)) == ["cup", "bed"]


def test_class_thresholds_find_a_faint_object_that_one_threshold_misses_and_doubt_a_goal_receptacle() -> None:
    segmentation, observation = with_candidates((("cup", 0.38),), (("bed", 0.5),), (("table", 0.5),))
    better = improved(BASELINE, {"class_thresholds"})
    assert names(believed(BASELINE.filters, segmentation, observation)) == ["bed", "table"]
    assert names(believed(better.filters, segmentation, observation)) == ["cup", "table"]


def test_a_threshold_of_a_class_goes_before_that_of_its_role() -> None:
    thresholds = Thresholds(read_thresholds().by_role, 0.45, {"cup": 0.8})
    assert thresholds.of("cup", INSTRUCTION) == 0.8
    assert thresholds.of("cup", Instruction("bowl", "table", "bed")) == 0.8
    assert thresholds.of("lamp", INSTRUCTION) == 0.45


def test_thresholds_are_read_from_a_file_by_role_and_by_class(tmp_path: Path) -> None:
    file = tmp_path / "thresholds.json"
    by_role = {"object": 0.3, "start_receptacle": 0.4, "goal_receptacle": 0.5}
    file.write_text(json.dumps({"by_role": by_role, "other": 0.6, "by_class": {"spoon": 0.2}}))
    thresholds = read_thresholds(file)
    assert [thresholds.of(name, INSTRUCTION) for name in ("cup", "table", "bed", "lamp", "spoon")] == [
        0.3,
        0.4,
        0.5,
        0.6,
        0.2,
    ]


def test_thresholds_fall_while_the_search_goes_on_and_no_further(tmp_path: Path) -> None:
    file = tmp_path / "thresholds.json"
    by_role = {"object": 0.4, "start_receptacle": 0.4, "goal_receptacle": 0.4}
    falls = {"object": {"first_step": 200, "last_step": 600, "to": 0.5}}
    file.write_text(json.dumps({"by_role": by_role, "other": 0.6, "by_class": {"spoon": 0.8}, "falls": falls}))
    thresholds = read_thresholds(file)
    shares = [thresholds.of("cup", INSTRUCTION, step) / 0.4 for step in (0, 200, 400, 600, 1_250)]
    assert shares == pytest.approx([1.0, 1.0, 0.75, 0.5, 0.5])
    assert thresholds.of("spoon", Instruction("spoon", "table", "bed"), 1_000) == pytest.approx(0.4)
    assert [thresholds.of(name, INSTRUCTION, 1_000) for name in ("spoon", "table", "lamp")] == [0.8, 0.4, 0.6]
    segmentation, observation = with_candidates((("cup", 0.3),))
    late = replace(observation, step=500)
    assert names(ScoreFilter(thresholds)(segmentation, observation, INSTRUCTION)) == []
    assert names(ScoreFilter(thresholds)(segmentation, late, INSTRUCTION)) == ["cup"]


GOOD = '"by_role": {"object": 0.3, "start_receptacle": 0.3, "goal_receptacle": 0.3}, "other": 0.4, "by_class": {}'


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (f'{{{GOOD}, "falls": {{"object": {{"first_step": 9, "last_step": 9, "to": 0.5}}}}}}', "a 'last_step' after"),
        (
            f'{{{GOOD}, "falls": {{"object": {{"first_step": 9, "last_step": 10, "to": 2}}}}}}',
            "how thresholds fall: .*<= 1",
        ),
        (f'{{{GOOD}, "falls": {{"lamp": 3}}}}', "how thresholds fall"),
        ("{", "cannot be read"),
        ("[]", "'by_role'"),
        ('{"by_role": {"object": 0.3}, "other": 0.4, "by_class": {}}', "goal_receptacle, object, start_receptacle"),
        ('{"by_role": {"object": 2, "start_receptacle": 0, "goal_receptacle": 0}}', r"'object' a score in \[0, 1\]"),
    ],
)
def test_a_damaged_file_of_thresholds_is_refused_in_a_sentence(tmp_path: Path, text: str, words: str) -> None:
    file = tmp_path / "thresholds.json"
    file.write_text(text)
    with pytest.raises(DamagedFileError, match=words):
        read_thresholds(file)


def test_a_doubtful_first_name_gives_way_to_a_second_that_is_believed() -> None:
    receptacles = {ClassRole.START_RECEPTACLE: 0.9, ClassRole.GOAL_RECEPTACLE: 0.9}
    thresholds = Thresholds({ClassRole.OBJECT: 0.3, **receptacles}, 0.9)
    segmentation, observation = with_candidates((("table", 0.5), ("cup", 0.4)), (("lamp", 0.95), ("cup", 0.5)))
    left = ScoreFilter(thresholds)(segmentation, observation, INSTRUCTION)
    assert names(left) == ["cup", "lamp"]
    assert roles_of(left.detections[0], INSTRUCTION) == (ClassRole.OBJECT,)
    assert roles_of(left.detections[1], INSTRUCTION) == ()


def test_a_class_that_is_start_and_goal_has_both_roles_and_the_lower_threshold() -> None:
    same = Instruction("cup", "table", "table")
    assert roles_of(Detection((("table", 1.0),)), same) == (ClassRole.START_RECEPTACLE, ClassRole.GOAL_RECEPTACLE)
    shipped = read_thresholds()
    lower = min(shipped.by_role[ClassRole.START_RECEPTACLE], shipped.by_role[ClassRole.GOAL_RECEPTACLE])
    assert shipped.of("table", same) == lower < 1.0


def test_floor_filter_drops_what_lies_on_the_floor_and_keeps_what_stands_on_furniture() -> None:
    boxes = (
        TABLE,
        Box((1.2, -0.3, 0.7), (1.28, -0.22, 0.8), "cup"),
        Box((1.4, 0.8, 0.0), (1.48, 0.88, 0.1), "cup"),
        Box((2.0, 1.0, 0.0), (2.6, 1.6, 0.05), "bed"),
        Box((2.5, -1.2, 0.0), (3.4, -0.7, 0.5), "bed"),
        Box((0.5, 0.1, 0.0), (0.8, 0.3, 0.02), "rug"),
    )
    observation = observe(boxes, BasePose(-0.6, 0.0, 0.0))
    seen = visible_truth(observation)
    assert names(seen) == ["table", "cup", "cup", "bed", "bed", "rug"]
    left = FloorFilter()(seen, observation, INSTRUCTION)
    assert names(left) == ["table", "cup", "bed", "rug"]
    kept = [left.detections[i].name for i in np.unique(left.instances) if i >= 0]
    assert sorted(kept) == ["bed", "cup", "rug", "table"]
    assert names(believed(BASELINE.filters, seen, observation)) == names(seen)
    better = improved(BASELINE, {"floor_filter"})
    assert names(believed(better.filters, seen, observation)) == names(left)


@pytest.mark.parametrize("percent", [5, 50, 95])
def test_whether_a_percentile_reaches_a_bound_is_what_the_percentile_says(percent: int) -> None:
    generator = np.random.default_rng(percent)
    for size in (1, 2, 3, 20, 21, 400):
        for _ in range(40):
            heights = np.round(generator.random(size, dtype=np.float32), 2)
            near = float(np.percentile(heights, percent))
            for bound in (near, near - 0.003, near + 0.003, float(generator.random())):
                expected = bool(np.percentile(heights, percent) >= bound)
                assert percentile_reaches(heights, percent, bound) == expected, (heights, bound)


def _changed(observation: Observation, **changes: object) -> Observation:
    return Observation(**{**vars(observation), **changes})
