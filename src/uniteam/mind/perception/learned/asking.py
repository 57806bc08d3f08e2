"""How well what is seen answers to a word: the asked name against every name that the namer knows."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from uniteam.mind.perception.learned.eyes import Glimpse
from uniteam.mind.perception.learned.kinds import Kind
from uniteam.mind.perception.learned.networks import Card
from uniteam.mind.perception.words.meaning import Words, plain_words

UNSEEN_ADVANTAGE = 3.0
"""Added to the logit of a name that the namer was not trained with: what it knows is always nearer."""
DENSE_SHARE = 1.2
"""Of the segmenter's word on which receptacle a region is."""
ROLES = {Kind.OBJECT: "object", Kind.RECEPTACLE: "receptacle"}


@dataclass(frozen=True)
class Asked:
    """A word that is asked for.

    Attributes:
        word: as it was given.
        kind: of what answers to it.
        name: the name that it was taken for.
        vector: (DIMENSIONS,) of its meaning.
    """

    word: str
    kind: Kind
    name: str
    vector: NDArray[np.float32]


class Asking:
    """Scores what is seen for what is asked."""

    def __init__(self, card: Card, words: Words) -> None:
        """Look up the vectors of the names that the namer was trained with."""
        self._card, self._words = card, words
        self._names: dict[Kind, list[str]] = {}
        self._vectors: dict[Kind, NDArray[np.float32]] = {}
        for kind, role in ROLES.items():
            names = [*card.names[role], *(n for n in card.names["decor"] if n not in card.names[role])]
            self._names[kind] = [plain_words(name) for name in names]
            self._vectors[kind] = np.stack([words.meaning(name).vector for name in names])
        receptacles = self._names[Kind.RECEPTACLE]
        self._dense = [receptacles.index(plain_words(name)) for name in card.receptacles]

    def asked(self, word: str, kind: Kind) -> Asked:
        """Return a word with its meaning; raises UnknownNameError where it has none."""
        meaning = self._words.meaning(word)
        return Asked(word, kind, meaning.name, meaning.vector)

    def score(self, glimpse: Glimpse, asked: Asked) -> float:
        """Return the calibrated chance that a glimpse is what is asked for; 0 where it is of another kind."""
        if glimpse.region.kind is not asked.kind:
            return 0.0
        return calibrated(self.raw_score(glimpse, asked), ROLES[asked.kind], self._card.calibration)

    def raw_score(self, glimpse: Glimpse, asked: Asked) -> float:
        """Return the namer's own chance that a glimpse is what is asked for, and a whole thing."""
        names, logits = self._names[asked.kind], self._logits(glimpse)
        if asked.name in names:
            own = float(logits[names.index(asked.name)])
        else:
            own = float(self._card.scale * (asked.vector @ glimpse.vector)) + UNSEEN_ADVANTAGE
            logits = np.append(logits, own)
        top = float(logits.max())
        chance = np.exp(own - top) / np.exp(logits - top).sum()
        return float(chance / (1.0 + np.exp(glimpse.junk)))

    def best_name(self, glimpse: Glimpse) -> str:
        """Return the likeliest name of those that the namer knows for a glimpse's kind, its words apart."""
        return self._names[glimpse.region.kind][int(self._logits(glimpse).argmax())]

    def _logits(self, glimpse: Glimpse) -> NDArray[np.float32]:
        """Return the logits of the names that the namer knows for a glimpse's kind."""
        kind = glimpse.region.kind
        logits = self._card.scale * (self._vectors[kind] @ glimpse.vector)
        if kind is Kind.RECEPTACLE:
            logits[self._dense] += DENSE_SHARE * glimpse.region.receptacle_scores
        return np.asarray(logits)


def calibrated(score: float, role: str, calibration: Mapping[str, tuple[list[float], list[float]]]) -> float:
    """Return what a raw score is worth for a role: straight lines between the points that were measured."""
    if role not in calibration:
        return min(max(score, 0.0), 1.0)
    scores, chances = calibration[role]
    return float(np.clip(np.interp(score, scores, chances), 0.0, 1.0))
