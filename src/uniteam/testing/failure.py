"""What a check raises."""

from collections.abc import Callable
from typing import TypeVar

from uniteam.errors import UniteamError

Value = TypeVar("Value")


class CheckFailedError(UniteamError, AssertionError):
    """What was checked does not do what its interface promises; the sentence says what differed, and where."""


def called(what: str, call: Callable[[], Value]) -> Value:
    """Return what a call returns.

    Args:
        what: is called, for the sentence ("agent 'random': reset").
        call: without arguments.

    Raises:
        CheckFailedError: the call raises anything.
    """
    try:
        return call()
    except CheckFailedError:
        raise
    except Exception as error:
        raise CheckFailedError(f"{what} raised {type(error).__name__}: {one_line(str(error))}") from error


def one_line(words: object) -> str:
    """Return words of anybody's so that they fit into a sentence."""
    line = " ".join(str(words).split())
    return line if len(line) <= 300 else f"{line[:300]}..."


def name_of(thing: object) -> str:
    """Return what to call something: a name as it is, a class or a function by its own, a value by its class's."""
    return thing if isinstance(thing, str) else str(getattr(thing, "__qualname__", type(thing).__name__))
