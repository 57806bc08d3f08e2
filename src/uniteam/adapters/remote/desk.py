"""Where the episodes lie that are still to be played: sessions take them, and bring back what came of them."""

from collections.abc import Callable, Sequence
from concurrent.futures import Future
from dataclasses import dataclass, field
from queue import SimpleQueue
from threading import Lock

from uniteam.evaluation.backends.processes import Lost
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.evaluation.worker import Attempt


@dataclass(frozen=True)
class Outcome:
    """What came of an attempt; `kept` is set once that is on the disk."""

    attempt: Attempt
    value: EpisodeResult | Lost
    kept: "Future[None]" = field(default_factory=Future)


@dataclass(frozen=True)
class Notice:
    """Something that whoever watches may want to know, in a sentence."""

    sentence: str


Event = Outcome | Notice | BaseException
"""An exception is one that no agent is at fault for, and ends the run."""


class Desk:
    """Hands out attempts, each once.

    Attributes:
        events: what sessions have to report, for the thread that keeps results.
    """

    def __init__(self, attempts: Sequence[Attempt], group_of: Callable[[Attempt], str]) -> None:
        """Lay out the attempts; a session goes on in the same group as long as it can."""
        self.events: SimpleQueue[Event] = SimpleQueue()
        self._left, self._group_of, self._lock = list(attempts), group_of, Lock()

    @property
    def left(self) -> int:
        """How many attempts nobody has taken yet."""
        return len(self._left)

    def take(self, group: str) -> Attempt | None:
        """Return the next attempt for a session that is in a group; None where none is left."""
        with self._lock:
            same = (attempt for attempt in self._left if self._group_of(attempt) == group)
            chosen = next(same, self._left[0] if self._left else None)
            if chosen is not None:
                self._left.remove(chosen)
            return chosen

    def group_of(self, attempt: Attempt) -> str:
        """Return the group of an attempt."""
        return self._group_of(attempt)

    def bring(self, attempt: Attempt, value: EpisodeResult | Lost) -> None:
        """Report what came of an attempt, and wait until it is kept."""
        outcome = Outcome(attempt, value)
        self.events.put(outcome)
        outcome.kept.result()
