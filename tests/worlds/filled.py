"""Loops whose assertions are certain to run."""

from collections.abc import Iterable
from typing import TypeVar

T = TypeVar("T")


def filled(things: Iterable[T]) -> tuple[T, ...]:
    """Return the things, of which there must be at least one."""
    everything = tuple(things)
    assert everything, "nothing is left to test"
    return everything
