"""A Stretch from within does what the simulator does, through a module that answers stretch_body's calls."""

import math
import sys
from collections.abc import Iterator
from functools import partial
from types import ModuleType

import numpy as np
import pytest
from worlds.fake_robot import EPISODE, HASTY, PACE, QUICK, Rewound, simulator

from uniteam.errors import UnavailableError
from uniteam.geometry import PinholeCamera
from uniteam.interface import Action, BaseDisplacement, DiscreteAction, JointDisplacement, Joints
from uniteam.testing import check_body
from uniteam.world.fake.fake_stretch import FakeStretch
from uniteam.world.fake.stretch_body_stand_in import FakeHead, Robot, RobotClock
from uniteam.world.real.head_camera import upright
from uniteam.world.real.robot_errors import RobotError, RunStopError, SilentRobotError
from uniteam.world.real.safety import SafetyLimits
from uniteam.world.real.stretch_body_link import StretchBodyLink, connect_stretch_body, state_of
from uniteam.world.real.stretch_robot import StretchRobot
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.environment import Environment

LIMITS = SafetyLimits()


@pytest.fixture
def fake(world: Simulator) -> FakeStretch:
    return FakeStretch(world, EPISODE, QUICK)


def body_of(fake: FakeStretch) -> StretchRobot:
    link = StretchBodyLink(Robot(fake), FakeHead(fake), RobotClock(fake), LIMITS, PACE, HASTY)
    return StretchRobot(link, LIMITS)


@pytest.fixture
def robot(fake: FakeStretch) -> Iterator[StretchRobot]:
    yield body_of(fake)


def fresh(world: Simulator) -> StretchRobot:
    return body_of(FakeStretch(world, EPISODE, QUICK))


@pytest.mark.slow
def test_it_keeps_what_a_body_promises(world: Simulator, tmp_path_factory: pytest.TempPathFactory) -> None:
    worlds = iter((world, simulator(tmp_path_factory.mktemp("others"))))
    check_body(lambda: Rewound(partial(fresh, next(worlds))))


SCRIPT: tuple[Action, ...] = (
    DiscreteAction.MOVE_FORWARD,
    DiscreteAction.TURN_RIGHT,
    BaseDisplacement(x=0.5, heading=2.5),
    DiscreteAction.MANIPULATION_MODE,
    JointDisplacement(Joints(0.1, 0.2, wrist_yaw=0.4, wrist_pitch=0.3, wrist_roll=-0.5, head_pan=0.2)),
    DiscreteAction.EXTEND_ARM,
    DiscreteAction.NAVIGATION_MODE,
)


def test_it_goes_where_the_simulator_goes(world: Simulator, robot: StretchRobot) -> None:
    seen = [robot.reset(), *(robot.step(action) for action in SCRIPT)]
    environment = Environment(world.home, EPISODE, world.camera)
    wanted = [environment.reset(), *(environment.step(action) for action in SCRIPT)]
    for one, other in zip(seen, wanted, strict=True):
        assert one.base_to_start.distance_to(other.base_to_start.x, other.base_to_start.y) < 1e-6
        assert abs(math.remainder(one.base_to_start.heading - other.base_to_start.heading, math.tau)) < 1e-6
        assert vars(one.joints) == pytest.approx(vars(other.joints), abs=1e-6)
        np.testing.assert_allclose(one.camera_to_start, other.camera_to_start, atol=1e-6)
    np.testing.assert_array_equal(seen[0].depth, wanted[0].depth)


def test_the_gripper_feels_nothing_where_nothing_is(robot: StretchRobot) -> None:
    robot.reset()
    assert not robot.step(DiscreteAction.SNAP_OBJECT).is_holding


def test_a_run_stop_ends_the_run(fake: FakeStretch, robot: StretchRobot) -> None:
    robot.reset()
    fake.press_run_stop()
    with pytest.raises(RunStopError):
        robot.step(DiscreteAction.MOVE_FORWARD)


