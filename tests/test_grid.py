"""Cells and points of a grid on the floor."""

import numpy as np
import pytest

from uniteam.grid import Grid, disc, disc_mask, draw_disc, grown

GRID = Grid(origin=(-1.0, 2.0), cell_size=0.05)


def test_a_cell_holds_its_centre_and_row_is_y() -> None:
    assert GRID.to_cell(-0.99, 2.11) == (2, 0)
    assert GRID.to_point(2, 0) == pytest.approx((-0.975, 2.125))
    assert all(GRID.to_cell(*GRID.to_point(row, column)) == (row, column) for row in range(-3, 9) for column in (-2, 7))


def test_many_cells_have_the_centres_of_each() -> None:
    cells = np.array([[0, 0], [3, 5], [-1, 2]])
    assert GRID.to_points(cells) == pytest.approx(np.array([GRID.to_point(*cell) for cell in cells]))


def test_a_disc_is_as_wide_as_its_radius_and_may_lie_in_part_outside() -> None:
    assert disc(3).shape == (7, 7)
    assert disc(1).tolist() == [[0, 1, 0], [1, 1, 1], [0, 1, 0]]
    assert disc_mask((4, 5), (0, 0), 1).sum() == 3
    assert not disc_mask((4, 5), (-9, -9), 2).any()


def test_what_is_grown_lies_in_a_disc_around_some_cell() -> None:
    cells = np.random.default_rng(5).random((30, 40)) > 0.99
    expected = np.zeros_like(cells)
    for row, column in np.argwhere(cells):
        rows, columns = np.indices(cells.shape)
        expected |= (rows - row) ** 2 + (columns - column) ** 2 <= 9
    assert cells.any()
    assert np.array_equal(grown(cells, 3), expected)
    assert not grown(cells & False, 3).any()


def test_a_disc_is_drawn_and_taken_away_again_where_it_lies_on_the_mask() -> None:
    mask = np.zeros((20, 20), dtype=np.bool_)
    draw_disc(mask, (-1, 10), 3)
    assert np.array_equal(mask, disc_mask(mask.shape, (-1, 10), 3)) and 0 < mask.sum() < 20
    draw_disc(mask, (-1, 10), 3, value=False)
    assert not mask.any()
