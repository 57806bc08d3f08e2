"""Outlines of rooms: what is inside, how large they are, and the pieces they fall into."""

import numpy as np
import pytest
from worlds.filled import filled

from uniteam.world.homes.polygon import (
    Polygon,
    area,
    as_rectangle,
    bounds,
    contains,
    convex_pieces,
    is_simple,
    middle,
    rectangle,
)

L_SHAPE: Polygon = ((0.0, 0.0), (6.0, 0.0), (6.0, 3.0), (3.0, 3.0), (3.0, 6.0), (0.0, 6.0))
COMB: Polygon = (
    (0.0, 0.0), (7.0, 0.0), (7.0, 3.0), (6.0, 3.0), (5.5, 1.0), (4.0, 1.0), (4.0, 3.0), (3.0, 3.0), (2.0, 1.0),
    (1.0, 3.0), (0.0, 3.0),
)  # fmt: skip
ROUND: Polygon = tuple((2.0 * np.cos(t), 2.0 * np.sin(t)) for t in np.linspace(0, 2 * np.pi, 24, endpoint=False))
SQUARE = rectangle((1.0, 2.0), (3.0, 5.0))

every_shape = pytest.mark.parametrize("polygon", [L_SHAPE, COMB, ROUND, SQUARE])


def test_a_rectangle_and_its_corners_are_two_forms_of_one_thing() -> None:
    assert as_rectangle(SQUARE) == ((1.0, 2.0), (3.0, 5.0))
    assert as_rectangle((*SQUARE[1:], SQUARE[0])) is None  # begins elsewhere, so it is written as it is
    assert as_rectangle(L_SHAPE) is None
    assert as_rectangle(((0.0, 0.0), (1.0, 0.0), (1.0, 1.1), (0.0, 1.0))) is None


def test_area_and_bounds_are_those_of_the_shape() -> None:
    assert (area(L_SHAPE), area(SQUARE), area(L_SHAPE[::-1])) == (27.0, 6.0, -27.0)
    assert bounds(L_SHAPE) == ((0.0, 0.0), (6.0, 6.0))


def test_the_notch_of_an_l_is_outside() -> None:
    assert contains(L_SHAPE, 1.0, 5.0) and contains(L_SHAPE, 5.0, 1.0)
    assert not contains(L_SHAPE, 5.0, 5.0) and not contains(L_SHAPE, -1.0, 1.0)


def test_a_rectangle_holds_its_border() -> None:
    assert contains(SQUARE, 1.0, 2.0) and contains(SQUARE, 3.0, 5.0) and contains(SQUARE, 2.0, 5.0)


@every_shape
def test_the_middle_is_inside(polygon: Polygon) -> None:
    assert contains(polygon, *middle(polygon))


@every_shape
def test_the_pieces_are_convex_and_fill_the_shape_once(polygon: Polygon) -> None:
    pieces = convex_pieces(polygon)
    assert sum(area(piece) for piece in pieces) == pytest.approx(area(polygon))
    assert all(area(piece) > 0.0 for piece in pieces)
    low, high = np.array(bounds(polygon))
    points = np.random.default_rng(0).uniform(low, high, (400, 2))
    for x, y in filled(points):
        assert sum(contains(piece, x, y) for piece in pieces) == contains(polygon, x, y)


@every_shape
def test_a_sound_outline_is_simple(polygon: Polygon) -> None:
    assert is_simple(polygon)


@pytest.mark.parametrize(
    "polygon",
    [
        ((0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)),  # a bow tie
        ((0.0, 0.0), (2.0, 0.0), (2.0, 0.0), (0.0, 2.0)),  # a corner twice
        ((0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 0.0), (0.0, 2.0)),  # a corner on a side
        ((0.0, 0.0), (4.0, 0.0), (2.0, 0.0), (2.0, 2.0)),  # a side that goes back
    ],
)
def test_an_outline_that_meets_itself_is_not_simple(polygon: Polygon) -> None:
    assert not is_simple(polygon)
