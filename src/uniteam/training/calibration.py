"""What scores are worth: fitted on training homes, with models that no network has seen.

Of what was seen in training homes, the things of held-out models and what is no thing count, the latter by the share of
models that is held out, so that right and wrong come as often as they would among things that are new.
"""

from collections.abc import Callable, Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

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
