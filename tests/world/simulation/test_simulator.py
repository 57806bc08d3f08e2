"""What each action does to the robot and to the objects, in a home of two rooms furnished from the pack."""

import gc
import math
import weakref
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from worlds.filled import filled
from worlds.small_home import small_home

from uniteam.geometry import BasePose
from uniteam.interface import Action, BaseDisplacement, DiscreteAction, JointDisplacement, Joints
from uniteam.stretch import HEAD_CAMERA_HALF, MANIPULATION_POSTURE, NAVIGATION_POSTURE, head_camera_to_base
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.homes.home import Home, Instance
from uniteam.world.rendering.camera import render
from uniteam.world.rendering.meshes.robot_mesh import part_poses, robot_parts
from uniteam.world.rendering.scene import Scene
from uniteam.world.simulation.graspable import Graspable, GraspRule
from uniteam.world.simulation.gripper import Gripper
from uniteam.world.simulation.robot_state import RobotState
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.simulation.step_events import StepEvents
from uniteam.world.task.grasp_rules import take_candidate

A = DiscreteAction
TABLE, SINK, MUG, BOWL = "table_et_table", "sink_et_sink", "cup_kl_coffee_mug", "bowl_sc_bowl_with_salad"
TABLE_HEIGHT = 0.74
BEFORE_TABLE = BasePose(2.1, 2.6, math.pi / 2)
BEFORE_SINK = BasePose(6.1, 2.7, math.pi / 2)
CUPS = take_candidate("cup", ("mug_far", "mug_near", "mug_sink"))
RAISED = JointDisplacement(Joints(lift=0.3, arm=0.0, wrist_pitch=1.5))


def placed(name: str, model: str, x: float, y: float, z: float = 0.0) -> Instance:
    entry = load_catalogue()[model]
    return Instance(name, model, entry.category, entry.role == "object", (x, y, z), (1.0, 0.0, 0.0, 0.0), "west")


def furnished_home() -> Home:
    home = small_home(
        placed("table_1", TABLE, 2.0, 3.55),
        placed("sink_1", SINK, 6.0, 3.6),
        placed("mug_far", MUG, 1.8, 3.45, TABLE_HEIGHT),
        placed("mug_near", MUG, 2.1, 3.3, TABLE_HEIGHT),
        placed("mug_behind", MUG, 2.1, 2.0, 0.0),
        placed("mug_sink", MUG, 6.4, 3.45, 0.85),
        placed("bowl_1", BOWL, 2.5, 3.4, TABLE_HEIGHT),
        library=load_catalogue(),
    )
    floor, wall = home.library.texture_names("floor")[0], home.library.texture_names("wall")[0]
    rooms = tuple(replace(room, floor_texture=floor, wall_texture=wall) for room in home.stage.rooms)
    return replace(home, stage=replace(home.stage, rooms=rooms))


@pytest.fixture(scope="module")
def shared() -> Simulator:
    return Simulator(furnished_home(), HEAD_CAMERA_HALF)


@pytest.fixture
def simulator(shared: Simulator) -> Iterator[Simulator]:
    shared.reset(BEFORE_TABLE)
    yield shared


def wait(simulator: Simulator, steps: int = 40) -> None:
    for _ in range(steps):
        simulator.apply(A.EMPTY_ACTION, CUPS)


def put(simulator: Simulator, name: str, x: float, y: float, z: float) -> None:
    pose = np.eye(4)
    pose[:3, 3] = (x, y, z)
    simulator.physics.set_pose(name, pose)


def always_in_view(rule: GraspRule) -> GraspRule:
    """Return the rule as if the camera saw everything."""
    return replace(rule, choose=lambda things: rule.choose([replace(thing, is_in_view=True) for thing in things]))


def test_discrete_motions_move_by_the_challenges_steps(simulator: Simulator) -> None:
    simulator.reset(BasePose(1.0, 1.0, 0.0))
    simulator.apply(A.MOVE_FORWARD, CUPS)
    assert simulator.base == BasePose(1.25, 1.0, 0.0)
    simulator.apply(A.TURN_LEFT, CUPS)
    simulator.apply(A.TURN_LEFT, CUPS)
    simulator.apply(A.TURN_RIGHT, CUPS)
    assert simulator.base.heading == pytest.approx(math.radians(30.0))


