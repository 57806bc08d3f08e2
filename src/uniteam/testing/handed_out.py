"""Observations that are handed out for a look: with arrays of their own, so that it shows who writes into them."""

from collections.abc import Iterable
from dataclasses import replace

from uniteam.interface import Observation, Segmentation
from uniteam.testing.difference import first_difference
from uniteam.testing.failure import CheckFailedError


class HandedOut:
    """The observations that one agent or perception was handed.

    The simulator's arrays are read-only; those of a recording or a robot need not be, so these are not.
    """

    def __init__(self) -> None:
        self._pairs: list[tuple[Observation, Observation]] = []

    def copy_of(self, observation: Observation) -> Observation:
        """Return an observation to hand out, equal to the given one."""
        copy = own_copy(observation)
        self._pairs.append((observation, copy))
        return copy

    def check_last(self, who: str) -> None:
        """Raise CheckFailedError where what was handed out last is no longer as it was."""
        _check_unchanged(self._pairs[-1:], who)

    def check_all(self, who: str) -> None:
        """Raise CheckFailedError where anything that was handed out is no longer as it was."""
        _check_unchanged(self._pairs, who)


def _check_unchanged(pairs: Iterable[tuple[Observation, Observation]], who: str) -> None:
    for observation, copy in pairs:
        changed = first_difference(observation, copy, "observation")
        if changed:
            raise CheckFailedError(
                f"{who} wrote into {changed} of step {observation.step}, which is not its own; "
                "work on a copy (array.copy())"
            )


def own_copy(observation: Observation) -> Observation:
    """Return an equal observation with arrays of its own, which can be written into."""
    truth = observation.truth
    return replace(
        observation,
        rgb=observation.rgb.copy(),
        depth=observation.depth.copy(),
        camera_to_start=observation.camera_to_start.copy(),
        truth=None if truth is None else Segmentation(truth.instances.copy(), truth.detections),
    )
