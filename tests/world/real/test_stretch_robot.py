"""A Stretch behind the bridge does what an agent asks, as the simulator does, and nothing that it must not."""

import logging
import math
from collections.abc import Iterator
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from worlds.fake_robot import EPISODE, LIMITS, QUICK, Rewound, body, bridge, lockstep_body, simulator, with_fence

from uniteam.errors import InvalidActionError, InvalidInputError
from uniteam.geometry import BasePose
from uniteam.interface import Action, BaseDisplacement, DiscreteAction, JointDisplacement, Joints
from uniteam.stretch import JOINT_LIMITS, MANIPULATION_POSTURE, NAVIGATION_POSTURE
from uniteam.testing import check_body
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.fake.bridge_messages import no_truth
from uniteam.world.fake.delayed import Delayed
from uniteam.world.fake.lockstep import Lockstep
from uniteam.world.real.link import RobotState
from uniteam.world.real.motions import Motion
from uniteam.world.real.robot_errors import RobotError, RunStopError, SilentRobotError, UnsafeMotionError
from uniteam.world.real.safety import SafetyLimits
from uniteam.world.real.stretch_robot import StretchRobot
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.environment import Environment


@pytest.fixture
def robot(side: FakeBridge) -> Iterator[StretchRobot]:
    yield lockstep_body(side)
    assert side.refusals == []


def fresh(world: Simulator) -> StretchRobot:
    return lockstep_body(bridge(world))


@pytest.mark.slow
def test_it_keeps_what_a_body_promises(world: Simulator, tmp_path_factory: pytest.TempPathFactory) -> None:
    worlds = iter((world, simulator(tmp_path_factory.mktemp("others"))))
    check_body(lambda: Rewound(partial(fresh, next(worlds))))


SCRIPT: tuple[Action, ...] = (
    DiscreteAction.MOVE_FORWARD,
    DiscreteAction.TURN_RIGHT,
    BaseDisplacement(x=0.6),
    BaseDisplacement(x=-0.12),
    BaseDisplacement(heading=math.radians(6.0)),
    BaseDisplacement(heading=math.pi),
    BaseDisplacement(x=0.15, heading=-0.7),
    BaseDisplacement(x=0.05, heading=0.05),
    DiscreteAction.MANIPULATION_MODE,
    BaseDisplacement(x=0.1),
    JointDisplacement(Joints(0.1, 0.2, wrist_yaw=0.4, wrist_pitch=0.3, wrist_roll=-0.5, head_pan=0.2, head_tilt=-0.1)),
    DiscreteAction.EXTEND_ARM,
    DiscreteAction.NAVIGATION_MODE,
    JointDisplacement(Joints(0.0, 0.0, head_tilt=-0.2)),
    DiscreteAction.EMPTY_ACTION,
)


def test_it_goes_where_the_simulator_goes(world: Simulator, side: FakeBridge) -> None:
    robot = lockstep_body(side)
    seen = [robot.reset(), *(robot.step(action) for action in SCRIPT)]
    environment = Environment(world.home, EPISODE, world.camera)
    wanted = [environment.reset(), *(environment.step(action) for action in SCRIPT)]
    assert side.refusals == []
    for one, other in zip(seen, wanted, strict=True):
        base, aim = one.base_to_start, other.base_to_start
        assert base.distance_to(aim.x, aim.y) < 0.05
        assert abs(math.remainder(base.heading - aim.heading, math.tau)) < 0.03
        np.testing.assert_allclose(vars_of(one.joints), vars_of(other.joints), atol=0.02)
        assert one.step == other.step
        assert np.abs(one.camera_to_start[:3, 3] - other.camera_to_start[:3, 3]).max() < 0.06
        assert one.camera == other.camera
    assert np.median(np.abs(seen[0].depth - wanted[0].depth)) < 0.001
    assert np.abs(seen[0].rgb.astype(int) - wanted[0].rgb).mean() < 3.0


def vars_of(joints: Joints) -> list[float]:
    return list(vars(joints).values())


@pytest.mark.parametrize("distance", [0.1, 0.15, 0.25, 0.5, 1.0, -0.3])
def test_it_drives_as_far_as_asked(robot: StretchRobot, distance: float) -> None:
    robot.reset()
    assert robot.step(BaseDisplacement(x=distance)).base_to_start.x == pytest.approx(distance, abs=0.012)


@pytest.mark.parametrize("degrees", [5.0, 10.0, -30.0, 90.0, 180.0, -180.0])
def test_it_turns_as_far_as_asked(robot: StretchRobot, degrees: float) -> None:
    robot.reset()
    seen = robot.step(BaseDisplacement(heading=math.radians(degrees)))
    assert abs(math.remainder(seen.base_to_start.heading - math.radians(degrees), math.tau)) < 0.02


