"""Distance fields against fast marching and a plain heap, and paths that keep between obstacles."""

import heapq
from collections.abc import Callable

import numpy as np
import pytest
import skfmm
from numpy.typing import NDArray

from uniteam.grid import Mask, disc_mask
from uniteam.mind.navigation.planning.bucket_queue import FAR, spread
from uniteam.mind.navigation.planning.distance_field import (
    COST_PER_CELL,
    distance_field,
    nearer_than,
    nearest_target,
    straight_distance,
    trace_path,
)
from uniteam.mind.navigation.planning.short_term_goal import find_short_term_goal, line_is_free
from uniteam.mind.navigation.planning.traversible import connected_to

CELL = 0.05


def alike(free: Mask) -> NDArray[np.uint8]:
    return np.ones(free.shape, dtype=np.uint8)


def cluttered(seed: int, size: int = 240) -> Mask:
    """Return free cells: rooms with doors, and discs strewn about."""
    free = np.ones((size, size), dtype=np.bool_)
    free[80, :] = free[:, 120] = free[160, 60:] = False
    free[80, 30:48] = free[80, 180:200] = free[40:58, 120] = free[200:220, 120] = free[110:126, 120] = True
    generator = np.random.default_rng(seed)
    for row, column in generator.integers(10, size - 10, (25, 2)):
        free &= ~disc_mask(free.shape, (row, column), int(generator.integers(2, 8)))
    return free


def fast_marching(free: Mask, source: Mask) -> np.ndarray:
    """Return distances by fast marching on cells a third as large: behind corners it converges but slowly."""
    fine_free, fine_source = (np.kron(mask, np.ones((3, 3), dtype=np.bool_)) for mask in (free, source))
    phi = np.ma.MaskedArray(np.where(fine_source, -1.0, 1.0), ~fine_free)
    return skfmm.distance(phi, dx=CELL / 3, order=2).filled(np.inf)[1::3, 1::3]


@pytest.mark.parametrize("seed", [1, 2])
def test_distances_agree_with_fast_marching_among_obstacles(seed: int) -> None:
    free = cluttered(seed)
    source = disc_mask(free.shape, (20, 20), 3)
    free |= source
    reference = fast_marching(free, source)
    ours = distance_field(free, source, CELL)
    reached = free & np.isfinite(reference) & np.isfinite(ours)
    assert reached.sum() > 0.9 * free.sum()
    far = reached & (reference > 1.0)
    # The reference is measured from the rim of the source, half a cell from the centre of its last cell.
    error = np.abs(ours[far] - CELL / 2 - reference[far]) / reference[far]
    assert error.mean() < 0.01
    assert error.max() < 0.04


def test_in_the_open_distances_are_those_of_a_straight_line() -> None:
    free = np.ones((201, 201), dtype=np.bool_)
    source = np.zeros_like(free)
    source[100, 100] = True
    rows, columns = np.indices(free.shape) - 100
    straight = np.hypot(rows, columns)[straight_mask(rows, columns)] * CELL
    error = distance_field(free, source, CELL)[straight_mask(rows, columns)] / straight - 1.0
    assert np.abs(error).mean() < 0.01
    assert np.abs(error).max() < 0.025


def straight_mask(rows: np.ndarray, columns: np.ndarray) -> Mask:
    return np.hypot(rows, columns) > 20


def test_what_walls_shut_off_is_infinitely_far() -> None:
    free = np.ones((40, 40), dtype=np.bool_)
    free[:, 20] = False
    source = np.zeros_like(free)
    source[5, 5] = True
    field = distance_field(free, source, CELL)
    assert np.isfinite(field[:, :20]).all()
    assert np.isinf(field[:, 20:]).all()


def test_no_path_slips_through_a_diagonal_wall() -> None:
    free = ~np.eye(40, dtype=np.bool_)
    source = np.zeros_like(free)
    source[30, 5] = True
    field = distance_field(free, source, CELL)
    assert np.isinf(field[5, 30])


def test_several_sources_give_the_nearest_ones_distance() -> None:
    free = cluttered(3)
    a, b = np.zeros_like(free), np.zeros_like(free)
    a[20, 20] = b[200, 200] = True
    both = distance_field(free, a | b, CELL)
    assert (both == np.minimum(distance_field(free, a, CELL), distance_field(free, b, CELL))).all()


def by_heap(free: Mask, prices: NDArray[np.uint8], sources: Mask) -> dict[tuple[int, int], int]:
    """Return the least costs by Dijkstra's algorithm with the weights and the rules of `distance_field`."""
    knights = [(r, c) for r in (-2, -1, 1, 2) for c in (-2, -1, 1, 2) if abs(r) != abs(c)]
    steps = [(r, c) for r in (-1, 0, 1) for c in (-1, 0, 1) if r or c] + knights
    costs = {(int(row), int(column)): 0 for row, column in np.argwhere(sources)}
    heap = [(0, cell) for cell in costs]
    is_free = np.pad(free, (0, 2))
    may_pass: dict[int, Callable[[tuple[bool, bool]], bool]] = {1: lambda _: True, 2: any, 3: all}
    while heap:
        cost, (row, column) = heapq.heappop(heap)
        for r, c in steps:
            half_r, half_c = int(r / 2), int(c / 2)
            passed = is_free[row + half_r, column + c - half_c], is_free[row + r - half_r, column + half_c]
            if not (is_free[row + r, column + c] and may_pass[abs(r) + abs(c)](passed)):
                continue
            reached = cost + {1: 5, 2: 7, 3: 11}[abs(r) + abs(c)] * int(prices[row + r, column + c])
            if reached < costs.get((row + r, column + c), FAR):
                costs[row + r, column + c] = reached
                heapq.heappush(heap, (reached, (row + r, column + c)))
    return costs