def test_blocked_motion_leaves_the_base_where_it_was_without_sliding(simulator: Simulator) -> None:
    start = BasePose(0.6, 1.5, math.radians(140.0))
    simulator.reset(start)
    events = simulator.apply(BaseDisplacement(x=1.0, heading=1.0), CUPS)
    assert events.blocked
    assert not events.hit
    assert simulator.base == start


@pytest.mark.parametrize(
    ("asked", "done"),
    [
        (BaseDisplacement(x=0.09, heading=math.radians(4.0)), BaseDisplacement()),
        (BaseDisplacement(x=-0.1), BaseDisplacement(x=-0.1)),
        (BaseDisplacement(heading=math.radians(5.0)), BaseDisplacement(heading=math.radians(5.0))),
        (BaseDisplacement(x=5.0), BaseDisplacement(x=1.0)),
        (BaseDisplacement(y=0.5, heading=-0.2), BaseDisplacement(y=0.5, heading=-0.2)),
    ],
)
def test_continuous_motion_is_cut_to_its_range(
    simulator: Simulator, asked: BaseDisplacement, done: BaseDisplacement
) -> None:
    start = BasePose(1.5, 1.2, 0.0)
    simulator.reset(start)
    simulator.apply(asked, CUPS)
    assert simulator.base == start.compose(BasePose(done.x, done.y, done.heading))


def test_manipulation_mode_turns_the_base_each_time_and_navigation_mode_never(simulator: Simulator) -> None:
    heading = BEFORE_TABLE.heading
    for _ in range(2):
        simulator.apply(A.MANIPULATION_MODE, CUPS)
        heading += math.pi / 2
        assert simulator.joints == MANIPULATION_POSTURE
        assert math.remainder(simulator.base.heading - heading, 2 * math.pi) == pytest.approx(0.0, abs=1e-9)
    simulator.apply(A.NAVIGATION_MODE, CUPS)
    assert simulator.joints == NAVIGATION_POSTURE
    assert math.remainder(simulator.base.heading - heading, 2 * math.pi) == pytest.approx(0.0, abs=1e-9)


def test_extend_arm_lifts_the_arm_and_extends_all_of_it(simulator: Simulator) -> None:
    simulator.reset(BasePose(1.5, 2.0, math.pi))
    simulator.apply(A.MANIPULATION_MODE, CUPS)
    events = simulator.apply(A.EXTEND_ARM, CUPS)
    assert simulator.joints == replace(MANIPULATION_POSTURE, lift=0.8, arm=0.52)
    assert events == StepEvents()


def test_joints_move_by_their_displacement_within_their_ranges(simulator: Simulator) -> None:
    simulator.reset(BasePose(1.0, 1.0, math.pi / 2))
    simulator.apply(JointDisplacement(Joints(lift=-0.1, arm=2.0, head_pan=0.3), BaseDisplacement(x=-0.3)), CUPS)
    assert simulator.joints == replace(NAVIGATION_POSTURE, lift=0.78 - 0.1, arm=0.52, head_pan=0.3)
    assert simulator.base.y == pytest.approx(0.7)


def test_arm_extended_into_a_wall_counts_once_a_step(simulator: Simulator) -> None:
    simulator.reset(BasePose(0.5, 2.0, math.radians(-90.0)))
    events = simulator.apply(A.EXTEND_ARM, CUPS)
    assert events.hit
    assert events.hit == "wall"
    assert not events.blocked
    assert simulator.apply(A.EMPTY_ACTION, CUPS).hit
    simulator.apply(A.NAVIGATION_MODE, CUPS)
    assert not simulator.apply(A.EMPTY_ACTION, CUPS).hit


def test_gripper_takes_the_nearest_object_of_the_class_in_view(simulator: Simulator) -> None:
    simulator.apply(A.MANIPULATION_MODE, CUPS)
    events = simulator.apply(A.SNAP_OBJECT, CUPS)
    assert events.grasped == simulator.held == "mug_near"
    assert not events.hit
    assert simulator.apply(A.SNAP_OBJECT, CUPS).grasped is None
    assert simulator.held == "mug_near"


