"""The package's own errors: each says what was wrong, what was expected and what to do."""

from collections.abc import Iterable
from difflib import get_close_matches


class UniteamError(Exception):
    """Base of every error a user can cause; the command line prints it as one sentence and exits with code 2."""

    def __init__(self, sentence: str) -> None:
        """Take the sentence; what it quotes that is not printable, such as a line's end, is written as its escape."""
        super().__init__("".join(c if c.isprintable() else ascii(c)[1:-1] for c in str(sentence)))


class UnknownNameError(UniteamError):
    """A name that is not among the valid ones; the message offers the nearest."""

    def __init__(self, kind: str, name: str, valid: Iterable[str], hint: str = "") -> None:
        """Build the message.

        Args:
            kind: what the name names, in the singular ("agent", "split").
            name: what was given.
            valid: every name that would have been accepted.
            hint: what else could be given.
        """
        names = sorted(valid)
        nearest = get_close_matches(name, names, n=1, cutoff=0.4)
        guess = f"did you mean '{nearest[0]}'? " if nearest else ""
        some = names if len(names) <= 30 else get_close_matches(name, names, n=5, cutoff=0.0)
        shown = ", ".join(some) + (f" and {len(names) - len(some)} more" if len(names) > len(some) else "")
        more = f", {hint}" if hint else ""
        super().__init__(f"unknown {kind} '{name}': {guess}Valid: {shown}{more}.")


class DamagedFileError(UniteamError):
    """A file of the package or of the user that cannot be read as what it should be."""


class UnavailableError(UniteamError):
    """Something outside the package that a run needs is not there: a library, a model's weights, a server."""


class InvalidInputError(UniteamError):
    """A value of the wrong shape, type or range."""


class InvalidActionError(InvalidInputError):
    """What was given to `step` is no action, or holds a value that no robot can do; nothing has moved."""
