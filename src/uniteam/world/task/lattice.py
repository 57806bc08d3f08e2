"""The lattice that view points lie on, and the short form in which a split's file holds them.

View points lie at multiples of 0.1 m, so that no place on the floor is farther than 0.071 m from one: less than the
0.1 m within which the base counts as standing at it. The points of an instance fill a patch of floor, so that the
runs of its rows are some twenty times shorter than the points themselves.
"""

from collections.abc import Iterable, Sequence
from itertools import pairwise

import numpy as np

from uniteam.geometry import Point2

SPACING = 0.1

MOST_POINTS = 40_000
"""Of one instance: more than lie within 10 m of anything."""


def lattice_points_near(x: float, y: float, reach_x: float, reach_y: float) -> np.ndarray:
    """Return the (N, 2) lattice points (m) with |dx| <= reach_x and |dy| <= reach_y, by rows of y."""
    i = np.arange(np.ceil((x - reach_x) / SPACING), np.floor((x + reach_x) / SPACING) + 1)
    j = np.arange(np.ceil((y - reach_y) / SPACING), np.floor((y + reach_y) / SPACING) + 1)
    grid = np.stack(np.meshgrid(i, j), axis=-1).reshape(-1, 2)
    return np.round(grid * SPACING, 2)


def points_to_runs(points: Iterable[Point2]) -> list[int]:
    """Return flat triples (row, first column, last column) that cover lattice points; rows count y, columns x."""
    cells = sorted((round(y / SPACING), round(x / SPACING)) for x, y in points)
    runs: list[int] = []
    for row, column in cells:
        if runs and runs[-3] == row and runs[-1] == column - 1:
            runs[-1] = column
        else:
            runs += (row, column, column)
    return runs


def runs_to_points(runs: Sequence[int]) -> tuple[Point2, ...]:
    """Return the points (m) that `points_to_runs` wrote.

    Raises:
        ValueError: the runs are not triples, end before they begin, do not ascend, or hold more than `MOST_POINTS`.
    """
    triples = list(zip(runs[0::3], runs[1::3], runs[2::3], strict=True))
    if any(first > last for _, first, last in triples):
        raise ValueError("a run ends before it begins")
    if sum(last - first + 1 for _, first, last in triples) > MOST_POINTS:
        raise ValueError(f"there are more than {MOST_POINTS} points")
    if any((row, last) >= (row_after, first) for (row, _, last), (row_after, first, _) in pairwise(triples)):
        raise ValueError("the runs do not ascend, or one meets a point twice")
    return tuple(
        (round(column * SPACING, 2), round(row * SPACING, 2))
        for row, first, last in triples
        for column in range(first, last + 1)
    )