@pytest.mark.parametrize(
    ("base", "rule"),
    [
        pytest.param(BEFORE_TABLE, take_candidate("teapot", ("mug_near",)), id="nothing of the class in view"),
        pytest.param(BEFORE_TABLE, take_candidate("cup", ()), id="no candidate"),
        pytest.param(BasePose(2.1, 2.6, -math.pi / 2), take_candidate("bowl", ("bowl_1",)), id="out of view"),
        pytest.param(BasePose(2.1, 2.15, math.pi / 2), CUPS, id="out of reach"),
    ],
)
def test_nothing_is_grasped_otherwise(simulator: Simulator, base: BasePose, rule: GraspRule) -> None:
    simulator.reset(base)
    assert simulator.apply(A.SNAP_OBJECT, rule).grasped is None
    assert simulator.held is None


def test_the_rule_is_told_of_every_small_object_and_of_what_the_camera_sees(simulator: Simulator) -> None:
    told: list[Graspable] = []
    simulator.apply(A.MANIPULATION_MODE, CUPS)
    simulator.apply(A.SNAP_OBJECT, GraspRule(told.extend))
    things = {thing.name: thing for thing in told}
    assert set(things) == set(simulator.physics.names)
    assert {name for name, thing in things.items() if thing.is_in_view} == {"mug_near", "mug_far", "bowl_1"}
    assert [thing.name for thing in told if thing.is_in_centre] == ["mug_near"]
    grasp_centre = simulator.gripper_to_world()[:2, 3]
    expected = math.dist(grasp_centre, (2.1, 3.3))
    assert things["mug_near"].distance == pytest.approx(expected, abs=0.02)
    assert things["mug_near"].category == "cup"


def test_an_object_is_grasped_up_to_the_challenges_range_in_the_plane(simulator: Simulator) -> None:
    pick = take_candidate("cup", ("mug_near",))
    for range_, grasped in ((0.78, True), (0.82, False)):
        for height in (0.2, 0.74, 1.2):  # which does not matter
            simulator.reset(BEFORE_TABLE)
            x, y, _ = simulator.gripper_to_world()[:3, 3]
            put(simulator, "mug_near", float(x), float(y) + range_, height)
            assert (simulator.apply(A.SNAP_OBJECT, always_in_view(pick)).grasped is not None) is grasped


def test_what_is_in_the_middle_quarter_of_the_picture_is_in_its_centre(simulator: Simulator) -> None:
    index = [i.name for i in simulator.home.instances].index("mug_near")
    gripper, state = Gripper(simulator.home, simulator.physics), RobotState(BEFORE_TABLE, NAVIGATION_POSTURE)
    for row, column, inside in ((160, 92, True), (160, 87, False), (122, 120, True), (117, 120, False)):
        for pixel in ((row, column), (319 - row, 239 - column)):
            told: list[Graspable] = []
            picture = np.full((320, 240), -1, np.int16)
            picture[pixel] = index
            assert gripper.snap(GraspRule(told.extend), picture, state, None) is None
            assert [thing.name for thing in told if thing.is_in_view] == ["mug_near"]
            assert [thing.name for thing in told if thing.is_in_centre] == ["mug_near"] * inside


def test_a_step_lasts_as_long_as_in_the_challenge(simulator: Simulator) -> None:
    put(simulator, "mug_near", 1.0, 1.0, 1.5)
    wait(simulator, 10)
    fallen = 1.5 - simulator.object_pose("mug_near")[2, 3]
    assert fallen == pytest.approx(0.5 * 9.81 * 0.32**2, rel=0.05)


