"""The figures of perception and its calibration, on answers made by hand."""

import numpy as np
import pytest

from uniteam.training.calibration import fit_calibration, isotonic, weight_of
from uniteam.training.figures import (
    asked_figures,
    calibration_error,
    proposal_recall,
    receptacle_overlaps,
    worst_confusions,
)
from uniteam.training.namer_data import is_held_out
from uniteam.training.records import Thing
from uniteam.training.sightings import Answer, Present, Sightings

NEW = next(f"model_{k}" for k in range(99) if is_held_out(f"model_{k}"))
KNOWN = next(f"model_{k}" for k in range(99) if not is_held_out(f"model_{k}"))
CUP = Thing("object", "cup", NEW)


def answer(frame: int, score: float, matched: Thing | None, word: str = "cup", index: int = 0) -> Answer:
    return Answer(frame, word, "object", score, score, 500, matched, index if matched else -1)


def test_recall_and_precision_are_those_at_the_threshold() -> None:
    present = [Present(frame, 0, CUP, 500, 0.6) for frame in range(4)]
    answers = [
        answer(0, 0.9, CUP),
        answer(1, 0.8, CUP),
        answer(2, 0.7, None),
        answer(2, 0.6, CUP),
        answer(3, 0.1, None),
    ]
    sightings = Sightings(present, answers, frames=4)
    best = asked_figures(sightings, "object", 400, 1000, lambda name: True, 0.9)
    assert (best.there, best.threshold, best.recall, best.precision) == (4, 0.8, 0.5, 1.0)
    loose = asked_figures(sightings, "object", 400, 1000, lambda name: True, 0.5)
    assert (loose.threshold, loose.recall, loose.precision) == (0.6, 0.75, 0.75)
    assert asked_figures(sightings, "object", 400, 1000, lambda name: name == "mug", 0.5).there == 0
    assert proposal_recall(present, "object", 400, 1000, 0.5) == (4, 1.0)
    assert proposal_recall(present, "object", 400, 1000, 0.7) == (4, 0.0)


def test_another_thing_of_the_right_place_is_wrong() -> None:
    bowl = Thing("object", "bowl", NEW)
    assert not answer(0, 0.9, bowl).is_right
    assert answer(0, 0.9, CUP).is_right


def test_overlaps_and_confusions_of_receptacles() -> None:
    pixels = np.zeros((22, 22), dtype=np.int64)
    pixels[0, 0], pixels[0, 1], pixels[1, 1] = 60, 40, 100
    overlaps = receptacle_overlaps(pixels)
    assert overlaps == {"bathtub": pytest.approx(0.6), "bed": pytest.approx(100 / 140)}
    assert worst_confusions(pixels)[0] == ("bathtub", "bed", pytest.approx(0.4))


def test_what_is_said_with_certainty_and_is_wrong_is_an_error() -> None:
    assert calibration_error([answer(0, 0.95, None)] * 10, "object")[0] == pytest.approx(0.95)
    fair = [answer(k, 0.5, CUP if k % 2 else None) for k in range(10)]
    assert calibration_error(fair, "object")[0] == pytest.approx(0.0)


def test_the_isotonic_fit_pools_what_falls() -> None:
    fitted = isotonic(np.array([0.0, 1.0, 0.0, 1.0]), np.array([1.0, 1.0, 3.0, 1.0]))
    assert fitted == pytest.approx([0.0, 0.25, 0.25, 1.0])


def test_calibration_is_of_models_that_were_held_out() -> None:
    assert weight_of(answer(0, 0.5, Thing("object", "cup", KNOWN))) == 0.0
    assert weight_of(answer(0, 0.5, CUP)) == 1.0
    assert weight_of(answer(0, 0.5, None)) == pytest.approx(1 / 7)
    rng = np.random.default_rng(0)
    bowl = Thing("object", "bowl", NEW)
    scores = rng.random(4000)
    answers = [answer(0, float(s), CUP if rng.random() < s**2 else bowl) for s in scores]
    points, chances = fit_calibration(answers, "object")
    assert np.interp([0.3, 0.6, 0.9], points, chances) == pytest.approx([0.09, 0.36, 0.81], abs=0.08)
