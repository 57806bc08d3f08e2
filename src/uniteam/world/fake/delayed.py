"""A line on which everything arrives late, and only the newest of what has arrived is kept."""

from collections import deque
from typing import Generic, TypeVar

Item = TypeVar("Item")


class Delayed(Generic[Item]):
    """Things under way."""

    def __init__(self, latency: float) -> None:
        """Begin empty; what is put in comes out after `latency` (s)."""
        self._latency = latency
        self._under_way: deque[tuple[float, Item]] = deque()

    def put(self, now: float, item: Item) -> None:
        """Send something at a time (s)."""
        self._under_way.append((now + self._latency, item))

    def newest(self, now: float) -> Item | None:
        """Return the last of what has arrived by a time (s), and forget what came before it; None where nothing has."""
        arrived = None
        while self._under_way and self._under_way[0][0] <= now + 1e-9:
            arrived = self._under_way.popleft()[1]
        return arrived
