"""The measures, phase by phase, in a room: each is judged on either side of every number that it depends on."""

import math
from dataclasses import replace

import numpy as np
import pytest
from worlds.judged_scene import (
    CARRIED,
    CUP_INDEX,
    CUP_VIEW,
    EPISODE,
    FOUND,
    ON_THE_TABLE,
    OTHER_INDEX,
    PICKED,
    TABLE_INDEX,
    TABLE_VIEW,
    Judged,
    judged_home,
)
from worlds.small_home import TABLE, TABLE_HEIGHT, instance, small_home

from uniteam.errors import InvalidInputError
from uniteam.geometry import pose_matrix
from uniteam.interface import DiscreteAction
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.world.simulation.graspable import TAKE_NOTHING, GraspRule
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.simulation.touches import Touches
from uniteam.world.task.episode import Candidate
from uniteam.world.task.footprint import distance_to_footprint
from uniteam.world.task.judge import Judge, lies_on, rests_on
from uniteam.world.task.measures import Measures

ENOUGH = 77
"""Pixels: 0.1 % of 240 x 320 are 76.8."""


@pytest.fixture(scope="module")
def simulator(tmp_path_factory: pytest.TempPathFactory) -> Simulator:
    return Simulator(judged_home(tmp_path_factory.mktemp("models")), HEAD_CAMERA_HALF)


@pytest.mark.parametrize(
    ("away", "pixels", "index", "found"),
    [
        (0.08, ENOUGH, CUP_INDEX, True),
        (0.12, ENOUGH, CUP_INDEX, False),
        (0.0, ENOUGH - 1, CUP_INDEX, False),
        (0.0, ENOUGH, OTHER_INDEX, False),
    ],
)
def test_an_object_is_found_at_a_view_point_where_it_covers_a_thousandth_of_the_image(
    simulator: Simulator, away: float, pixels: int, index: int, found: bool
) -> None:
    judged = Judged.begin(simulator, Measures())
    judged.stand(CUP_VIEW[0], CUP_VIEW[1] + away)
    assert judged.see(pixels, index).find_object_phase_success is found


def test_what_has_been_found_stays_found(simulator: Simulator) -> None:
    judged = Judged.begin(simulator, Measures())
    judged.stand(*CUP_VIEW)
    judged.see(ENOUGH, CUP_INDEX)
    assert judged.see(0, CUP_INDEX).find_object_phase_success


def _hold(judged: Judged, name: str) -> None:
    """Put a cup before the arm and have the gripper take it."""
    x, y, _ = judged.simulator.gripper_to_world()[:3, 3]
    judged.put(name, float(x), float(y), 0.3)
    for action in (DiscreteAction.MANIPULATION_MODE, DiscreteAction.SNAP_OBJECT):
        judged.simulator.apply(action, GraspRule(lambda things: name))
    assert judged.simulator.held == name


@pytest.mark.parametrize(
    ("reached", "name", "picked"), [(FOUND, "cup", True), (FOUND, "other_cup", False), (Measures(), "cup", False)]
)
def test_a_candidate_that_was_found_is_picked_once_it_is_held(
    simulator: Simulator, reached: Measures, name: str, picked: bool
) -> None:
    judged = Judged.begin(simulator, reached)
    _hold(judged, name)
    assert judged.see(0, 0).pick_object_phase_success is picked


def test_an_object_that_is_found_while_it_is_held_is_picked_then(simulator: Simulator) -> None:
    judged = Judged.begin(simulator, Measures())
    judged.stand(*CUP_VIEW)
    _hold(judged, "cup")
    assert not judged.see(0, CUP_INDEX).pick_object_phase_success
    assert judged.see(ENOUGH, CUP_INDEX).pick_object_phase_success


@pytest.mark.parametrize(
    ("reached", "away", "pixels", "found"),
    [
        (PICKED, 0.08, ENOUGH, True),
        (PICKED, 0.12, ENOUGH, False),
        (PICKED, 0.0, ENOUGH - 1, False),
        (FOUND, 0.0, ENOUGH, False),
    ],
)
def test_a_receptacle_is_found_in_the_same_way_and_only_after_the_pick(
    simulator: Simulator, reached: Measures, away: float, pixels: int, found: bool
) -> None:
    judged = Judged.begin(simulator, reached)
    judged.stand(TABLE_VIEW[0], TABLE_VIEW[1] + away)
    assert judged.see(pixels, TABLE_INDEX).find_recep_phase_success is found


def _put_down(simulator: Simulator, reached: Measures = CARRIED) -> Judged:
    """Let go of the cup on the table, where it lies still after a few steps."""
    judged = Judged.begin(simulator, reached)
    judged.put("cup", *ON_THE_TABLE)
    judged.release()
    for _ in range(20):
        simulator.physics.advance(0.032)
    assert rests_on(simulator, "cup", {"table"})
    return judged


def test_an_object_is_placed_after_it_has_rested_for_fifty_steps_in_a_row(simulator: Simulator) -> None:
    judged = _put_down(simulator)
    assert not judged.wait(49).place_success
    assert judged.wait(1).place_success


def test_the_fifty_steps_begin_anew_when_the_object_moves(simulator: Simulator) -> None:
    judged = _put_down(simulator)
    judged.wait(45)
    x, y, z = ON_THE_TABLE
    judged.put("cup", x + 0.1, y, z + 0.05)
    assert not judged.wait(50).place_success
    assert judged.wait(40).place_success


def test_what_was_placed_stays_placed(simulator: Simulator) -> None:
    judged = _put_down(simulator)
    judged.wait(50)
    judged.put("cup", 3.5, 3.5, 0.0)
    assert judged.wait(60).place_success