def test_what_raises_during_a_motion_stops_base_and_arm(fake: FakeStretch) -> None:
    class EnoughError(Exception):
        pass

    def watch(state: object) -> None:
        if fake.base.x > 0.1:
            raise EnoughError

    link = StretchBodyLink(Robot(fake), FakeHead(fake), RobotClock(fake), LIMITS, PACE, HASTY)
    robot = StretchRobot(link, LIMITS, (watch,))
    robot.reset()
    with pytest.raises(EnoughError):
        robot.step(BaseDisplacement(x=0.9))
    for _ in range(100):
        fake.tick()
    assert fake.base.x < 0.2


def test_a_robot_whose_parts_are_not_heard_is_given_up(fake: FakeStretch) -> None:
    class Deaf(Robot):
        is_deaf = False

        def get_status(self) -> dict[str, object]:
            status = super().get_status()
            if self.is_deaf:
                status["base"]["pose_time_s"] = -5.0
            return status

    hardware = Deaf(fake)
    link = StretchBodyLink(hardware, FakeHead(fake), RobotClock(fake), LIMITS, PACE, HASTY)
    robot = StretchRobot(link, LIMITS)
    robot.reset()
    hardware.is_deaf = True
    with pytest.raises(SilentRobotError, match=r"sent nothing for 0\.6 s"):
        robot.step(BaseDisplacement(x=0.9))
    for _ in range(100):
        fake.tick()
    assert fake.base.x < 0.5


def test_one_process_has_the_robot(fake: FakeStretch) -> None:
    hardware = Robot(fake)
    StretchBodyLink(hardware, FakeHead(fake), RobotClock(fake), LIMITS, PACE, HASTY)
    with pytest.raises(RobotError, match="another process has hold of the robot"):
        StretchBodyLink(hardware, FakeHead(fake), RobotClock(fake), LIMITS, PACE, HASTY)


def test_a_status_without_a_wrist_is_refused(fake: FakeStretch) -> None:
    status = Robot(fake).get_status()
    del status["end_of_arm"]["wrist_pitch"]
    with pytest.raises(RobotError, match="lacks 'wrist_pitch'; a Stretch with the dexterous wrist"):
        state_of(status)


def test_a_status_that_is_not_finite_is_refused(fake: FakeStretch) -> None:
    status = Robot(fake).get_status()
    status["lift"]["pos"] = math.nan
    with pytest.raises(RobotError, match="not finite"):
        state_of(status)


def test_what_is_missing_on_the_robot_is_said(fake: FakeStretch, monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(UnavailableError, match="stretch_body, which cannot be imported"):
        connect_stretch_body(LIMITS)
    module = ModuleType("stretch_body.robot")
    module.Robot = lambda: Robot(fake)  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "stretch_body", ModuleType("stretch_body"))
    monkeypatch.setitem(sys.modules, "stretch_body.robot", module)
    with pytest.raises(UnavailableError, match="pyrealsense2, which cannot be imported"):
        connect_stretch_body(LIMITS)


def test_a_picture_that_lies_is_turned_upright_with_its_intrinsics() -> None:
    sensor = PinholeCamera(64, 48, 55.0, 50.0, 30.0, 20.0)
    x, y, z = 0.3, -0.2, 2.0
    u, v = sensor.project(np.array([x, y, z]))
    rgb, depth = np.zeros((48, 64, 3), np.uint8), np.full((48, 64), 12.0, np.float32)
    rgb[round(v), round(u)], depth[round(v), round(u)] = 255, z
    turned, deep, camera = upright(rgb, depth, sensor)
    (row, column, _), *_ = np.argwhere(turned)
    assert turned.shape == (64, 48, 3)
    assert camera.project(np.array([-y, x, z])) == pytest.approx([column, row], abs=0.51)
    assert deep[row, column] == z
    assert np.count_nonzero(deep) == 1
