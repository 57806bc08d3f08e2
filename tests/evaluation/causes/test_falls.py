"""What goes through a receptacle is told from what falls beside it."""

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
import pytest
from worlds.small_home import instance, small_home

from uniteam.evaluation.causes.reading.falls import Bounds, falls_through
from uniteam.world.assets.catalogue import load_catalogue

ROUND = load_catalogue().models["table_et_round_table"]
HALF = np.array([0.03, 0.03, 0.02])
CORNER = 2.58
"""Within the rectangle around the table, 1.26 m wide at (2, 2), and not above it."""


def boxes(*places: tuple[float, float, float]) -> Iterator[Bounds]:
    """Yield the bounds of a small thing on straight lines between some places."""
    for start, end in pairwise(places):
        for middle in np.linspace(start, end, 21):
            yield middle - HALF, middle + HALF


@pytest.mark.parametrize(
    ("path", "is_through"),
    [
        ([(2.3, 2.0, 1.0), (2.3, 2.0, 0.03)], True),
        ([(2.3, 2.0, 1.0), (2.3, 2.0, 0.77)], False),
        ([(2.3, 2.0, 1.0), (2.3, 2.0, 0.77), (2.9, 2.0, 0.77), (2.9, 2.0, 0.03), (2.3, 2.0, 0.03)], False),
        ([(2.3, 2.0, 0.5), (2.3, 2.0, 0.03)], False),
        ([(2.9, 2.0, 1.0), (2.9, 2.0, 0.03)], False),
        ([(CORNER, CORNER, 1.0), (CORNER, CORNER, 0.03)], False),
    ],
    ids=["through it", "onto it", "over its edge and under it", "from under it", "beside it", "past its round edge"],
)
def test_a_fall_through_is_one_from_above_with_no_way_around(
    path: list[tuple[float, float, float]], is_through: bool
) -> None:
    table = instance("table_1", ROUND, 2.0, 2.0)
    home = small_home(table, library=load_catalogue())
    assert falls_through(home, table, ROUND.surfaces[0].height, boxes(*path)) is is_through