@pytest.mark.parametrize("every", [7, 140])
def test_costs_are_those_of_a_plain_heap_however_many_cells_wait(every: int) -> None:
    """A source in every seventh row and column has more cells wait at one cost than there is room for at first."""
    generator = np.random.default_rng(every)
    free = generator.random((140, 140)) > 0.1
    prices = generator.integers(1, 4, free.shape).astype(np.uint8)
    sources = np.zeros_like(free)
    sources[::every, ::every] = True
    costs, row, column = spread(free, prices, sources, np.zeros_like(free))
    expected = np.full(free.shape, FAR)
    for cell, cost in by_heap(free, prices, sources).items():
        expected[cell] = cost
    assert (row, column) == (-1, -1)
    assert (costs == expected).all()


def test_a_search_stops_at_the_nearest_target_with_the_same_cost_as_the_whole_field() -> None:
    free = cluttered(4)
    targets = np.zeros_like(free)
    targets[[100, 150, 220], [60, 200, 30]] = True
    targets &= free
    reach = nearest_target(free, alike(free), (20, 20), targets)
    source = np.zeros_like(free)
    source[20, 20] = True
    field = distance_field(free, source, CELL)
    assert reach.costs[reach.target] * CELL / COST_PER_CELL == pytest.approx(field[targets].min(), rel=1e-5)
    assert (reach.costs == 1 << 30).sum() > (~np.isfinite(field)).sum()


def test_a_path_keeps_to_free_cells_from_start_to_target() -> None:
    free = cluttered(5)
    targets = np.zeros_like(free)
    targets[disc_mask(free.shape, (225, 225), 4)] = True
    reach = nearest_target(free, alike(free), (20, 20), targets & free)
    path = trace_path(free, alike(free), reach, reach.target)
    assert tuple(path[0]) == (20, 20)
    assert tuple(path[-1]) == reach.target
    assert free[path[:, 0], path[:, 1]].all()
    assert np.abs(np.diff(path, axis=0)).max() <= 2


def test_the_search_reaches_just_what_the_sides_of_cells_connect() -> None:
    free = np.random.default_rng(0).random((120, 120)) > 0.38
    free[60, 60] = True
    source = np.zeros_like(free)
    source[60, 60] = True
    assert (np.isfinite(distance_field(free, source, CELL)) == connected_to((60, 60), free)).all()


@pytest.mark.parametrize("distance", [0.5, 0.72, 1.0])
def test_what_is_nearer_than_a_distance_is_what_the_distances_say(distance: float) -> None:
    cells = np.random.default_rng(1).random((90, 70)) < 0.002
    near = straight_distance(cells, CELL) < distance
    assert 0.1 < near.mean() < 0.9
    assert np.array_equal(nearer_than(distance, cells, CELL), near)


def test_the_short_term_goal_looks_ahead_and_not_through_walls() -> None:
    free = np.ones((60, 60), dtype=np.bool_)
    free[30, :40] = False
    targets = np.zeros_like(free)
    targets[40, 5] = True
    reach = nearest_target(free, alike(free), (10, 5), targets)
    path = trace_path(free, alike(free), reach, reach.target)
    ahead = np.array(find_short_term_goal(free, path, 5).cell)
    assert 4.0 < np.hypot(*(ahead - (10, 5))) < 6.0
    assert line_is_free(free, path[0], ahead)
    assert ahead[1] > 5
    assert not line_is_free(free, path[0], path[-1])


def test_at_a_bend_the_short_term_goal_is_still_a_whole_step_away() -> None:
    free = np.ones((40, 40), dtype=np.bool_)
    free[11:, :] = False
    free[10:30, 12] = True
    targets = np.zeros_like(free)
    targets[28, 12] = True
    reach = nearest_target(free, alike(free), (10, 11), targets)
    path = trace_path(free, alike(free), reach, reach.target)
    ahead = np.array(find_short_term_goal(free, path, 5).cell)
    assert 4.0 < np.hypot(*(ahead - (10, 11))) < 6.0
    assert ahead[0] >= 14


@pytest.mark.parametrize("place", [(60, 70), (0, 3), (119, 90)])
def test_straight_distances_are_the_same_however_far_they_are_looked_for(place: tuple[int, int]) -> None:
    cells = disc_mask((120, 91), place, 4)
    cells[30:33, 80] = True
    everywhere = straight_distance(cells, CELL)
    assert np.isfinite(everywhere).all() and everywhere.max() > 2.0
    for farthest in (0.0, 0.33, 1.0):
        near = straight_distance(cells, CELL, farthest)
        is_near = everywhere <= farthest
        assert np.array_equal(near[is_near], everywhere[is_near])
        assert (near[~is_near] > farthest).all()
    assert np.isinf(straight_distance(cells & False, CELL, 1.0)).all()
