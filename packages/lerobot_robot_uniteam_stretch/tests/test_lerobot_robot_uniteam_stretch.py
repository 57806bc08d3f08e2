"""LeRobot finds the robot by the package's name and drives a fake Stretch behind real ports."""

import math
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("lerobot", reason="LeRobot is not installed")

from lerobot.robots import make_robot_from_config
from lerobot.robots.config import RobotConfig
from lerobot.robots.robot import Robot
from lerobot.utils.errors import DeviceNotConnectedError
from lerobot.utils.import_utils import register_third_party_plugins
from worlds.fake_robot import Ports, bridge, served, simulator

from uniteam.adapters.action_vector import ACTION_NAMES, vector_of
from uniteam.errors import InvalidActionError, InvalidInputError
from uniteam.interface import Action, BaseDisplacement, DiscreteAction
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.simulation.simulator import Simulator


@pytest.fixture(scope="module")
def world(tmp_path_factory: pytest.TempPathFactory) -> Simulator:
    return simulator(tmp_path_factory.mktemp("models"))


@pytest.fixture
def side(world: Simulator) -> FakeBridge:
    return bridge(world)


@pytest.fixture
def ports(side: FakeBridge) -> Iterator[Ports]:
    with served(side) as ports:
        yield ports


def robot(port: int, folder: Path, **options: object) -> Robot:
    register_third_party_plugins()
    kind = RobotConfig.get_choice_class("uniteam_stretch")
    fast = {"speed": 0.3, "turn_speed": 1.0, "height": 128, "width": 96, **options}
    return make_robot_from_config(kind(host="127.0.0.1", port=port, calibration_dir=folder, **fast))


def numbers(action: Action) -> dict[str, float]:
    return dict(zip(ACTION_NAMES, map(float, vector_of(action)), strict=True))


def test_what_it_sees_and_takes_is_known_before_it_is_reached(tmp_path: Path) -> None:
    unreached = robot(4401, tmp_path)
    assert unreached.name == "uniteam_stretch"
    assert set(unreached.action_features) == set(ACTION_NAMES)
    assert unreached.observation_features["head"] == (128, 96, 3)
    assert unreached.observation_features["lift.pos"] is float
    assert not unreached.is_connected
    with pytest.raises(DeviceNotConnectedError):
        unreached.get_observation()


def test_it_drives_the_robot_and_shows_what_came_of_it(side: FakeBridge, ports: Ports, tmp_path: Path) -> None:
    with robot(ports.first, tmp_path) as reached:
        start = side.robot.base
        before = reached.get_observation()
        assert set(before) == set(reached.observation_features)
        assert before["head"].shape == (128, 96, 3)
        assert before["head"].dtype == np.uint8
        asked = numbers(DiscreteAction.TURN_LEFT)
        assert reached.send_action(asked) == asked
        after = reached.get_observation()
        assert after["base_heading.pos"] == pytest.approx(math.pi / 6, abs=0.05)
        assert side.robot.base.heading - start.heading == pytest.approx(math.pi / 6, abs=0.05)
        assert np.abs(after["head"].astype(int) - before["head"]).mean() > 1.0
        with pytest.raises(InvalidActionError, match=r"lacks base_x\.delta"):
            reached.send_action({"stop": 1.0})
    assert not reached.is_connected


def test_a_dry_run_moves_nothing(side: FakeBridge, ports: Ports, tmp_path: Path) -> None:
    with robot(ports.first, tmp_path, dry_run=True) as looking:
        start = side.robot.base
        looking.send_action(numbers(BaseDisplacement(x=0.5)))
        assert side.robot.base == start


def test_pictures_of_other_proportions_and_unsafe_speeds_are_refused(ports: Ports, tmp_path: Path) -> None:
    with pytest.raises(InvalidInputError, match="cannot be shrunk to 128x128"):
        robot(ports.first, tmp_path, width=128).connect()
    with pytest.raises(ValueError, match=r"speed must be above 0 and at most 0\.3"):
        robot(ports.first, tmp_path, speed=0.5)
