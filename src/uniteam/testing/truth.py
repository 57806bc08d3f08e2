"""Observations without the truth, and with another truth."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from uniteam.interface import Observation, Segmentation


def without_truth(observation: Observation) -> Observation:
    """Return the observation as whoever does not need the truth is shown it."""
    return replace(observation, truth=None)


def with_another_truth(observation: Observation) -> Observation:
    """Return the observation with its truth mirrored, and every name in it another's."""
    truth = observation.truth
    if truth is None:
        return observation
    return replace(observation, truth=Segmentation(truth.instances[:, ::-1].copy(), truth.detections[::-1]))


def as_it_is(observation: Observation) -> Observation:
    """Return the observation with its truth."""
    return observation


def without_and_with_another(seen: Iterable[Observation]) -> Iterator[tuple[Observation, Observation]]:
    """Yield each observation without its truth, and with another."""
    return ((without_truth(observation), with_another_truth(observation)) for observation in seen)


READS_THE_TRUTH = (
    "it reads observation.truth, though it is not registered as one that needs it: without it and with another it "
    "answers differently"
)
"""What it means where the answers to the two differ."""
