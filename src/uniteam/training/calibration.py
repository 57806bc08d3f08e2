"""What scores are worth, and which to believe: fitted on training homes, with models that no network has seen.

Of what was seen in training homes, the things of held-out models and what is no thing count, the latter by the share of
models that is held out, so that right and wrong come as often as they would among things that are new.
"""

import json
from collections.abc import Callable, Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from uniteam.files import write_whole
from uniteam.geometry import PinholeCamera
from uniteam.mind.perception.learned.asking import Asking
from uniteam.mind.perception.learned.eyes import Eyes
from uniteam.mind.perception.learned.networks import Card
from uniteam.mind.perception.words.meaning import load_words
from uniteam.training.namer_data import HELD_OUT, is_held_out
from uniteam.training.records import things_of
from uniteam.training.sightings import Answer, Sightings, Watcher
from uniteam.training.views import training_home, views_of

FIRST_HOME = 9_000
"""Number of the first training home to calibrate with; the networks were not trained in it."""
_EDGES = (0.0, 0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.01)
"""Of raw scores, between which the share of right answers is taken."""
_PRIOR = 2.0
"""Answers that the raw score itself counts for."""
_FEWEST_OF_CLASS = 25
_GRID = np.arange(0.05, 0.96, 0.05)

Points = tuple[list[float], list[float]]


def watch_training_homes(
    eyes: Eyes, card: Card, homes: int, views: int, camera: PinholeCamera, on_home: Callable[[], None]
) -> Sightings:
    """Return what is seen in training homes that no network was trained in."""
    watcher = Watcher(eyes, Asking(card, load_words()), camera)
    for number in range(FIRST_HOME, FIRST_HOME + homes):
        home = training_home(number)
        watcher.watch(views_of(home, views, np.random.default_rng([number, 13]), 0.0, 0.0), things_of(home))
        on_home()
    return watcher.sightings


def fit_calibration(answers: Sequence[Answer], role: str) -> Points:
    """Return (raw scores, chances): what a role's raw scores are worth, as the points of a broken line that rises.

    The share of right answers between two scores, drawn to the raw score where there are few, is made to rise by
    isotonic regression (pooling adjacent violators: Ayer et al., Annals of Mathematical Statistics 26, 1955).
    """
    own = [a for a in answers if a.role == role and weight_of(a) > 0.0]
    scores, weights = np.array([a.raw for a in own]), np.array([weight_of(a) for a in own])
    right = np.array([float(a.is_right) for a in own])
    middles, shares, evidence = [], [], []
    for low, high in pairwise(_EDGES):
        within = (scores >= low) & (scores < high)
        weight = float(weights[within].sum())
        if weight > 0.0:
            middle = float(np.average(scores[within], weights=weights[within]))
            shares.append((float((weights * right)[within].sum()) + _PRIOR * middle) / (weight + _PRIOR))
            middles.append(middle)
            evidence.append(weight + _PRIOR)
    if not middles:
        return [0.0, 1.0], [0.0, 1.0]
    fitted = isotonic(np.array(shares), np.array(evidence))
    return [0.0, *(round(m, 4) for m in middles), 1.0], [0.0, *(round(float(f), 4) for f in [*fitted, fitted[-1]])]


def isotonic(values: NDArray[np.float64], weights: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the rising (N,) sequence that is nearest to the values in the weighted mean square."""
    levels: list[list[float]] = []
    for value, weight in zip(values, weights, strict=True):
        levels.append([float(value), float(weight), 1.0])
        while len(levels) > 1 and levels[-2][0] >= levels[-1][0]:
            last, before = levels.pop(), levels.pop()
            total = last[1] + before[1]
            levels.append([(last[0] * last[1] + before[0] * before[1]) / total, total, last[2] + before[2]])
    return np.repeat([level[0] for level in levels], [int(level[2]) for level in levels])


def weight_of(answer: Answer) -> float:
    """Return what an answer counts: a held-out model's 1, no thing's its share, a model's that was trained with 0."""
    if answer.matched is None:
        return 1.0 / HELD_OUT
    return 1.0 if is_held_out(answer.matched.model) else 0.0


def fit_thresholds(sightings: Sightings) -> dict[str, object]:
    """Return the content of a file of thresholds: by role and by class, those of the best F1.

    A class of which there is little evidence has its role's threshold; the others are drawn half the way to it.
    """
    roles = {role: _best_threshold(sightings, role, None) for role in ("object", "receptacle")}
    by_class = {}
    for role in roles:
        for word in sorted({a.word for a in sightings.answers if a.role == role}):
            own = _best_threshold(sightings, role, word)
            if own is not None and roles[role] is not None:
                by_class[word] = round((own + _value(roles[role])) / 2.0, 3)
    thing, furniture = _value(roles["object"]), _value(roles["receptacle"])
    by_role = {"object": thing, "start_receptacle": furniture, "goal_receptacle": furniture}
    return {"by_role": by_role, "other": furniture, "by_class": by_class}


def _value(threshold: float | None) -> float:
    return 0.45 if threshold is None else round(threshold, 3)


def _best_threshold(sightings: Sightings, role: str, word: str | None) -> float | None:
    """Return the threshold of the best F1 for a role, or one word of it; None where there is too little evidence."""
    present = [p for p in sightings.present if p.thing.role == role and is_held_out(p.thing.model)]
    answers = [a for a in sightings.answers if a.role == role and weight_of(a) > 0.0]
    if word is not None:
        present = [p for p in present if p.thing.category == word]
        answers = [a for a in answers if a.word == word]
    if len(present) < _FEWEST_OF_CLASS:
        return None
    scores, weights = np.array([a.score for a in answers]), np.array([weight_of(a) for a in answers])
    right = np.array([a.is_right for a in answers], dtype=bool)
    best, best_value = None, -1.0
    for threshold in _GRID:
        said = scores >= threshold
        hits = weights[said & right].sum()
        value = 2.0 * hits / max(weights[said].sum() + len(present), 1e-9)
        if value > best_value:
            best, best_value = float(threshold), value
    return best


def write_thresholds(path: Path, content: dict[str, object]) -> None:
    """Write a file of thresholds; raises UnwritableError."""
    write_whole(path, (json.dumps(content, indent=2) + "\n").encode())
