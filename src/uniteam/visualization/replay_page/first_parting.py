"""Where two runs of an episode part."""

from collections.abc import Sequence
from dataclasses import dataclass

from uniteam.errors import InvalidInputError
from uniteam.evaluation.recording.recording import Recording


@dataclass(frozen=True)
class Parting:
    """The first steps at which two runs differ, None where they do not.

    Attributes:
        action: at which the robots do different things, or only one of them does anything.
        decision: at which action, state or reason differ.
    """

    action: int | None
    decision: int | None


def first_parting(one: Recording, other: Recording) -> Parting:
    """Return where two runs part.

    Raises:
        InvalidInputError: they are not of the same episode.
    """
    if one.split.digest != other.split.digest:
        raise InvalidInputError(
            f"'{one.path}' is of episode '{one.episode.id}' and '{other.path}' of '{other.episode.id}', or their homes "
            "differ; give two recordings of the same episode"
        )
    mine, others = ([step.decision for step in recording.steps] for recording in (one, other))
    return Parting(
        _first([d.action for d in mine], [d.action for d in others]),
        _first(mine, others),
    )


def _first(mine: Sequence[object], others: Sequence[object]) -> int | None:
    """Return the first index at which two lists differ, the shorter one's end being a difference."""
    both = min(len(mine), len(others))
    different = (k for k in range(both) if mine[k] != others[k])
    return next(different, None if len(mine) == len(others) else both)
