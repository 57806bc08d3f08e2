"""The room in which tests of a real Stretch and of a fake one let it drive, and the fake robot's side of its bridge."""

import pytest
from worlds.fake_robot import bridge, simulator

from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.simulation.simulator import Simulator


@pytest.fixture(scope="module")
def world(tmp_path_factory: pytest.TempPathFactory) -> Simulator:
    return simulator(tmp_path_factory.mktemp("models"))


@pytest.fixture
def side(world: Simulator) -> FakeBridge:
    return bridge(world)