def test_twelve_turns_come_to_a_whole_one(robot: StretchRobot) -> None:
    seen = robot.reset()
    for _ in range(12):
        seen = robot.step(DiscreteAction.TURN_LEFT)
    assert abs(seen.base_to_start.heading) < 0.01


def test_a_half_turn_to_the_right_is_not_one_to_the_left(side: FakeBridge) -> None:
    headings: list[float] = []
    line = Lockstep(side, side.robot.simulator.camera, no_truth)
    robot = body(line, line, watchers=(lambda state: headings.append(state.base.heading),))
    robot.reset()
    robot.step(BaseDisplacement(heading=-math.pi))
    on_the_way = [heading for heading in headings if 0.1 < abs(heading) < 3.0]
    assert len(on_the_way) > 10
    assert max(on_the_way) < 0.0


def test_sideways_is_turned_driven_and_turned_back(robot: StretchRobot) -> None:
    robot.reset()
    base = robot.step(BaseDisplacement(x=0.2, y=0.3, heading=0.5)).base_to_start
    assert (base.x, base.y, base.heading) == pytest.approx((0.2, 0.3, 0.5), abs=0.03)


def test_what_is_too_small_is_not_done_as_in_the_simulator(side: FakeBridge, robot: StretchRobot) -> None:
    robot.reset()
    before = side.robot.base
    robot.step(BaseDisplacement(x=0.09, heading=math.radians(4.0)))
    assert side.robot.base == before


def test_the_postures_are_those_of_the_interface(side: FakeBridge, robot: StretchRobot) -> None:
    assert vars_of(robot.reset().joints) == pytest.approx(vars_of(NAVIGATION_POSTURE), abs=0.02)
    ready = robot.step(DiscreteAction.MANIPULATION_MODE)
    assert vars_of(ready.joints) == pytest.approx(vars_of(MANIPULATION_POSTURE), abs=0.02)
    assert ready.base_to_start.heading == pytest.approx(math.pi / 2, abs=0.02)
    extended = robot.step(DiscreteAction.EXTEND_ARM)
    assert extended.joints.arm == pytest.approx(JOINT_LIMITS[1].arm, abs=0.01)
    assert extended.joints.lift == pytest.approx(0.8, abs=0.01)


def test_it_feels_what_it_holds_and_what_it_let_go_of(world: Simulator) -> None:
    near = replace(EPISODE, start=BasePose(0.95, 0.5, math.pi))
    side = bridge(world)
    side.robot._episode = near
    side.robot.reset()
    robot = lockstep_body(side)
    assert not robot.reset().is_holding
    robot.step(DiscreteAction.MANIPULATION_MODE)
    robot.step(JointDisplacement(Joints(0.0, 0.0, head_tilt=-0.4)))
    assert robot.step(DiscreteAction.SNAP_OBJECT).is_holding
    assert world.held == "cup"
    assert not robot.step(DiscreteAction.DESNAP_OBJECT).is_holding
    assert world.held is None


def test_a_gripper_that_has_missed_is_opened_before_it_closes_again(world: Simulator) -> None:
    side = bridge(world)
    side.robot._episode = replace(EPISODE, start=BasePose(0.95, 0.5, math.pi))
    side.robot.reset()
    robot = lockstep_body(side)
    robot.reset()
    assert not robot.step(DiscreteAction.SNAP_OBJECT).is_holding
    robot.step(DiscreteAction.MANIPULATION_MODE)
    assert robot.step(DiscreteAction.SNAP_OBJECT).is_holding
    assert robot.step(DiscreteAction.SNAP_OBJECT).is_holding
    assert world.held == "cup"


def test_a_gripper_that_closes_on_nothing_holds_nothing(robot: StretchRobot) -> None:
    robot.reset()
    assert not robot.step(DiscreteAction.SNAP_OBJECT).is_holding


def test_a_wall_ends_the_step_not_the_run(world: Simulator) -> None:
    side = bridge(world)
    side.robot._episode = replace(EPISODE, start=BasePose(3.0, 3.0, 0.0))
    side.robot.reset()
    robot = lockstep_body(side)
    robot.reset()
    robot.step(BaseDisplacement(x=0.9))
    assert robot.step(DiscreteAction.TURN_LEFT).base_to_start.heading == pytest.approx(math.pi / 6, abs=0.02)