def test_nothing_is_placed_before_the_receptacle_was_found(simulator: Simulator) -> None:
    assert not _put_down(simulator, PICKED).wait(60).place_success


def test_a_receptacle_that_is_found_while_the_object_rests_on_it_makes_it_placed(simulator: Simulator) -> None:
    judged = _put_down(simulator, PICKED)
    judged.wait(60)
    simulator.apply(DiscreteAction.EMPTY_ACTION, TAKE_NOTHING)
    judged.judge.measures = CARRIED
    assert judged.wait(1).place_success


def test_an_object_that_nobody_let_go_of_is_not_placed(simulator: Simulator) -> None:
    judged = Judged.begin(simulator)
    judged.put("cup", *ON_THE_TABLE)
    assert not judged.wait(80).place_success


def test_a_wrong_object_on_the_goal_is_not_placed(simulator: Simulator) -> None:
    judged = Judged.begin(simulator)
    judged.put("other_cup", *ON_THE_TABLE)
    judged.release("other_cup")
    assert not judged.wait(80).place_success


def test_nothing_is_placed_as_long_as_the_gripper_holds_something(simulator: Simulator) -> None:
    judged = Judged.begin(simulator)
    _hold(judged, "other_cup")
    judged.put("cup", *ON_THE_TABLE)
    judged.release()
    assert not judged.wait(80).place_success


def test_an_object_on_the_floor_is_not_placed(simulator: Simulator) -> None:
    judged = Judged.begin(simulator)
    judged.put("cup", 3.0, 3.0, 0.0)
    judged.release()
    assert not judged.wait(80).place_success


@pytest.mark.parametrize(("depth", "lies"), [(0.0085, True), (0.0115, False)])
def test_what_is_sunk_in_by_more_than_a_centimetre_does_not_lie_on_it(
    simulator: Simulator, depth: float, lies: bool
) -> None:
    judged = Judged.begin(simulator)
    judged.put("cup", 2.0, 1.0, TABLE_HEIGHT - depth)
    assert lies_on(simulator.physics.contacts("cup"), {"table"}) is lies


@pytest.mark.parametrize(
    ("name", "x", "y", "height", "lies"),
    [("low_board", 6.0, 1.0, 0.042, False), ("high_board", 6.0, 3.0, 0.058, True)],
)
def test_what_lies_lower_than_five_centimetres_lies_on_nothing(
    simulator: Simulator, name: str, x: float, y: float, height: float, lies: bool
) -> None:
    judged = Judged.begin(simulator)
    judged.put("cup", x, y, height - 0.001)
    contacts = simulator.physics.contacts("cup")
    assert {contact.other for contact in contacts} == {name}
    assert lies_on(contacts, {name}) is lies


def test_a_ball_that_rolls_on_a_table_does_not_rest_on_it(simulator: Simulator) -> None:
    judged = Judged.begin(simulator)
    judged.put("ball", *ON_THE_TABLE)
    state = simulator.physics.save()
    first = 6 * simulator.physics.names.index("ball")
    state.data.qvel[first] = 0.2
    simulator.physics.restore(state)
    simulator.physics.advance(0.032)
    assert lies_on(simulator.physics.contacts("ball"), {"table"})
    assert not rests_on(simulator, "ball", {"table"})


def test_steps_that_touch_are_counted_by_their_kind_and_only_the_robot_s_cost_the_success(
    simulator: Simulator,
) -> None:
    judged = Judged.begin(simulator, replace(CARRIED, place_success=True))
    for touches in (Touches(obj_scene="wall"), Touches(robot_obj="cup"), Touches(robot_obj="cup"), Touches()):
        judged.touch(touches)
    assert judged.judge.measures.overall_success
    measures = judged.touch(Touches("wall", "wall", "cup"))
    assert (measures.robot_scene_colls, measures.obj_scene_colls, measures.robot_obj_colls) == (1, 2, 3)
    assert measures.num_steps == 5
    assert not measures.overall_success
    assert measures.partial_success == 0.75


def test_an_episode_about_what_the_home_lacks_is_refused(simulator: Simulator) -> None:
    with pytest.raises(InvalidInputError, match="plate"):
        Judge(simulator.home, replace(EPISODE, objects=(Candidate("plate", (CUP_VIEW,)),)))


def test_the_distance_to_furniture_is_that_to_its_turned_rectangle() -> None:
    turned = instance("table", TABLE, 1.0, 2.0, yaw=0.8)
    home = small_home(turned)
    to_world = turned.model_to_world()
    width, depth, _ = TABLE.size
    beside = (to_world @ [width / 2 + 0.7, 0.1, 0.0, 1.0])[:2]
    corner = (to_world @ [width / 2 + 0.3, depth / 2 + 0.4, 0.0, 1.0])[:2]
    inside = (to_world @ [0.0, depth / 2 - 0.01, 0.0, 1.0])[:2]
    distances = distance_to_footprint(home, turned, np.array([beside, corner, inside]))
    assert distances == pytest.approx([0.7, 0.5, 0.0])


def test_the_footprint_of_what_has_fallen_over_is_that_of_its_side() -> None:
    half_turn = math.pi / 4
    fallen = replace(
        instance("table", TABLE, 1.0, 2.0), quaternion=(math.cos(half_turn), 0.0, math.sin(half_turn), 0.0)
    )
    to_world = pose_matrix(np.array(fallen.position), np.array(fallen.quaternion))
    assert to_world[0, 2] == pytest.approx(1.0)
    home = small_home(fallen)
    points = np.array([[1.0 + TABLE.size[2] + 0.4, 2.0], [1.0 + 0.1, 2.0], [0.5, 2.0]])
    assert distance_to_footprint(home, fallen, points) == pytest.approx([0.4, 0.0, 0.5])
