"""Which episodes are drawn hangs on the generator alone, and a home stays for some of them."""

import numpy as np
import pytest
from worlds.filled import filled

from uniteam.adapters.gymnasium.draw import Draw
from uniteam.stretch import HEAD_CAMERA_SMALL
from uniteam.world.task.episode import Episode


@pytest.fixture(scope="module")
def draw() -> Draw:
    return Draw("val", HEAD_CAMERA_SMALL, stay=3)


def drawn(draw: Draw, seed: int, count: int) -> list[Episode]:
    draw.restart()
    generator = np.random.default_rng(seed)
    return [draw.any(generator) for _ in range(count)]


def test_a_home_stays_for_its_number_of_episodes(draw: Draw) -> None:
    homes = [episode.home for episode in drawn(draw, 0, 30)]
    stays = [set(homes[first : first + 3]) for first in range(0, 30, 3)]
    assert all(len(stay) == 1 for stay in filled(stays))
    assert len(set(homes)) > 5


def test_after_a_restart_the_same_generator_draws_the_same(draw: Draw) -> None:
    first = drawn(draw, 5, 4)  # the second home stays for two more
    assert drawn(draw, 5, 4) == first
    assert drawn(draw, 6, 4) != first


def test_every_episode_of_a_home_can_be_drawn(draw: Draw) -> None:
    generator = np.random.default_rng(0)
    found = {draw.any(generator).id for _ in range(6000)}
    assert found == {episode.id for episode in draw.split.episodes}
