"""Perception `noisy:LEVEL`: the truth, as a detector that errs would see it.

What goes wrong is a function of the seed, of what is there and of where it is seen from. So a thing that was missed is
likely to be missed again, a robot that stands still sees the same again, and what is missed at one level is missed at
every higher one.
"""

import math
from dataclasses import dataclass
from functools import cache

import numpy as np

from uniteam.errors import InvalidInputError
from uniteam.interface import Detection, Instruction, Observation, Segmentation
from uniteam.mind.perception.noise.confusions import look_alikes
from uniteam.mind.perception.noise.floor_patches import PATCH_LENGTH, floor_patches
from uniteam.mind.perception.noise.places import Sighting, sightings
from uniteam.mind.perception.noise.ragged import ragged
from uniteam.mind.perception.noise.random_field import RandomField, as_share
from uniteam.mind.perception.noise.rates import DETECTOR, Rates, score_of_logit
from uniteam.mind.perception.segments import change_detections, keep_detections
from uniteam.mind.perception.truth import SMALLEST_INSTANCE, visible_truth

PLACE_LENGTHS = (0.7, 0.7, 0.7)
"""m; things so far from each other are missed or confused independently."""
VIEW_LENGTHS = (*PLACE_LENGTHS, 0.5, 0.5, 0.5)
"""m; the same of where they are seen from."""
SECOND_SCORE = 0.6
"""The score of what a thing is, of that of what it is taken for."""


@dataclass(frozen=True)
class Noisy:
    """Makes perceptions of one level in [0, 1]."""

    level: float
    rates: Rates = DETECTOR
    needs_truth = True

    def __call__(self) -> "NoisyPerception":
        """Return a new perception."""
        return NoisyPerception(self.level, self.rates)


def noisy_of(argument: str) -> Noisy:
    """Return what makes perceptions of the level that an argument names; raises InvalidInputError."""
    try:
        level = float(argument)
    except ValueError:
        level = math.nan
    if not 0.0 <= level <= 1.0:
        raise InvalidInputError(
            f"perception 'noisy' needs a level from 0 (the truth) to 1 (about a published detector's errors), "
            f"got '{argument}'; give one such as noisy:0.6"
        )
    return Noisy(level)


class NoisyPerception:
    """Sees the truth with the errors of a detector; at level 0 it is the truth, to the bit."""

    needs_truth = True

    def __init__(self, level: float, rates: Rates = DETECTOR) -> None:
        """Set the dial: how much goes wrong, from 0 to 1, of what `rates` says of level 1."""
        self.level = level
        self.rates = rates
        self.reset(Instruction("", "", ""), 0)

    def reset(self, instruction: Instruction, seed: int) -> None:
        """Begin an episode: draw what will go wrong where."""
        self._seed = seed
        self._instruction = instruction
        self._field = cache(lambda name, lengths: RandomField(seed, name, lengths))

    def perceive(self, observation: Observation) -> Segmentation:
        """Return what is believed to be seen; raises InvalidInputError where the observation carries no truth."""
        seen = visible_truth(observation)
        if self.level == 0.0:
            return seen
        things = sightings(seen, observation)
        named = change_detections(seen, [self._named(thing, observation.depth.size) for thing in things])
        dice = np.random.default_rng((self._seed, observation.step))
        believed = self._with_floor(named, seen, observation)
        edged = ragged(believed.instances, self.level * self.rates.ragged, dice)
        return _without_specks(Segmentation(edged, believed.detections))

    def _named(self, thing: Sighting, frame_pixels: int) -> Detection | None:
        """Return what a thing is taken for, and how surely; None where it is missed."""
        rates, level = self.rates, self.level
        if self._chance("missed", thing, rates.lasting) < level * rates.miss(thing, frame_pixels):
            return None
        if self._chance("confused", thing, rates.lasting) < level * rates.confused:
            other = self._mistaken(thing)
            if other:
                score = self._score(rates.wrong_logit, other, thing)
                return Detection(((other, score), (thing.name, score * SECOND_SCORE)))
        return Detection(((thing.name, self._score(rates.right_logit, thing.name, thing)),))

    def _mistaken(self, thing: Sighting) -> str:
        """Return what looks like a thing, one of the names that are asked for if there is any; else nothing."""
        others = look_alikes(thing.name)
        asked = [name for name in others if name in self._asked()]
        choice = asked or others
        share = as_share(float(self._field(f"taken for {thing.name}", PLACE_LENGTHS)(thing.place)))
        return choice[min(int(share * len(choice)), len(choice) - 1)] if choice else ""

    def _asked(self) -> tuple[str, str, str]:
        asked = self._instruction
        return asked.object_category, asked.start_receptacle, asked.goal_receptacle

    def _chance(self, what: str, thing: Sighting, lasting: float) -> float:
        """Return a number, uniform in [0, 1], of a thing that is seen from somewhere; it changes little with either."""
        own = self._field(f"{what} {thing.name}", PLACE_LENGTHS)(thing.place)
        view = self._field(f"{what} {thing.name} from", VIEW_LENGTHS)(thing.view)
        return as_share(math.sqrt(lasting) * float(own) + math.sqrt(1.0 - lasting) * float(view))

    def _score(self, mean_logit: float, name: str, thing: Sighting) -> float:
        wavering = float(self._field(f"score {name}", VIEW_LENGTHS)(thing.view))
        return score_of_logit(mean_logit + self._bias(name) + self.rates.spread * wavering, self.level)

    def _bias(self, name: str) -> float:
        """Return by how much a name's scores are off, everywhere in an episode."""
        return self.rates.bias * float(self._field(f"bias {name}", (1.0,))(np.zeros(1)))

    def _with_floor(self, named: Segmentation, seen: Segmentation, observation: Observation) -> Segmentation:
        """Return the segmentation with patches of floor that are taken for the instruction's receptacles."""
        share = self.level * self.rates.floor
        free = seen.instances < 0
        instances, detections = named.instances.copy(), list(named.detections)
        for patch in floor_patches(observation, free, self._field("floor", (PATCH_LENGTH,) * 2), share):
            _, start, goal = self._asked()
            name = start if float(self._field("floor is", (PATCH_LENGTH,) * 2)(patch.middle)) < 0.0 else goal
            wavering = float(self._field("floor score", (PATCH_LENGTH,) * 2)(patch.middle))
            logit = self.rates.wrong_logit + self._bias(name) + self.rates.spread * wavering
            instances[patch.mask] = len(detections)
            detections.append(Detection(((name, score_of_logit(logit, self.level)),)))
        return Segmentation(instances, tuple(detections))


def _without_specks(segmentation: Segmentation) -> Segmentation:
    pixels = np.bincount(segmentation.instances.ravel() + 1, minlength=len(segmentation.detections) + 1)[1:]
    return keep_detections(segmentation, pixels >= SMALLEST_INSTANCE)
