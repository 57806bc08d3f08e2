"""The oracle and what it drives by: paths, exact displacements, stands, points to put things down."""

import math
from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from worlds.small_home import CUP, TABLE, TABLE_HEIGHT, instance, small_home

from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose, invert_transform, transform_points
from uniteam.interface import BaseDisplacement
from uniteam.stretch import HEAD_CAMERA_HALF, MANIPULATION_POSTURE, gripper_to_base
from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import SupportSurface
from uniteam.world.certification.drop_points import LEAST_MARGIN, drop_points
from uniteam.world.oracle.base_driving import straight, to_point, turn
from uniteam.world.oracle.base_stands import Grasp, approach, can_grasp, grasps, manipulation_base, releases
from uniteam.world.oracle.oracle import Oracle
from uniteam.world.oracle.true_paths import PathField
from uniteam.world.physics.navigable_floor import NavigableFloor
from uniteam.world.simulation.robot_state import admissible
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Split
from uniteam.world.task.splits import load_split


@pytest.fixture(scope="module")
def split() -> Split:
    return load_split("minival")


@pytest.fixture(scope="module")
def floor(split: Split) -> NavigableFloor:
    return NavigableFloor(split.homes[split.episodes[0].home])


@pytest.mark.parametrize("number", [0, 3, 6])
def test_the_oracle_solves_certified_episodes(split: Split, number: int) -> None:
    episode = split.episodes[number]
    environment = Environment(split.homes[episode.home], episode)
    oracle = Oracle(environment)
    oracle.reset(episode.instruction, episode.seed)
    observation = environment.reset()
    while not environment.is_over:
        observation = environment.step(oracle.act(observation).action)
    assert environment.measures.overall_success, environment.measures
    assert environment.measures.partial_success == 1.0
    assert environment.measures.does_want_terminate


def test_the_oracle_refuses_an_episode_that_nobody_certified(split: Split) -> None:
    episode = replace(split.episodes[0], certificate=None)
    with pytest.raises(InvalidInputError, match="no certificate"):
        Oracle(Environment(split.homes[episode.home], episode))


def test_a_path_can_be_driven_from_end_to_end(floor: NavigableFloor) -> None:
    cells = np.argwhere(floor.largest_component & (floor.cells > 0.34))
    rng = np.random.default_rng(3)
    for _ in range(5):
        start, goal = (floor.to_point(*cells[i]) for i in rng.choice(len(cells), 2, replace=False))
        path = PathField(floor, goal).path_from(*start)
        assert path[-1] == goal
        for here, there in zip([start, *path], path, strict=False):
            assert floor.sweep(BasePose(*here, 0.0), *there)


def test_there_is_no_path_from_where_the_robot_cannot_be(floor: NavigableFloor) -> None:
    goal = floor.to_point(*np.argwhere(floor.largest_component)[0])
    inside_an_obstacle = floor.to_point(*np.argwhere(floor.cells == 0.0)[0])
    assert PathField(floor, goal).path_from(*inside_an_obstacle) == []


def _moved(base: BasePose, actions: list[BaseDisplacement]) -> BasePose:
    """Return where displacements bring the base when each is cut to its limits as the simulator does."""
    for action in actions:
        done = admissible(action)
        base = base.compose(BasePose(done.x, done.y, done.heading))
    return base


@pytest.mark.parametrize("angle", [0.03, -0.05, 0.0872, 1.0, -3.1])
def test_a_turn_is_exact_however_small(angle: float) -> None:
    assert _moved(BasePose(0, 0, 0), list(turn(angle))).heading == pytest.approx(angle)


@pytest.mark.parametrize("distance", [0.02, 0.099, 0.1, 0.5, 1.0, 1.05, 3.7])
def test_a_straight_move_is_exact_however_long(distance: float) -> None:
    end = _moved(BasePose(1.0, 2.0, 0.0), list(straight(distance)))
    assert (end.x, end.y) == (pytest.approx(1.0 + distance), 2.0)


def test_the_base_arrives_at_a_point() -> None:
    base = BasePose(1.0, 2.0, 2.5)
    end = _moved(base, list(to_point(base, (-0.4, 1.1))))
    assert (end.x, end.y) == (pytest.approx(-0.4), pytest.approx(1.1))


def test_a_grasp_stand_has_the_object_in_view_and_in_reach() -> None:
    position = np.array([1.0, 2.0, 0.8])
    around = np.array([[x, y] for x in np.arange(0.0, 2.0, 0.1) for y in np.arange(1.0, 3.0, 0.1)])
    found = list(grasps(position, around, HEAD_CAMERA_HALF))
    assert found[0].joints == MANIPULATION_POSTURE
    for grasp in found:
        to_base = invert_transform(manipulation_base(grasp.stand).matrix())
        from_gripper = transform_points(to_base, position) - gripper_to_base(grasp.joints)[:3, 3]
        assert np.linalg.norm(from_gripper) < 0.8
        assert grasp.stand.bearing_to(1.0, 2.0) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("height", [0.05, 1.45])
