"""Figures of perception from what was seen: proposals, recall and precision as asked, receptacles, calibration."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.training.sightings import Answer, Present, Sightings
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES

BINS = ((400, 1 << 30), (100, 400))
"""Pixels in view at half size: from, to (excluded)."""
_ECE_BINS = 10


@dataclass(frozen=True)
class AskedFigures:
    """How well what is asked for is found.

    Attributes:
        there: how many things there were to be found.
        threshold: of the score, at which the figures are.
        recall: share of what was there that was found.
        precision: share of what was said that was right.
    """

    there: int
    threshold: float
    recall: float
    precision: float


def proposal_recall(present: Sequence[Present], role: str, low: int, high: int, overlap: float) -> tuple[int, float]:
    """Return how many things of a role and a size there were, and the share that a region overlaps so well."""
    own = [p.overlap >= overlap for p in present if p.thing.role == role and low <= p.pixels < high]
    return len(own), float(np.mean(own)) if own else float("nan")


def asked_figures(
    sightings: Sightings, role: str, low: int, high: int, is_of_group: Callable[[str], bool], least_precision: float
) -> AskedFigures:
    """Return the figures at the threshold with the highest recall at which precision is at least so high.

    Args:
        sightings: of perception.
        role: "object" or "receptacle".
        low, high: pixels in view; of what was there, and of the regions.
        is_of_group: whether a category belongs to the group that is reported.
        least_precision: what is asked of precision; 0 for the threshold of the best F1.
    """
    present = {(p.frame, p.index): p for p in sightings.present if _belongs(p.thing.role == role, p.pixels, low, high)}
    present = {key: p for key, p in present.items() if is_of_group(p.thing.category)}
    answers = [a for a in sightings.answers if _belongs(a.role == role, a.pixels, low, high) and is_of_group(a.word)]
    answers.sort(key=lambda a: -a.score)
    curve = _curve(answers, present.keys(), _found_anywhere(sightings.answers, role, is_of_group))
    return _best_point(curve, len(present), least_precision)


Curve = list[tuple[float, float, float]]


def _found_anywhere(
    answers: Iterable[Answer], role: str, is_of_group: Callable[[str], bool]
) -> dict[tuple[int, int], float]:
    """Return the best score with which each thing was found, whatever the size of the region."""
    best: dict[tuple[int, int], float] = {}
    for answer in answers:
        if answer.role == role and answer.is_right and is_of_group(answer.word):
            key = (answer.frame, answer.index)
            best[key] = max(best.get(key, 0.0), answer.score)
    return best


def _curve(answers: Sequence[Answer], present: Iterable[tuple[int, int]], found: dict[tuple[int, int], float]) -> Curve:
    """Return (threshold, recall, precision) at each score."""
    wanted = list(present)
    scores = np.array([a.score for a in answers])
    right = np.cumsum([a.is_right for a in answers])
    best = np.sort([found.get(key, 0.0) for key in wanted])
    curve = []
    for number in range(len(answers)):
        if number + 1 == len(answers) or scores[number + 1] < scores[number]:
            recall = float(np.mean(best >= scores[number])) if wanted else float("nan")
            curve.append((float(scores[number]), recall, float(right[number] / (number + 1))))
    return curve


def _best_point(curve: Curve, there: int, least_precision: float) -> AskedFigures:
    if least_precision > 0.0:
        good = [point for point in curve if point[2] >= least_precision]
        key: Callable[[tuple[float, float, float]], float] = lambda point: point[1]  # noqa: E731
    else:
        good, key = curve, lambda point: 2 * point[1] * point[2] / max(point[1] + point[2], 1e-9)
    if not good:
        return AskedFigures(there, 1.0, 0.0, float("nan"))
    return AskedFigures(there, *max(good, key=key))


def figures_at(sightings: Sightings, role: str, low: int, high: int, threshold: float) -> AskedFigures:
    """Return the figures of all categories at a threshold."""
    present = [p for p in sightings.present if _belongs(p.thing.role == role, p.pixels, low, high)]
    found = _found_anywhere(sightings.answers, role, lambda word: True)
    said = [a for a in sightings.answers if _belongs(a.role == role, a.pixels, low, high) and a.score >= threshold]
    recall = float(np.mean([found.get((p.frame, p.index), 0.0) >= threshold for p in present])) if present else 0.0
    return AskedFigures(len(present), threshold, recall, float(np.mean([a.is_right for a in said])) if said else 0.0)


def receptacle_overlaps(pixels: NDArray[np.int64]) -> dict[str, float]:
    """Return each receptacle's intersection over union by pixels; those that were never there are left out."""
    hits = np.diag(pixels).astype(np.float64)
    unions = pixels.sum(axis=0) + pixels.sum(axis=1) - hits
    there = pixels.sum(axis=1) > 0
    return {n: float(hits[k] / unions[k]) for k, n in enumerate(RECEPTACLE_CATEGORIES) if there[k]}


def worst_confusions(pixels: NDArray[np.int64], count: int = 12) -> list[tuple[str, str, float]]:
    """Return (true name, what was said, share of the true pixels) of the largest confusions."""
    names = [*RECEPTACLE_CATEGORIES, "nothing"]
    shares = pixels / np.maximum(pixels.sum(axis=1, keepdims=True), 1)
    pairs = [
        (names[i], names[j], float(shares[i, j])) for i in range(len(names) - 1) for j in range(len(names)) if i != j
    ]
    return sorted(pairs, key=lambda pair: -pair[2])[:count]


def calibration_error(answers: Sequence[Answer], role: str) -> tuple[float, list[tuple[float, float, int]]]:
    """Return the expected calibration error of a role's scores, and (mean score, share right, count) a bin.

    Naeini et al., "Obtaining well calibrated probabilities using Bayesian binning" (AAAI 2015): tenths of the score.
    """
    own = [a for a in answers if a.role == role]
    scores, right = np.array([a.score for a in own]), np.array([a.is_right for a in own], dtype=np.float64)
    bins = np.minimum((scores * _ECE_BINS).astype(int), _ECE_BINS - 1)
    rows = [
        (float(scores[bins == b].mean()), float(right[bins == b].mean()), int((bins == b).sum()))
        for b in range(_ECE_BINS)
        if (bins == b).any()
    ]
    total = max(1, len(own))
    return sum(abs(score - share) * count for score, share, count in rows) / total, rows


def _belongs(is_of_role: bool, pixels: int, low: int, high: int) -> bool:
    return is_of_role and low <= pixels < high
