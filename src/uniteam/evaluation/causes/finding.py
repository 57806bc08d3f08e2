"""What a rule finds: that its cause applies, and what shows it."""

from collections.abc import Callable
from dataclasses import dataclass

from uniteam.evaluation.causes.cause import Cause
from uniteam.evaluation.causes.story import Story
from uniteam.geometry import Point2


@dataclass(frozen=True)
class Finding:
    """A cause with its evidence.

    Attributes:
        cause: why the episode failed.
        step: at which it shows; 0 where no step can be named.
        place: where on the floor (m, world), or None.
        words: what shows it, one sentence.
    """

    cause: Cause
    step: int
    place: Point2 | None
    words: str


Rule = Callable[[Story], Finding | None]
"""Returns what it finds, or None where its cause does not apply."""


def spoken(name: str) -> str:
    """Return the name of an instance or a class as people say it."""
    return name.replace("_", " ")
