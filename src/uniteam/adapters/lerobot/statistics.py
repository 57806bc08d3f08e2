"""What LeRobot keeps of each feature for policies that want numbers of one size: range, mean, deviation, quantiles.

Nothing is sampled or estimated: vectors are looked at whole, and of pictures the number of pixels of each level is
counted, from which all of these follow.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Statistics = Mapping[str, list[object]]
"""By the names of LeRobot: min, max, mean, std, count, q01, q10, q50, q90, q99."""

_QUANTILES = {"q01": 0.01, "q10": 0.1, "q50": 0.5, "q90": 0.9, "q99": 0.99}


def vector_statistics(rows: NDArray[np.generic]) -> Statistics:
    """Return the statistics of (N, D) vectors or of (N,) numbers, by column."""
    columns = np.asarray(rows, np.float64).reshape(len(rows), -1)
    found = {
        "min": columns.min(axis=0),
        "max": columns.max(axis=0),
        "mean": columns.mean(axis=0),
        "std": columns.std(axis=0),
        **{name: np.quantile(columns, share, axis=0) for name, share in _QUANTILES.items()},
    }
    return {"count": [len(rows)], **{name: values.tolist() for name, values in found.items()}}


@dataclass(frozen=True)
class PixelCounts:
    """How many pixels of some pictures have each level.

    Attributes:
        pictures: how many there are.
        counts: (C, L) int64, by channel and level.
    """

    pictures: int
    counts: NDArray[np.int64]

    def __add__(self, other: "PixelCounts") -> "PixelCounts":
        return PixelCounts(self.pictures + other.pictures, self.counts + other.counts)

    def statistics(self, values: NDArray[np.float64]) -> Statistics:
        """Return the statistics by channel, each in brackets as if it were a picture of one pixel.

        Args:
            values: (L,) what each level stands for, in rising order.
        """
        shares = self.counts / self.counts.sum(axis=1, keepdims=True)
        mean = shares @ values
        present = [np.flatnonzero(channel) for channel in self.counts]
        found = {
            "min": values[[levels[0] for levels in present]],
            "max": values[[levels[-1] for levels in present]],
            "mean": mean,
            "std": np.sqrt((shares * (values - mean[:, None]) ** 2).sum(axis=1)),
            **{name: values[_levels_at(shares, share)] for name, share in _QUANTILES.items()},
        }
        return {"count": [self.pictures], **{name: each.reshape(-1, 1, 1).tolist() for name, each in found.items()}}


def count_pixels(picture: NDArray[np.integer], levels: int) -> PixelCounts:
    """Return the pixels of each level of one (H, W, C) or (H, W) picture."""
    channels = picture.reshape(*picture.shape[:2], -1)
    counted = [np.bincount(channels[..., c].ravel(), minlength=levels) for c in range(channels.shape[2])]
    return PixelCounts(1, np.array(counted, np.int64))


def _levels_at(shares: NDArray[np.float64], share: float) -> NDArray[np.intp]:
    """Return by channel the lowest level up to which at least a share of the pixels lies."""
    reached = np.cumsum(shares, axis=1) >= share - 1e-12
    return reached.argmax(axis=1)
