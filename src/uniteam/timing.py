"""Where a step's time goes: named sections that add up while a `Stopwatch` is running, and cost nothing otherwise."""

from collections import defaultdict
from collections.abc import Iterator
from contextlib import contextmanager
from time import perf_counter


class Stopwatch:
    """Seconds spent in each named section while it is the running one; nested sections count only for themselves."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = defaultdict(float)
        self._open: list[str] = []
        self._since = 0.0

    def enter(self, name: str) -> None:
        """Charge the time so far to the section around, and start `name`."""
        now = perf_counter()
        if self._open:
            self.seconds[self._open[-1]] += now - self._since
        self._open.append(name)
        self._since = now

    def leave(self) -> None:
        """End the innermost section and go on with the one around it."""
        now = perf_counter()
        self.seconds[self._open.pop()] += now - self._since
        self._since = now


_running: Stopwatch | None = None


@contextmanager
def stopwatch() -> Iterator[Stopwatch]:
    """Run a `Stopwatch` for the block; every `section` inside is charged to it."""
    global _running
    before, _running = _running, Stopwatch()
    try:
        yield _running
    finally:
        _running = before


@contextmanager
def section(name: str) -> Iterator[None]:
    """Name the work of this block ("camera", "physics", "perception", "map", "planner") for the running stopwatch."""
    watch = _running
    if watch is None:
        yield
        return
    watch.enter(name)
    try:
        yield
    finally:
        watch.leave()
