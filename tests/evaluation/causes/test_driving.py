"""Where the base did not get away, and walls in between."""

import numpy as np
import pytest
from worlds.small_home import CUP, TABLE, instance, small_home

from uniteam.evaluation.causes.reading.driving import read_standstill, width_of_way
from uniteam.evaluation.causes.reading.places import distances_to, is_wall_between, nearest_to, to_rectangle


def test_the_longest_time_near_a_place_is_found_with_what_was_in_the_way() -> None:
    there = np.column_stack([np.linspace(0.0, 5.0, 11), np.zeros(11)])
    swinging = np.array([(5.0 + 0.4 * (k % 2), 0.0) for k in range(30)])
    back = np.column_stack([np.linspace(5.0, 0.0, 11), np.zeros(11)])
    bases = np.concatenate([there, swinging, back])
    blocked = [11 <= k < 21 for k in range(len(bases) - 1)]
    still = read_standstill(bases, blocked)
    assert still is not None
    assert still.place == (4.5, 0.0) and (still.first, still.last) == (9, 44)
    assert still.blocked == 10 and still.steps == 36
    assert read_standstill(bases[:1], []) is None


def test_a_wall_is_between_two_points_but_not_through_its_door() -> None:
    home = small_home()
    assert is_wall_between(home, (3.5, 1.0), (4.5, 1.0), 0.8)
    assert not is_wall_between(home, (3.5, 2.0), (4.5, 2.0), 0.8)
    assert is_wall_between(home, (3.5, 2.0), (4.5, 2.0), 2.2)
    assert is_wall_between(home, (3.5, 1.0), (4.5, 1.9), 0.8)
    assert not is_wall_between(home, (3.5, 1.0), (3.9, 1.0), 0.8)
    assert not is_wall_between(home, (3.8, 0.5), (3.8, 3.5), 0.8)


def test_a_way_is_as_wide_as_its_narrowest_place() -> None:
    table = instance("table_1", TABLE, 6.0, 1.4)
    home = small_home(table, instance("cup_1", CUP, 6.0, 1.4, 0.75))
    assert width_of_way(home, {}, (2.0, 2.0), [(6.0, 2.3)]) == pytest.approx(0.9, abs=0.05)
    on_the_floor = np.eye(4)
    on_the_floor[:3, 3] = 4.0, 1.6, 0.0
    narrowed = width_of_way(home, {"cup_1": on_the_floor}, (2.0, 2.0), [(6.0, 2.3)])
    assert narrowed == pytest.approx(0.9 - 0.14, abs=0.05)
    assert width_of_way(home, {}, (2.0, 2.0), [(9.0, 2.0)]) == 0.0


def test_distances_are_to_the_rectangle_and_exactly_0_within() -> None:
    piece = instance("table_1", TABLE, 2.0, 2.0, yaw=0.5)
    home = small_home(piece)
    width, depth, _ = home.model_of(piece).size
    to_world = piece.model_to_world()
    own = np.array([[width / 2 + 0.3, 0.0], [width / 2 + 0.3, depth / 2 + 0.4], [0.1 * width, -0.1 * depth]])
    points = own @ to_world[:2, :2].T + to_world[:2, 3]
    found = distances_to(home, piece, points)
    assert np.allclose(found, [0.3, 0.5, 0.0]) and found[2] == 0.0
    assert np.allclose(np.hypot(*(to_rectangle(home, piece, points) - points).T), found)


def test_a_base_behind_a_wall_is_not_near() -> None:
    table = instance("table_1", TABLE, 4.8, 0.8)
    home = small_home(table)
    beyond, in_the_door, within = (3.7, 0.8), (4.0, 2.0), (6.4, 0.8)
    assert nearest_to(home, table, np.array([beyond, in_the_door, within])) == (1, pytest.approx(0.8246, abs=1e-3))
    assert nearest_to(home, table, np.array([within, beyond])) == (0, pytest.approx(1.0))
    moment, distance = nearest_to(home, table, np.array([beyond, beyond]))
    assert (moment, distance) == (0, np.inf)