def test_held_object_goes_where_the_gripper_goes_and_is_seen_there(simulator: Simulator) -> None:
    simulator.apply(A.MANIPULATION_MODE, CUPS)
    simulator.apply(A.SNAP_OBJECT, CUPS)
    simulator.apply(RAISED, CUPS)
    simulator.apply(A.EXTEND_ARM, CUPS)
    mug, gripper = simulator.object_pose("mug_near"), simulator.gripper_to_world()
    height = load_catalogue()[MUG].size[2]
    np.testing.assert_allclose(mug[:3, 3], gripper[:3, 3] - [0.0, 0.0, height], atol=0.02)
    assert mug[2, 2] == pytest.approx(1.0, abs=1e-4)
    simulator.apply(JointDisplacement(Joints(0.0, -0.3, head_tilt=0.3)), CUPS)
    index = [i.name for i in simulator.home.instances].index("mug_near")
    assert np.count_nonzero(simulator.render().instances == index) > 20


def test_mug_released_above_the_table_comes_to_rest_on_it(simulator: Simulator) -> None:
    simulator.apply(A.MANIPULATION_MODE, CUPS)
    simulator.apply(A.SNAP_OBJECT, CUPS)
    for action in (RAISED, JointDisplacement(Joints(-0.1, 0.25))):
        assert not simulator.apply(action, CUPS).hit
    above = simulator.object_pose("mug_near")
    events = simulator.apply(A.DESNAP_OBJECT, CUPS)
    assert events.released == "mug_near"
    assert simulator.held is None
    assert not events.hit
    wait(simulator)
    assert simulator.physics.is_at_rest("mug_near")
    assert simulator.physics.touching("mug_near") == {"table_1"}
    resting = simulator.object_pose("mug_near")
    assert resting[2, 3] == pytest.approx(TABLE_HEIGHT, abs=0.005)
    assert np.hypot(*(resting - above)[:2, 3]) < 0.02


def test_mug_released_over_a_sink_ends_in_its_basin(simulator: Simulator) -> None:
    simulator.reset(BEFORE_SINK)
    simulator.apply(A.MANIPULATION_MODE, CUPS)
    assert simulator.apply(A.SNAP_OBJECT, CUPS).grasped == "mug_sink"
    for action in (RAISED, JointDisplacement(Joints(0.0, 0.52))):
        assert not simulator.apply(action, CUPS).hit
    simulator.apply(A.DESNAP_OBJECT, CUPS)
    wait(simulator, 60)
    assert simulator.physics.is_at_rest("mug_sink")
    assert simulator.physics.touching("mug_sink") == {"sink_1"}
    assert simulator.object_pose("mug_sink")[2, 3] == pytest.approx(0.65, abs=0.02)


def test_what_is_dropped_on_the_floor_is_in_the_way_until_it_is_taken_away(simulator: Simulator) -> None:
    simulator.apply(A.MANIPULATION_MODE, CUPS)
    simulator.apply(A.SNAP_OBJECT, CUPS)
    simulator.apply(A.NAVIGATION_MODE, CUPS)
    simulator.apply(BaseDisplacement(heading=math.pi / 2), CUPS)
    simulator.apply(A.DESNAP_OBJECT, CUPS)
    wait(simulator, 80)
    x, y, z = simulator.object_pose("mug_near")[:3, 3]
    assert z < 0.05
    assert simulator.floor.clearance(x, y) < 0.05
    simulator.reset(BEFORE_TABLE)
    assert simulator.floor.clearance(x, y) > 0.1


def test_the_floor_is_free_where_an_object_was_picked_up(simulator: Simulator) -> None:
    simulator.reset(BasePose(2.1, 2.6, -math.pi / 2))
    assert not simulator.floor.is_free(2.1, 2.0)
    simulator.apply(A.MANIPULATION_MODE, CUPS)
    simulator.apply(JointDisplacement(Joints(-0.4, 0.0)), CUPS)
    assert simulator.apply(A.SNAP_OBJECT, take_candidate("cup", {"mug_behind"})).grasped == "mug_behind"
    wait(simulator)
    assert simulator.floor.is_free(2.1, 2.0)


def test_reset_puts_everything_back(simulator: Simulator) -> None:
    frame = simulator.render()
    poses = {name: simulator.object_pose(name) for name in simulator.physics.names}
    for action in (A.MANIPULATION_MODE, A.SNAP_OBJECT, A.DESNAP_OBJECT, A.EMPTY_ACTION):
        simulator.apply(action, CUPS)
    simulator.reset(BEFORE_TABLE)
    assert simulator.held is None
    assert all(np.array_equal(simulator.object_pose(name), pose) for name, pose in filled(poses.items()))
    assert np.array_equal(simulator.render().rgb, frame.rgb)


