"""Bringing a view onto the map, against a turn and a shift by scipy."""

import math

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.ndimage import map_coordinates

from uniteam.mind.mapping.map_config import MapConfig
from uniteam.mind.mapping.projection import ROLE_COUNT, Channels, MappedFrame
from uniteam.mind.mapping.view_on_map import CHANNELS, bring_onto_map

SIZE, SIDE, CELL = 40, 140, 0.05


def empty_channels() -> Channels:
    shape = (SIDE, SIDE)
    of_roles = np.zeros((ROLE_COUNT, *shape), dtype=np.float32)
    return Channels(np.zeros(shape, np.bool_), np.zeros(shape, np.bool_), of_roles > 0, of_roles, of_roles.copy())


def frame_at(x: float, y: float, heading: float) -> MappedFrame:
    camera_to_grid = np.zeros((3, 4), dtype=np.float32)
    camera_to_grid[:2, 2] = math.cos(heading), math.sin(heading)
    nothing = np.zeros((1, 1), dtype=np.float32)
    scores = np.zeros((1, ROLE_COUNT), dtype=np.float32)
    base = np.array([x, y], dtype=np.float32)
    return MappedFrame(nothing, nothing.astype(np.int16), scores, np.zeros(4, np.float32), camera_to_grid, base)


def turned_and_shifted(view: NDArray[np.float32], x: float, y: float, heading: float) -> NDArray[np.float64]:
    """Return (SIDE, SIDE) what a (SIZE, SIZE) view comes to on the map, bilinearly both times."""
    rows, columns = np.mgrid[-SIZE : SIZE + 1, -SIZE : SIZE + 1]
    c, s = math.cos(heading), math.sin(heading)
    places = np.array([c * columns + s * rows, c * rows - s * columns + SIZE // 2])
    turned = map_coordinates(view.astype(np.float64), places, order=1, mode="grid-constant")
    rows, columns = np.mgrid[0:SIDE, 0:SIDE]
    return map_coordinates(turned, np.array([rows - y + SIZE, columns - x + SIZE]), order=1, mode="grid-constant")


@pytest.mark.parametrize("heading", [0.0, 0.7, 2.0, -2.6])
@pytest.mark.parametrize("filled", [((20, 26), (17, 25)), ((0, 40), (0, 40)), ((39, 40), (0, 1)), ((3, 3), (3, 3))])
def test_a_view_comes_onto_the_map_where_a_turn_and_a_shift_put_it(
    heading: float, filled: tuple[tuple[int, int], tuple[int, int]]
) -> None:
    view = np.zeros((SIZE, SIZE, CHANNELS), dtype=np.float32)
    (top, bottom), (left, right) = filled
    seen = np.random.default_rng(3).random((bottom - top, right - left), dtype=np.float32)
    view[top:bottom, left:right, 1] = view[top:bottom, left:right, 0] = seen * 3
    channels, x, y = empty_channels(), 70.3 * CELL, 68.9 * CELL
    box = bring_onto_map(
        view,
        np.zeros((ROLE_COUNT, SIZE, SIZE), dtype=np.float32),
        frame_at(x, y, heading),
        MapConfig().limits(240 * 320),
        channels,
    )
    expected = turned_and_shifted(view[..., 0], x / CELL, y / CELL, heading)
    sure = (expected > 1e-4) | (expected == 0)
    assert sure.mean() > 0.95
    assert np.array_equal(channels.explored[sure], expected[sure] > 0)
    doubtful = np.abs(expected - 0.5) < 1e-3
    assert np.array_equal(channels.obstacle[~doubtful], expected[~doubtful] > 0.5)
    rows, columns = np.nonzero(channels.explored)
    assert box == ((rows.min(), columns.min(), rows.max(), columns.max()) if len(rows) else (SIDE, SIDE, -1, -1))
