"""The clearance grid of the floor, on a home of two rooms."""

import math
from dataclasses import replace

import numpy as np
import pytest
from worlds.small_home import BALL, CATALOGUE, SINK, TABLE, instance, small_home

from uniteam.geometry import BasePose
from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import Box
from uniteam.world.homes.home import Instance
from uniteam.world.physics.navigable_floor import NavigableFloor


def floor_of(*instances: Instance, library: Catalogue = CATALOGUE) -> NavigableFloor:
    return NavigableFloor(small_home(*instances, library=library))


def test_clearance_is_the_distance_to_the_nearest_wall_or_furniture() -> None:
    floor = floor_of(instance("sink", SINK, 2.0, 2.0))
    assert floor.clearance(1.3, 1.3) == pytest.approx(math.hypot(0.4, 0.45), abs=0.015)
    assert floor.clearance(0.5, 2.0) == pytest.approx(0.45, abs=0.015)
    assert floor.clearance(2.0, 2.0) == 0.0
    assert floor.clearance(-3.0, 2.0) == 0.0


def test_turned_furniture_is_measured_where_it_stands() -> None:
    floor = floor_of(instance("sink", SINK, 2.0, 2.0, yaw=math.pi / 2))
    assert floor.clearance(2.0, 1.2) == pytest.approx(0.5, abs=0.015)
    assert floor.clearance(1.25, 2.0) == pytest.approx(0.5, abs=0.015)


def test_base_passes_a_door_through_its_middle_only() -> None:
    floor = floor_of()
    assert floor.sweep(BasePose(3.0, 1.95, 0.0), 5.0, 1.95)
    assert not floor.sweep(BasePose(3.0, 1.7, 0.0), 5.0, 1.7)
    assert not floor.sweep(BasePose(3.0, 3.0, 0.0), 5.0, 3.0)


def test_table_holds_the_mast_back_though_its_legs_stand_apart() -> None:
    floor = floor_of(instance("table", TABLE, 2.0, 2.0))
    assert not floor.is_free(2.0, 2.0)
    assert not floor.is_free(2.0, 1.35)
    assert floor.is_free(2.0, 1.25)


def test_ball_on_the_floor_is_an_obstacle_and_a_rug_is_not() -> None:
    rug = replace(TABLE, id="rug", shapes=(Box((0.0, 0.0, 0.005), (1.0, 1.0, 0.01)),))
    library = Catalogue({**CATALOGUE.models, "rug": rug}, frozenset())
    floor = floor_of(instance("rug", rug, 1.0, 1.0), instance("ball", BALL, 3.0, 3.0), library=library)
    assert floor.clearance(1.0, 1.0) == pytest.approx(0.95, abs=0.015)
    assert not floor.is_free(3.0, 2.7)


def test_what_hangs_higher_than_the_robot_is_no_obstacle() -> None:
    lamp = replace(TABLE, id="lamp", shapes=(Box((0.0, 0.0, 1.6), (0.5, 0.5, 0.3)),))
    floor = floor_of(instance("l", lamp, 2.0, 2.0), library=Catalogue({"lamp": lamp}, frozenset()))
    assert floor.is_free(2.0, 2.0)


def test_base_stuck_too_near_a_wall_may_move_away_but_not_nearer() -> None:
    floor = floor_of()
    stuck = BasePose(0.3, 2.0, 0.0)
    assert floor.sweep(stuck, 0.6, 2.0)
    assert not floor.sweep(stuck, 0.25, 2.0)


def test_largest_component_joins_rooms_through_the_door_and_cells_map_to_points() -> None:
    floor = floor_of()
    for x in (1.0, 7.0):
        row, column = floor.to_cell(x, 2.0)
        assert floor.largest_component[row, column]
        assert np.hypot(*np.subtract(floor.to_point(row, column), (x, 2.0))) < 0.015
    assert floor.largest_component.sum() * 0.02**2 == pytest.approx(2 * 3.3 * 3.3 + 0.3 * 0.7, rel=0.02)


def test_an_object_that_was_moved_is_in_the_way_where_it_is_now() -> None:
    home = small_home(instance("ball", BALL, 3.0, 3.0))
    before = NavigableFloor(home)
    assert not before.is_free(3.0, 2.8)
    pose = home.by_name["ball"].model_to_world()
    pose[:2, 3] = (1.0, 1.0)
    after = before.with_moved(home, {"ball": pose})
    assert after.is_free(3.0, 2.8)
    assert not after.is_free(1.0, 1.2)
    assert np.array_equal(after.cells, floor_of(instance("ball", BALL, 1.0, 1.0)).cells)
    pose[2, 3] = 50.0
    assert after.with_moved(home, {"ball": pose}).is_free(1.0, 1.2)
    assert not before.is_free(3.0, 2.8), "the floor before stays as it was"
