"""What the dial does to what is seen: nothing at 0, and more of the same as it is turned up."""

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
from worlds.box_world import Box, observe
from worlds.filled import filled

from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose, transform_points
from uniteam.interface import Instruction, Observation, Segmentation
from uniteam.mind.perception.filters import FloorFilter
from uniteam.mind.perception.noise.confusions import LOOK_ALIKES, look_alikes
from uniteam.mind.perception.noise.noisy import NoisyPerception
from uniteam.mind.perception.noise.ragged import ragged
from uniteam.mind.perception.noise.random_field import RandomField, as_share
from uniteam.mind.perception.noise.rates import DETECTOR, Rates
from uniteam.mind.perception.registry import make_perception, needs_truth
from uniteam.mind.perception.truth import visible_truth

INSTRUCTION = Instruction("cup", "table", "bed")
TABLE = Box((1.0, -0.5, 0.0), (1.6, 0.5, 0.7), "table")
CUP = Box((1.2, -0.05, 0.7), (1.3, 0.05, 0.82), "cup")
FRAME = observe((TABLE, CUP), BasePose(-0.6, 0.0, 0.0))
SEEDS = range(200)
FLAWLESS = Rates(
    missed=0.0, missed_small=0.0, missed_far=0.0, confused=0.0, floor=0.0, ragged=0.0, right_logit=40.0, spread=0.0,
    bias=0.0,
)  # fmt: skip


def seen_by(level: float, seed: int, frame: Observation = FRAME, rates: Rates = DETECTOR) -> Segmentation:
    """Return what a perception sees in a frame."""
    perception = NoisyPerception(level, rates)
    perception.reset(INSTRUCTION, seed)
    return perception.perceive(frame)


def names(segmentation: Segmentation) -> list[str]:
    return [detection.name for detection in segmentation.detections]


def same(one: Segmentation, other: Segmentation) -> bool:
    return np.array_equal(one.instances, other.instances) and one.detections == other.detections


def test_level_0_is_the_truth_to_the_bit() -> None:
    assert all(same(seen_by(0.0, seed), visible_truth(FRAME)) for seed in range(10))
    assert same(make_perception("noisy:0").perceive(FRAME), visible_truth(FRAME))


def test_rates_of_nothing_leave_the_truth_but_for_the_last_bits_of_a_score() -> None:
    seen = seen_by(1.0, 3, rates=FLAWLESS)
    assert np.array_equal(seen.instances, visible_truth(FRAME).instances)
    assert names(seen) == ["table", "cup"]
    assert min(detection.score for detection in seen.detections) > 1.0 - 1e-12


def test_what_is_seen_is_a_function_of_the_seed_and_the_frame() -> None:
    again = NoisyPerception(1.0)
    again.reset(INSTRUCTION, 7)
    again.perceive(observe((TABLE,), BasePose(-1.0, 0.3, 0.2)))
    assert same(again.perceive(FRAME), seen_by(1.0, 7))
    assert any(not same(seen_by(1.0, 7), seen_by(1.0, seed)) for seed in range(8, 12))


def test_what_is_missed_at_one_level_is_missed_at_every_higher_one() -> None:
    rates = replace(FLAWLESS, missed=0.9)
    levels = (0.0, 0.25, 0.5, 0.75, 1.0)
    counts = np.array([[len(seen_by(level, seed, rates=rates).detections) for level in levels] for seed in range(40)])
    assert (np.diff(counts, axis=1) <= 0).all()
    assert (np.diff(counts.sum(axis=0)) < 0).all()


def share_missed(frame: Observation, rates: Rates = DETECTOR) -> float:
    """Return how often the cup of a frame is missed, over many seeds."""
    rates = replace(rates, confused=0.0)
    return sum("cup" not in names(seen_by(1.0, seed, frame, rates)) for seed in SEEDS) / len(SEEDS)


def test_what_is_small_or_far_is_missed_more_often_and_about_as_often_as_the_rates_say() -> None:
    far = observe((TABLE, CUP), BasePose(-2.4, 0.0, 0.0))
    pixels = [int((frame.truth.instances == 1).sum()) for frame in (FRAME, far) if frame.truth is not None]
    assert pixels[0] > 300 > pixels[1] >= 20
    assert share_missed(far) > share_missed(FRAME) + 0.08
    for only in (replace(FLAWLESS, missed_small=0.6), replace(FLAWLESS, missed_far=0.6, half_far=2.0)):
        assert share_missed(far, only) > share_missed(FRAME, only) + 0.1
    assert share_missed(FRAME, replace(FLAWLESS, missed=0.4)) == pytest.approx(0.4, abs=0.1)


def test_the_same_thing_is_often_missed_again_from_another_place_and_a_far_one_is_not() -> None:
    rates = replace(FLAWLESS, missed=0.5)
    from_elsewhere = observe((TABLE, CUP), BasePose(-0.1, 0.6, -0.3))
    another = observe((Box((1.0, 4.5, 0.0), (1.6, 5.5, 0.7), "table"),), BasePose(-0.6, 5.0, 0.0))

    def agreement(frame: Observation) -> float:
        here = ["table" in names(seen_by(1.0, seed, rates=rates)) for seed in SEEDS]
        there = ["table" in names(seen_by(1.0, seed, frame, rates)) for seed in SEEDS]
        return float(np.mean(np.array(here) == np.array(there)))

    assert agreement(from_elsewhere) > 0.65
    assert agreement(another) == pytest.approx(0.5, abs=0.12)


