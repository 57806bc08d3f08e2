"""Batches made ahead of time on the cores that are free."""

import os
from collections import deque
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from typing import TypeVar

T = TypeVar("T")


def prefetched(make: Callable[[int], T], first: int) -> Iterator[T]:
    """Yield what `make` returns for each number from the first on, without end, made ahead on other cores."""
    workers = max(1, (os.cpu_count() or 1) - 1)
    waiting: deque[Future[T]] = deque()
    with ThreadPoolExecutor(workers) as pool:
        number = first
        while True:
            while len(waiting) < workers + 1:
                waiting.append(pool.submit(make, number))
                number += 1
            yield waiting.popleft().result()
