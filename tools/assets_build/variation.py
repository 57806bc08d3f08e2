"""What tells the instances of a drawn family apart: numbers and choices, apart for training and for testing."""

import hashlib
from collections.abc import Sequence
from typing import Literal, TypeVar

import numpy as np

Pool = Literal["train", "test"]
Choice = TypeVar("Choice")

BANDS: dict[str, tuple[tuple[float, float], ...]] = {
    "train": ((0.0, 0.18), (0.41, 0.59), (0.82, 1.0)),
    "test": ((0.21, 0.38), (0.62, 0.79)),
}
"""The shares of a range that each pool draws from: they never meet."""


class Variation:
    """The numbers and choices of one instance, the same in every build.

    The instances of a family share out each range among them, and go through all choices before they repeat one.
    """

    def __init__(self, family: str, pool: Pool, index: int, count: int) -> None:
        self.pool: Pool = pool
        self.index = index
        self._family, self._count, self._asked = family, count, 0

    def between(self, low: float, high: float) -> float:
        """Return a number of a range, from the bands of the pool."""
        rng = self._next()
        place = (int(rng.permutation(self._count)[self.index]) + 0.5) / self._count
        bands = BANDS[self.pool]
        left = place * sum(end - start for start, end in bands)
        for start, end in bands:
            if left <= end - start:
                return low + (high - low) * (start + left)
            left -= end - start
        return low + (high - low) * bands[-1][1]

    def pick(self, train: Sequence[Choice], test: Sequence[Choice]) -> Choice:
        """Return one of the choices of the pool."""
        options = train if self.pool == "train" else test
        rng = self._next()
        order = [int(k) for _ in range(1 + self._count // len(options)) for k in rng.permutation(len(options))]
        return options[order[self.index]]

    def seed(self) -> int:
        """Return a seed for a texture."""
        return int(self._next().integers(1 << 30)) + self.index

    def _next(self) -> np.random.Generator:
        """Return the generator of the next question: the same for all instances of a family and a pool."""
        self._asked += 1
        key = hashlib.sha256(f"{self._family} {self.pool} {self._asked}".encode()).digest()
        return np.random.default_rng(int.from_bytes(key[:8], "little"))