@pytest.mark.parametrize("distance", [0.15, 0.9])
def test_from_what_is_in_its_way_it_goes_back_as_if_it_had_not_begun(world: Simulator, distance: float) -> None:
    side = bridge(world)
    side.robot._episode = replace(EPISODE, start=BasePose(3.0, 3.0, 0.0))
    side.robot.reset()
    furthest: list[float] = []
    line = Lockstep(side, world.camera, no_truth)
    robot = body(line, line, watchers=(lambda state: furthest.append(state.base.x),))
    robot.reset()
    robot.step(BaseDisplacement(x=0.6))
    assert robot.step(BaseDisplacement(x=distance)).base_to_start.x == pytest.approx(0.6, abs=0.005)
    assert max(furthest) > 0.64
    assert robot.step(BaseDisplacement(x=-0.15)).base_to_start.x == pytest.approx(0.45, abs=0.01)


@pytest.mark.parametrize("nonsense", [None, "stop", BaseDisplacement(x=math.nan)])
def test_what_is_no_action_moves_nothing(side: FakeBridge, robot: StretchRobot, nonsense: Action) -> None:
    robot.reset()
    before, time = side.robot.base, side.robot.time
    with pytest.raises(InvalidActionError):
        robot.step(nonsense)
    assert (side.robot.base, side.robot.time) == (before, time)


def test_it_must_be_reset_first(robot: StretchRobot) -> None:
    with pytest.raises(InvalidInputError, match="call reset"):
        robot.step(DiscreteAction.MOVE_FORWARD)


def test_it_does_not_leave_the_fence_and_says_so(side: FakeBridge) -> None:
    said: list[tuple[str, str]] = []

    def announce(motion: Motion, refusal: str) -> None:
        said.append((str(motion), refusal))

    robot = lockstep_body(side, with_fence(0.6))
    robot._announce = announce
    robot.reset()
    robot.step(BaseDisplacement(x=0.5))
    seen = robot.step(BaseDisplacement(x=0.5))
    assert seen.base_to_start.x == pytest.approx(0.5, abs=0.02)
    assert said[-2:] == [
        ("drive the base 0.50 m ahead", ""),
        ("drive the base 0.50 m ahead", "it would leave the fence, 0.6 m around the start"),
    ]
    assert robot.step(BaseDisplacement(x=-0.5)).base_to_start.x == pytest.approx(0.0, abs=0.03)


def test_a_base_that_is_carried_out_of_the_fence_is_stopped(side: FakeBridge) -> None:
    robot = lockstep_body(side, with_fence(0.5))
    robot.reset()
    side.robot._odometry.pose = BasePose(1.2, 0.0, 0.0)
    with pytest.raises(UnsafeMotionError, match="beyond the fence"):
        robot.step(DiscreteAction.TURN_LEFT)
    assert side.robot.motors._wanted == (0.0, 0.0)


def test_a_base_that_goes_the_other_way_is_stopped(side: FakeBridge, robot: StretchRobot) -> None:
    robot.reset()
    drive = side.robot.motors.send_base

    def reversed_wheels(velocity: tuple[float, float]) -> None:
        drive((-velocity[0], velocity[1]))

    side.robot.motors.send_base = reversed_wheels  # type: ignore[method-assign]
    with pytest.raises(UnsafeMotionError, match="told to stop"):
        robot.step(BaseDisplacement(x=0.5))
    assert abs(side.robot.base.x) < 0.5


def test_no_velocity_is_above_the_limits(side: FakeBridge) -> None:
    limits = SafetyLimits(speed=0.1, turn_speed=0.2)
    robot = lockstep_body(side, limits)
    sent: list[tuple[float, float]] = []
    drive = side.robot.motors.send_base

    def noted(velocity: tuple[float, float]) -> None:
        sent.append(velocity)
        drive(velocity)

    side.robot.motors.send_base = noted  # type: ignore[method-assign]
    robot.reset()
    robot.step(BaseDisplacement(x=0.3, heading=0.5))
    assert max(abs(v) for v, _ in sent) == 0.1
    assert max(abs(w) for _, w in sent) == 0.2


@pytest.mark.parametrize("limit", ["speed", "turn_speed", "fence", "stale"])
@pytest.mark.parametrize("value", [0.0, -1.0, math.nan, math.inf])
def test_a_limit_that_is_none_is_refused(limit: str, value: float) -> None:
    with pytest.raises(InvalidInputError, match=f"the limit {limit} must be above 0"):
        replace(LIMITS, **{limit: value})


