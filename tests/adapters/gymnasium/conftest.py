"""The judged room, opened once: to open it takes most of a test's time."""

import pytest
from worlds.gym_scene import opened
from worlds.judged_scene import EPISODE

from uniteam.adapters.gymnasium.open_home import OpenHome


@pytest.fixture(scope="session")
def open_room(tmp_path_factory: pytest.TempPathFactory) -> OpenHome:
    return opened(tmp_path_factory.mktemp("room"))


@pytest.fixture
def room(open_room: OpenHome) -> OpenHome:
    """The room with everything in its place."""
    open_room.simulator.reset(EPISODE.start)
    return open_room
