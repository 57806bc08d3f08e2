"""How what anybody may have written must be answered: in time, and taken for sound or refused in one sentence."""

import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import TypeVar

from uniteam.errors import UniteamError

Value = TypeVar("Value")


class Hanging(BaseException):
    """Work that does not end; nothing that works around errors catches it."""


def outcome(work: Callable[[], Value], seconds: float = 120.0) -> Value | None:
    """Return what work returns, or None where it is refused in one sentence.

    Args:
        work: reads and uses what may be nonsense.
        seconds: how long it may take.

    Raises:
        Hanging: it takes longer.
        Exception: anything else than an error of the package's own.
    """
    with ended_after(seconds):
        try:
            return work()
        except UniteamError as error:
            assert is_sentence(str(error)), repr(str(error))
            return None


def is_sentence(words: str) -> bool:
    """Tell whether words stand in one line, without what would change a terminal."""
    return bool(words.strip()) and not set(words) & {"\n", "\r", "\x1b"}


@contextmanager
def ended_after(seconds: float) -> Iterator[None]:
    """End what takes longer with `Hanging`."""

    def ring(number: int, frame: FrameType | None) -> None:
        raise Hanging(f"it has not ended after {seconds:g} s")

    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