def test_a_robot_that_is_run_stopped_is_not_begun_with(side: FakeBridge) -> None:
    side.robot.press_run_stop()
    with pytest.raises(RunStopError, match="run-stop is engaged"):
        lockstep_body(side)


def test_a_robot_that_is_not_there_is_said_to_be_silent() -> None:
    class Nobody:
        time = 0.0

        def now(self) -> float:
            return self.time

        def sleep(self, seconds: float) -> None:
            self.time += seconds

        def newest_state(self) -> None:
            return None

        newest_observation = newest_state

        def send(self, action: bytes) -> None:
            pass

        def close(self) -> None:
            pass

    nobody = Nobody()
    with pytest.raises(SilentRobotError, match=r"no state \(port 4403\) came in 3 s; see that the bridge"):
        body(nobody, nobody)


def test_a_robot_that_takes_no_actions_is_given_up(side: FakeBridge) -> None:
    class Deaf(Lockstep):
        def send(self, action: bytes) -> None:
            pass

    line = Deaf(side, side.robot.simulator.camera, no_truth)
    robot = body(line, line)
    with pytest.raises(RobotError, match=r"did not acknowledge head_to in 2 s"):
        robot.reset()


def test_one_lost_action_is_sent_again(side: FakeBridge) -> None:
    class Lossy(Lockstep):
        count = 0

        def send(self, action: bytes) -> None:
            self.count += 1
            if self.count % 3 == 0:
                super().send(action)

    line = Lossy(side, side.robot.simulator.camera, no_truth)
    robot = body(line, line)
    robot.reset()
    assert robot.step(DiscreteAction.MOVE_FORWARD).base_to_start.x == pytest.approx(0.25, abs=0.02)


def test_a_delay_makes_it_no_less_exact(world: Simulator, caplog: pytest.LogCaptureFixture) -> None:
    side = bridge(world, replace(QUICK, latency=0.1))
    line = Lockstep(side, world.camera, no_truth)
    robot = body(line, line, SafetyLimits(speed=0.3, turn_speed=0.8))
    robot.reset()
    with caplog.at_level(logging.WARNING):
        seen = robot.step(BaseDisplacement(x=0.5, heading=1.0))
    assert caplog.records == []
    base = seen.base_to_start
    assert (base.x, base.y, base.heading) == pytest.approx((0.5, 0.0, 1.0), abs=0.02)


def test_it_learns_how_early_a_late_robot_must_be_told_to_stop(world: Simulator) -> None:
    side = bridge(world, replace(QUICK, latency=0.1))
    robot = lockstep_body(side)
    robot.reset()
    ends = [side.robot.time]
    for _ in range(5):
        robot.step(DiscreteAction.TURN_LEFT)
        ends.append(side.robot.time)
    seconds = np.diff(ends)
    assert seconds[-1] < 0.75 * seconds[0]


def test_a_picture_is_of_after_the_motion_though_the_camera_is_later_than_all_else(
    world: Simulator, side: FakeBridge
) -> None:
    line = Lockstep(side, world.camera, no_truth)
    line._moments = Delayed(0.7)
    robot = body(line, line)
    robot.reset()
    seen = robot.step(DiscreteAction.TURN_LEFT)
    assert np.median(np.abs(seen.depth - world.render().depth)) < 0.001
    assert seen.base_to_start.heading == pytest.approx(math.pi / 6, abs=0.02)


def test_a_watcher_that_raises_stops_the_base(side: FakeBridge) -> None:
    class EnoughError(Exception):
        pass

    def watch(state: RobotState) -> None:
        if state.base.x > 0.1:
            raise EnoughError

    line = Lockstep(side, side.robot.simulator.camera, no_truth)
    robot = body(line, line, watchers=(watch,))
    robot.reset()
    with pytest.raises(EnoughError):
        robot.step(BaseDisplacement(x=0.9))
    assert side.robot.motors._wanted == (0.0, 0.0)
    assert side.robot.base.x < 0.25


def test_the_arms_mode_is_held_where_it_is_once_something_is_wrong(side: FakeBridge) -> None:
    class EnoughError(Exception):
        pass

    def watch(state: RobotState) -> None:
        if state.joints.arm > 0.1:
            raise EnoughError

    line = Lockstep(side, side.robot.simulator.camera, no_truth)
    robot = body(line, line, watchers=(watch,))
    robot.reset()
    robot.step(DiscreteAction.MANIPULATION_MODE)
    with pytest.raises(EnoughError):
        robot.step(JointDisplacement(Joints(0.0, 0.5)))
    for _ in range(100):
        line.sleep(0.01)
    assert side.robot.joints.arm < 0.3
    assert side.refusals == []
