"""Bodies that fall, come to rest and touch, on a home of a table, a sink, cups and a ball."""

import numpy as np
import pytest
from numpy.typing import NDArray
from worlds.filled import filled
from worlds.small_home import BALL, CUP, SINK, SINK_FLOOR, TABLE, TABLE_HEIGHT, instance, small_home

from uniteam.errors import UnknownNameError
from uniteam.geometry import pose_matrix, yaw_quaternion
from uniteam.world.homes.home import Instance
from uniteam.world.physics.physics import Physics

FURNITURE = (instance("table", TABLE, 1.0, 1.0), instance("sink", SINK, 2.5, 2.5, yaw=0.3))


def physics_of(*movable: Instance) -> Physics:
    return Physics(small_home(*FURNITURE, *movable))


def pose_at(x: float, y: float, z: float) -> NDArray[np.float64]:
    return pose_matrix(np.array([x, y, z]), np.array(yaw_quaternion(0.4)))


def test_ball_dropped_on_a_table_comes_to_rest_at_its_height() -> None:
    physics = physics_of(instance("ball", BALL, 1.0, 1.0, TABLE_HEIGHT + 0.1))
    assert not physics.is_at_rest("ball")
    assert physics.settle(seconds=5.0)
    assert physics.pose("ball")[2, 3] == pytest.approx(TABLE_HEIGHT, abs=0.004)
    assert physics.touching("ball") == {"table"}


def test_cup_dropped_into_a_sink_ends_inside_its_hollow() -> None:
    physics = physics_of(instance("cup", CUP, 2.5, 2.5, 1.0))
    assert physics.settle(["cup"])
    assert physics.pose("cup")[2, 3] == pytest.approx(SINK_FLOOR, abs=0.002)


def test_cup_released_beside_the_table_ends_on_the_floor() -> None:
    physics = physics_of(instance("cup", CUP, 3.5, 1.0, 0.3))
    assert physics.settle()
    contacts = physics.contacts("cup")
    assert {c.other for c in contacts} == {"floor"}
    assert max(abs(c.point[2]) for c in contacts) < 0.001
    assert all(c.penetration < 0.001 for c in contacts)


def test_cup_in_a_wall_is_seen_to_penetrate_it() -> None:
    physics = physics_of(instance("cup", CUP, 1.0, 0.06, 0.5))
    deepest = max(physics.contacts("cup"), key=lambda c: c.penetration)
    assert deepest.other == "wall"
    assert deepest.penetration == pytest.approx(0.03, abs=0.002)


def test_cup_on_another_falls_when_the_lower_is_taken_away() -> None:
    physics = physics_of(
        instance("lower", CUP, 1.0, 1.0, TABLE_HEIGHT), instance("upper", CUP, 1.0, 1.0, TABLE_HEIGHT + 0.1)
    )
    assert physics.settle()
    assert physics.touching("upper") == {"lower"}
    physics.remove("lower")
    assert physics.settle()
    assert physics.pose("upper")[2, 3] == pytest.approx(TABLE_HEIGHT, abs=0.002)
    assert not physics.is_moving


def test_removed_cup_comes_back_where_it_is_put_and_falls() -> None:
    physics = physics_of(instance("cup", CUP, 1.0, 1.0, TABLE_HEIGHT))
    physics.settle()
    physics.remove("cup")
    physics.advance(0.5)
    physics.set_pose("cup", pose_at(2.5, 2.5, 1.0))
    assert not physics.is_at_rest("cup")
    assert physics.settle()
    assert physics.pose("cup")[2, 3] == pytest.approx(SINK_FLOOR, abs=0.002)


def test_restored_physics_repeats_itself_to_the_bit() -> None:
    physics = physics_of(*(instance(f"ball_{k}", BALL, 0.8 + 0.03 * k, 1.0, 0.85 + 0.11 * k) for k in range(4)))
    physics.advance(0.1)
    state = physics.save()
    runs = []
    for _ in range(2):
        physics.restore(state)
        physics.advance(1.0)
        runs.append(np.array([physics.pose(name) for name in physics.names]))
    assert np.array_equal(runs[0], runs[1])


def test_two_copies_of_a_home_agree_to_the_bit() -> None:
    movable = [instance(f"cup_{k}", CUP, 2.4 + 0.05 * k, 2.5, 0.9 + 0.12 * k) for k in range(3)]
    one, two = physics_of(*movable), physics_of(*movable)
    for physics in (one, two):
        physics.advance(0.8)
    assert all(np.array_equal(one.pose(name), two.pose(name)) for name in filled(one.names))


@pytest.mark.parametrize(
    ("axis", "speed", "still"), [(1, 0.0045, True), (1, 0.0055, False), (5, 0.045, True), (5, 0.055, False)]
)
def test_a_body_is_still_below_the_challenges_speeds(axis: int, speed: float, still: bool) -> None:
    physics = physics_of(instance("cup", CUP, 1.0, 1.0, TABLE_HEIGHT))
    physics.remove("cup")  # weightless, it keeps its speed
    state = physics.save()
    state.data.qvel[axis] = speed
    physics.restore(state)
    assert not physics.is_still("cup")
    physics.advance(0.032)
    assert physics.is_still("cup") is still


def test_a_body_that_has_settled_is_still_and_sleeps() -> None:
    physics = physics_of(instance("cup", CUP, 1.0, 1.0, TABLE_HEIGHT + 0.05))
    physics.advance(0.1)
    assert not physics.is_still("cup")
    physics.settle()
    physics.advance(5.0)
    assert not physics.is_moving
    assert physics.is_still("cup")


def test_unknown_body_is_answered_with_the_nearest_name() -> None:
    with pytest.raises(UnknownNameError, match="ball_1"):
        physics_of(instance("ball_1", BALL, 1.0, 1.0, 1.0)).pose("bal_1")