def test_a_thing_is_taken_for_what_looks_like_it_and_first_for_what_is_asked_for() -> None:
    rates = replace(FLAWLESS, confused=1.0, wrong_logit=40.0)
    stranger = observe((Box((1.0, -0.5, 0.0), (1.6, 0.5, 0.7), "counter"),), BasePose(-0.6, 0.0, 0.0))
    assert {name for seed in range(20) for name in names(seen_by(1.0, seed, stranger, rates))} == {"table"}
    taken_for = Counter(name for seed in range(60) for name in names(seen_by(1.0, seed, FRAME, rates)))
    assert set(taken_for) <= {*look_alikes("table"), *look_alikes("cup")}
    assert len(taken_for) > 4
    first = seen_by(1.0, 0, stranger, rates).detections[0]
    assert [name for name, _ in first.candidates] == ["table", "counter"]


def test_look_alikes_are_mutual_and_a_name_that_is_in_no_group_is_taken_for_nothing() -> None:
    everything = {name for group in LOOK_ALIKES for name in group}
    assert all(name in look_alikes(other) for name in filled(everything) for other in filled(look_alikes(name)))
    assert all(name not in look_alikes(name) for name in filled(everything))
    assert look_alikes("hovercraft") == ()


def test_patches_of_floor_are_taken_for_the_receptacles_stay_where_they_are_and_fall_to_the_floor_filter() -> None:
    rates = replace(FLAWLESS, floor=0.2, wrong_logit=40.0)
    found = 0
    wall = Box((2.5, -3.0, 0.0), (2.6, 3.0, 2.5))
    walled = observe((TABLE, CUP, wall), BasePose(-0.6, 0.0, 0.0))
    for seed in range(10):
        seen = seen_by(1.0, seed, walled, rates)
        patches = [i for i, name in enumerate(names(seen)) if i >= 2]
        assert {seen.detections[i].name for i in patches} <= {"table", "bed"}
        assert names(FloorFilter()(seen, walled, INSTRUCTION)) == ["table", "cup"]
        heights = transform_points(walled.camera_to_start, walled.camera.unproject(walled.depth))[..., 2]
        assert np.abs(heights[np.isin(seen.instances, patches)]).max(initial=0.0) < 0.2
        found += len(patches)
    assert found >= 5


def test_less_of_the_floor_is_taken_for_furniture_at_a_lower_level() -> None:
    def area(level: float) -> int:
        rates = replace(FLAWLESS, floor=0.2)
        return sum(int((seen_by(level, seed, rates=rates).instances >= 2).sum()) for seed in range(10))

    assert 0 < area(0.3) < area(1.0)


def test_ragged_masks_differ_from_the_truth_near_their_edges_only() -> None:
    instances = np.full((320, 240), -1, np.int16)
    instances[80:240, 60:180] = 0
    edged = ragged(instances, 3.0, np.random.default_rng(0))
    changed = edged != instances
    assert 100 < changed.sum() < 4000
    assert not changed[100:220, 80:160].any() and not changed[:60].any()


def test_scores_fall_as_the_level_rises_and_differ_from_name_to_name() -> None:
    rates = replace(FLAWLESS, right_logit=1.0, bias=1.0)
    by_level = [[d.score for s in range(40) for d in seen_by(level, s, rates=rates).detections] for level in (0.3, 1.0)]
    assert all(low > high for low, high in filled(zip(*by_level, strict=True)))
    gaps = [one - other for one, other in zip(by_level[1][::2], by_level[1][1::2], strict=True)]
    assert np.std(gaps) > 0.1


def test_a_field_is_standard_normal_at_a_point_and_smooth() -> None:
    values = [
        RandomField(seed, "any", (1.0, 1.0))(np.array([[0.0, 0.0], [0.1, 0.0], [5.0, 5.0]])) for seed in range(500)
    ]
    here, near, far = np.array(values).T
    assert abs(here.mean()) < 0.15 and 0.85 < here.std() < 1.15
    assert np.corrcoef(here, near)[0, 1] > 0.95 and abs(np.corrcoef(here, far)[0, 1]) < 0.15
    assert np.mean([as_share(v) for v in here]) == pytest.approx(0.5, abs=0.05)


@pytest.mark.parametrize("argument", ["1.5", "-0.1", "nan", "inf", "high", "0,5", "0.5:1"])
def test_a_level_that_is_none_is_refused_in_a_sentence(argument: str) -> None:
    with pytest.raises(InvalidInputError, match=r"needs a level from 0 .* got '"):
        make_perception(f"noisy:{argument}")


@pytest.mark.parametrize("name", ["noisy", "noisy:"])
def test_a_missing_level_is_asked_for(name: str) -> None:
    with pytest.raises(InvalidInputError, match=r"'noisy' needs LEVEL after a colon, such as noisy:0\.6"):
        make_perception(name)


def test_every_level_is_shown_the_truth() -> None:
    assert needs_truth("noisy:0.25")
