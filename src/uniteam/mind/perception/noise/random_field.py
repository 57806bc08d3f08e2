"""Random numbers that belong to places: near ones have like numbers, far ones have nothing to do with each other."""

import math
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

_WAVES = 48


class RandomField:
    """A smooth random function of points, about standard normal at each of them.

    A sum of cosines of random direction and phase (random Fourier features; Rahimi and Recht 2007), whose values at two
    points have the correlation exp(-d^2 / 2 l^2) for their distance d and the field's length l. A value depends on
    nothing but the seed, the name and the point, so that what is asked twice is answered alike.
    """

    def __init__(self, seed: int, name: str, lengths: tuple[float, ...]) -> None:
        """Draw the function.

        Args:
            seed: of the episode.
            name: fields of different names are independent.
            lengths: how far apart two points must be to differ, along each of the K axes, in that axis's unit.
        """
        dice = np.random.default_rng((seed, crc32(name.encode())))
        waves = dice.normal(size=(len(lengths), _WAVES)) / np.asarray(lengths)[:, None]
        self._waves = waves.astype(np.float32)
        self._phases = dice.uniform(0.0, 2.0 * math.pi, size=_WAVES).astype(np.float32)

    def __call__(self, points: NDArray[np.floating]) -> NDArray[np.float32]:
        """Return (...) values at (..., K) points."""
        angles = points.astype(np.float32) @ self._waves + self._phases
        return np.float32(math.sqrt(2.0 / _WAVES)) * np.cos(angles, out=angles).sum(axis=-1)


def as_share(value: float) -> float:
    """Return which share of standard normal numbers is smaller than a value: uniform in [0, 1] for such a number."""
    return 0.5 * math.erfc(-value / math.sqrt(2.0))
