"""The dials of a fake robot do what they say, and nothing at zero."""

import math

import numpy as np
import pytest
from worlds.fake_robot import bridge, lockstep_body

from uniteam.errors import InvalidInputError
from uniteam.geometry import BasePose
from uniteam.interface import BaseDisplacement
from uniteam.world.fake.delayed import Delayed
from uniteam.world.fake.depth_faults import with_faults
from uniteam.world.fake.dials import Dials
from uniteam.world.fake.odometry import Odometry
from uniteam.world.simulation.simulator import Simulator

FAR = np.repeat(np.linspace(0.0, 4.0, 81, dtype=np.float32)[:, None], 4000, axis=1)


def drifted(drift: float, seed: int) -> BasePose:
    odometry = Odometry(drift, np.random.default_rng(seed))
    base = BasePose(2.0, 1.0, 0.7)
    for _ in range(100):
        after = base.compose(BasePose(0.05, 0.0, 0.0)).compose(BasePose(0.0, 0.0, 0.01))
        odometry.move(base, after)
        base = after
    straight = BasePose(2.0, 1.0, 0.7).inverse().compose(base)
    return straight.inverse().compose(odometry.pose)


def test_an_odometry_without_drift_is_exact() -> None:
    error = drifted(0.0, 0)
    assert (error.x, error.y, error.heading) == pytest.approx((0.0, 0.0, 0.0), abs=1e-9)


def test_drift_is_a_share_of_the_way_and_of_the_turns() -> None:
    errors = [drifted(0.02, seed) for seed in range(20)]
    lengths = [math.hypot(error.x, error.y) for error in errors]
    assert 0.02 < max(lengths) < 0.02 * 5.0 * 4.0
    assert max(abs(error.heading) for error in errors) <= 0.02 * (5.0 + 1.0) + 1e-9
    assert len({round(length, 6) for length in lengths}) == 20


def test_a_robot_that_drifts_is_not_where_it_believes(world: Simulator) -> None:
    side = bridge(world, Dials(agility=4.0, image_hz=30.0, drift=0.1, seed=3))
    robot = lockstep_body(side)
    robot.reset()
    start = world.base
    seen = robot.step(BaseDisplacement(x=0.8)).base_to_start
    truly = start.inverse().compose(world.base)
    assert seen.x == pytest.approx(0.8, abs=0.02)
    assert abs(truly.x - seen.x) > 0.01


def test_a_camera_without_faults_gives_the_depth_itself() -> None:
    assert with_faults(FAR, 0.0, 0.0, np.random.default_rng(0)) is FAR


def test_noise_grows_with_the_square_of_the_distance() -> None:
    noisy = with_faults(FAR, 0.005, 0.0, np.random.default_rng(0))
    spread = (noisy - FAR).std(axis=1)
    assert spread[[20, 40, 80]] == pytest.approx([0.005, 0.02, 0.08], rel=0.05)
    assert not noisy[0].any()
    assert noisy.min() >= 0.0


def test_holes_take_their_share_in_patches() -> None:
    depth = np.full((480, 640), 2.0, np.float32)
    holed = with_faults(depth, 0.0, 0.2, np.random.default_rng(0))
    assert (holed == 0.0).mean() == pytest.approx(0.2, abs=0.02)
    whole = (holed.reshape(60, 8, 80, 8) == 0.0).sum(axis=(1, 3))
    assert set(np.unique(whole)) == {0, 64}
    assert holed.max() == 2.0


def test_what_is_delayed_comes_when_it_is_due_and_only_the_newest() -> None:
    line: Delayed[str] = Delayed(0.3)
    line.put(0.0, "first")
    line.put(0.1, "second")
    assert line.newest(0.29) is None
    assert line.newest(0.3) == "first"
    line.put(0.2, "third")
    assert line.newest(0.6) == "third"
    assert line.newest(9.0) is None


@pytest.mark.parametrize(
    ("name", "value"),
    [("latency", -0.1), ("drift", math.nan), ("holes", 1.0), ("agility", 0.0), ("image_hz", 1.0), ("seed", -1)],
)
def test_a_dial_out_of_its_range_is_refused(name: str, value: float) -> None:
    with pytest.raises(InvalidInputError, match=f"the dial {name} must"):
        Dials(**{name: value})  # type: ignore[arg-type]
