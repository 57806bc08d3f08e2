"""What lies around each of many placing points: compiled, since there are thousands of points around hundreds."""

import numpy as np
from numba import njit
from numpy.typing import NDArray


@njit(cache=True, nogil=True)
def cells_as_high(
    points: NDArray[np.float32],
    samples: NDArray[np.float32],
    half: int,
    cell: np.float32,
    below: np.float32,
) -> NDArray[np.uint8]:  # pragma: no cover
    """Return (K, 2 half + 1, 2 half + 1) cells around each sample, 1 where a point is as high as it.

    Args:
        points: (N, 3) m, z up.
        samples: (K, 3) m; each lies in the middle cell of its own.
        half: cells to either side.
        cell: a cell's side (m).
        below: how much lower a point may be (m).
    """
    side = 2 * half + 1
    reach = np.float32(half * cell)
    cells = np.zeros((len(samples), side, side), np.uint8)
    for k in range(len(samples)):
        x, y, lowest = samples[k, 0], samples[k, 1], samples[k, 2] - below
        for n in range(len(points)):
            along, across = points[n, 0] - x, points[n, 1] - y
            if abs(along) < reach and abs(across) < reach and points[n, 2] > lowest:
                row, column = int(np.rint(across / cell)), int(np.rint(along / cell))
                cells[k, row + half, column + half] = 1
    return cells


@njit(cache=True, nogil=True)
def share_as_high(
    points: NDArray[np.float32], samples: NDArray[np.float32], reach: np.float32, play: np.float32
) -> NDArray[np.float64]:  # pragma: no cover
    """Return the (K,) share of the points around each sample that are at its height; 0 where there are none.

    Args:
        points: (N, 3) m, z up.
        samples: (K, 3) m.
        reach: how far around a sample points are looked at, along x and y (m).
        play: what is less higher or lower than this is at its height (m).
    """
    shares = np.zeros(len(samples))
    for k in range(len(samples)):
        around = level = 0
        for n in range(len(points)):
            if abs(points[n, 0] - samples[k, 0]) < reach and abs(points[n, 1] - samples[k, 1]) < reach:
                around += 1
                if abs(points[n, 2] - samples[k, 2]) < play:
                    level += 1
        if around > 0:
            shares[k] = level / around
    return shares