def test_there_are_grasps_for_what_lies_as_low_or_as_high_as_homes_have_it(height: float) -> None:
    around = np.array([[x, y] for x in np.arange(-1.0, 1.1, 0.1) for y in np.arange(-1.0, 1.1, 0.1)])
    around = around[np.hypot(*around.T) >= 0.5]
    assert list(grasps(np.array([0.0, 0.0, height]), around, HEAD_CAMERA_HALF))


def test_grasps_of_one_posture_come_from_several_sides() -> None:
    around = np.array([[x, y] for x in np.arange(-1.0, 1.1, 0.1) for y in np.arange(-1.0, 1.1, 0.1)])
    usual = [g for g in grasps(np.array([0.0, 0.0, 0.8]), around, HEAD_CAMERA_HALF) if g.joints == MANIPULATION_POSTURE]
    assert len(usual) > 2
    gaps = [one.stand.distance_to(other.stand.x, other.stand.y) for one, other in combinations(usual, 2)]
    assert min(gaps) >= 0.2 and max(gaps) >= 0.8


def test_the_arm_comes_from_above_where_it_is_asked_to() -> None:
    joints = replace(MANIPULATION_POSTURE, lift=0.6, arm=0.3, wrist_pitch=0.0)
    assert approach(joints, 0.0)[-1] == joints
    *_, over, down = approach(joints, 0.25)
    assert (over.lift, down) == (pytest.approx(0.85), joints)
    assert replace(over, lift=0.6) == joints


@pytest.mark.parametrize(
    ("heading", "position", "reached"),
    [(0.0, (0.6, 0.0, 0.7), True), (0.0, (1.3, 0.0, 0.7), False), (0.0, (0.75, 0.0, 0.0), True),
     (0.0, (0.15, 0.0, 0.0), False), (0.0, (0.6, 0.0, 1.5), False),
     (math.pi, (0.6, 0.0, 0.7), False)],
)  # fmt: skip
def test_what_lies_too_far_or_behind_or_out_of_the_picture_cannot_be_grasped(
    heading: float, position: tuple[float, ...], reached: bool
) -> None:
    grasp = Grasp(BasePose(0.0, 0.0, heading), MANIPULATION_POSTURE)
    assert can_grasp(grasp, np.array(position), HEAD_CAMERA_HALF) is reached


@pytest.mark.parametrize("pitch", [MANIPULATION_POSTURE.wrist_pitch, 0.0])
def test_a_release_holds_the_gripper_over_the_point(pitch: float) -> None:
    point = np.array([1.0, 2.0])
    around = np.array([[1.0 + 0.1 * i, 2.0 + 0.1 * j] for i in range(-8, 9) for j in range(-8, 9)])
    found = releases(point, around, 0.85, pitch)
    assert found
    for release in found:
        gripper = manipulation_base(release.stand).matrix() @ gripper_to_base(release.joints)
        assert gripper[:3, 3] == pytest.approx([1.0, 2.0, 0.85])


def test_nothing_can_be_released_higher_than_the_lift_goes() -> None:
    assert releases(np.array([1.0, 2.0]), np.array([[1.0, 1.5]]), 1.6, MANIPULATION_POSTURE.wrist_pitch) == []


def test_drop_points_lie_on_the_furniture_and_clear_of_what_stands_there() -> None:
    outline = ((-0.6, -0.4), (0.6, -0.4), (0.6, 0.4), (-0.6, 0.4))
    table = replace(TABLE, surfaces=(SupportSurface(TABLE_HEIGHT, outline, 1.5),))
    standing, cup = instance("table", table, 2.0, 1.5, yaw=0.4), instance("cup", CUP, 2.1, 1.6, TABLE_HEIGHT)
    home = small_home(standing, cup, library=Catalogue({"table": table, "cup": CUP}, frozenset()))
    (surface,) = drop_points(home, standing)
    assert surface.height == pytest.approx(TABLE_HEIGHT)
    assert len(surface.points) > 50
    in_world = np.column_stack([surface.points, np.full(len(surface.points), surface.height)])
    in_model = transform_points(invert_transform(standing.model_to_world()), in_world)
    assert np.all(np.abs(in_model[:, :2]) <= np.array([0.6, 0.4]) - LEAST_MARGIN + 1e-6)
    from_cup = np.linalg.norm(surface.points - cup.position[:2], axis=1)
    assert LEAST_MARGIN < from_cup.min() < 0.2