def test_a_frame_is_rendered_anew_where_the_robot_or_an_object_has_moved_and_nowhere_else(simulator: Simulator) -> None:
    simulator.reset(BEFORE_TABLE)
    simulator.physics.settle()
    frames = [simulator.render()]
    for action in (A.EMPTY_ACTION, A.MANIPULATION_MODE, A.EMPTY_ACTION, A.SNAP_OBJECT):
        simulator.apply(action, CUPS)
        frames.append(simulator.render())
    held = simulator.held
    assert held is not None
    assert frames[1] is frames[0] and frames[3] is frames[2]
    assert not np.array_equal(frames[1].rgb, frames[2].rgb)
    assert not np.array_equal(frames[3].rgb, frames[4].rgb)
    other = next(name for name in simulator.physics.names if name != held)
    lifted = simulator.object_pose(other)
    lifted[2, 3] += 0.5
    simulator.physics.set_pose(other, lifted)
    again, geometry = simulator.render(), simulator.render_geometry()
    assert again is not frames[4]
    assert np.array_equal(geometry.instances, again.instances)
    fresh = Simulator(furnished_home(), HEAD_CAMERA_HALF)
    fresh.return_to(simulator.moment(), simulator.base)
    assert np.array_equal(fresh.render().rgb, again.rgb)


def test_same_actions_give_the_same_bits_in_another_simulator_and_after_a_reset(simulator: Simulator) -> None:
    actions: list[Action] = [
        A.MANIPULATION_MODE,
        A.SNAP_OBJECT,
        RAISED,
        A.EXTEND_ARM,
        A.DESNAP_OBJECT,
        *[A.EMPTY_ACTION] * 20,
    ]
    actions += [A.NAVIGATION_MODE, A.TURN_LEFT, A.MOVE_FORWARD]
    traces = []
    for one in (simulator, Simulator(furnished_home(), HEAD_CAMERA_HALF), simulator):
        one.reset(BEFORE_TABLE)
        events = [one.apply(action, CUPS) for action in actions]
        poses = np.array([one.object_pose(name) for name in one.physics.names])
        traces.append((events, one.base, poses.tobytes(), one.render().rgb.tobytes(), one.render().depth.tobytes()))
    assert traces[0] == traces[1] == traces[2]


@pytest.mark.parametrize("posture", [NAVIGATION_POSTURE, MANIPULATION_POSTURE])
def test_head_camera_sees_nothing_of_the_head_itself(posture: Joints) -> None:
    scene = Scene(furnished_home(), robot_parts())
    for name, pose in part_poses(BEFORE_TABLE, posture).items():
        scene.move(name, pose)
    camera_to_world = BEFORE_TABLE.matrix() @ head_camera_to_base(posture)
    seen = render(scene, HEAD_CAMERA_HALF, camera_to_world).rgb.copy()
    for name in ("robot/head_pan", "robot/head_tilt", "robot/base"):
        scene.show(name, False)
    assert np.array_equal(render(scene, HEAD_CAMERA_HALF, camera_to_world).rgb, seen)


def test_head_camera_sees_the_wrist_in_manipulation_and_the_robot_is_no_instance(simulator: Simulator) -> None:
    before = simulator.render()
    simulator.apply(A.MANIPULATION_MODE, CUPS)
    frame = simulator.render()
    near = (frame.depth > 0) & (frame.depth < 0.6)
    assert 500 < np.count_nonzero(near) < 0.2 * near.size
    assert np.all(frame.instances[near] == -1)
    assert not np.any((before.depth > 0) & (before.depth < 0.6))


def test_a_simulator_that_nobody_needs_frees_its_memory_at_once() -> None:
    simulator = Simulator(furnished_home(), HEAD_CAMERA_HALF)
    simulator.apply(DiscreteAction.TURN_LEFT, CUPS)
    watcher = weakref.ref(simulator)
    gc.disable()
    try:
        del simulator
        assert watcher() is None
    finally:
        gc.enable()
