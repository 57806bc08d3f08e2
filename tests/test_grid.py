"""Cells and points of a grid on the floor."""

import cv2
import numpy as np
import pytest

from uniteam.grid import Grid, disc, disc_mask, draw_disc, grown, grown_by_rows

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


@pytest.mark.parametrize("half_widths", [(0,), (3,), (1, 1, 1, 0), (5, 4, 2), (10, 9, 9, 9, 9, 8, 8, 7, 6, 4, 0)])
@pytest.mark.parametrize("shape", [(1, 1), (5, 70), (40, 31)])
def test_growing_by_rows_is_a_dilation_by_the_shape(shape: tuple[int, int], half_widths: tuple[int, ...]) -> None:
    reach, widest = len(half_widths) - 1, max(half_widths)
    kernel = np.zeros((2 * reach + 1, 2 * widest + 1), dtype=np.uint8)
    for away, half in enumerate(half_widths):
        kernel[[reach - away, reach + away], widest - half : widest + half + 1] = 1
    for share in (0.0, 0.02, 0.3):
        cells = np.random.default_rng(3).random(shape) < share
        expected = cv2.dilate(cells.view(np.uint8), kernel).view(np.bool_)
        assert np.array_equal(grown_by_rows(cells, half_widths), expected)


def test_a_disc_is_drawn_and_taken_away_again_where_it_lies_on_the_mask() -> None:
    mask = np.zeros((20, 20), dtype=np.bool_)
    draw_disc(mask, (-1, 10), 3)
    assert np.array_equal(mask, disc_mask(mask.shape, (-1, 10), 3)) and 0 < mask.sum() < 20
    draw_disc(mask, (-1, 10), 3, value=False)
    assert not mask.any()
