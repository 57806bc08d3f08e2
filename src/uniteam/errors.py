"""The package's own errors: each says what was wrong, what was expected and what to do."""

from collections.abc import Iterable
from difflib import get_close_matches


class UniteamError(Exception):
    """Base of every error a user can cause; the command line prints it as one sentence and exits with code 2."""


class UnknownNameError(UniteamError):
    """A name that is not among the valid ones; the message offers the nearest."""

    def __init__(self, kind: str, name: str, valid: Iterable[str]) -> None:
        """Build the message.

        Args:
            kind: what the name names, in the singular ("agent", "split").
            name: what was given.
            valid: every name that would have been accepted.
        """
        names = sorted(valid)
        nearest = get_close_matches(name, names, n=1, cutoff=0.4)
        hint = f"did you mean '{nearest[0]}'? " if nearest else ""
        some = names if len(names) <= 30 else get_close_matches(name, names, n=5, cutoff=0.0)
        shown = ", ".join(some) + (f" and {len(names) - len(some)} more" if len(names) > len(some) else "")
        super().__init__(f"unknown {kind} '{name}': {hint}Valid: {shown}.")


class DamagedFileError(UniteamError):
    """A file of the package or of the user that cannot be read as what it should be."""


class InvalidInputError(UniteamError):
    """A value of the wrong shape, type or range."""


class InvalidActionError(UniteamError):
    """What a body cannot do because it is no action, or holds a number that is none; nothing has moved."""
