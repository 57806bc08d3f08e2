"""Vectors of environments, in one process and in four, with each way to go on after an end."""

from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.vector import AutoresetMode
from worlds.filled import filled
from worlds.gym_scene import judged_split

import uniteam.adapters.gymnasium  # noqa: F401
from uniteam.world.task.episode import Split

NAME = "uniteam/NavigateToObject-v0"
STAY, STOP = (0.0, 0.0, 0.0, -1.0), (0.0, 0.0, 0.0, 1.0)


@pytest.fixture(scope="module")
def split(tmp_path_factory: pytest.TempPathFactory) -> Split:
    return judged_split(tmp_path_factory.mktemp("homes"))


def made(
    split: Split, mode: str, autoreset: AutoresetMode, count: int = 4
) -> gymnasium.vector.VectorEnv[Any, Any, Any]:
    options = {"autoreset_mode": autoreset}
    return gymnasium.make_vec(NAME, count, vectorization_mode=mode, vector_kwargs=options, split=split)


def all_do(action: tuple[float, ...], count: int = 4) -> np.ndarray:
    return np.tile(np.array(action, np.float32), (count, 1))


def test_four_processes_give_what_one_gives(split: Split) -> None:
    one, four = (made(split, mode, AutoresetMode.NEXT_STEP) for mode in ("sync", "async"))
    results = []
    for envs in (one, four):
        observation, info = envs.reset(seed=7)
        envs.action_space.seed(7)
        trace: list[Any] = [{name: value.copy() for name, value in observation.items()}, list(info["instruction"])]
        for _ in range(6):
            step = envs.step(envs.action_space.sample())
            trace.append(
                [{name: value.copy() for name, value in step[0].items()}, *step[1:4], list(step[4]["episode_id"])]
            )
        envs.close()
        results.append(trace)
    np.testing.assert_equal(results[0], results[1])
    assert results[1][1] == ["Move cup from sink to table"] * 4
    depths = results[1][0]["head_depth"]
    assert not any(np.array_equal(depths[0], other) for other in filled(depths[1:]))


@pytest.mark.parametrize("mode", ["sync", "async"])
def test_after_an_end_the_next_step_resets(split: Split, mode: str) -> None:
    envs = made(split, mode, AutoresetMode.NEXT_STEP, 2)
    envs.reset(seed=0)
    _, _, ended, _, info = envs.step(all_do(STOP, 2))
    assert ended.all()
    assert "final_info" not in info
    observation, reward, ended, _, _ = envs.step(all_do(STAY, 2))
    envs.close()
    assert not ended.any()
    assert not reward.any()
    assert observation["robot_start_gps"] == pytest.approx(np.zeros((2, 2)), abs=1e-6)


@pytest.mark.parametrize("mode", ["sync", "async"])
def test_or_the_same_step_resets_and_the_last_is_in_the_info(split: Split, mode: str) -> None:
    envs = made(split, mode, AutoresetMode.SAME_STEP, 2)
    envs.reset(seed=0)
    envs.step(np.array([[0, 1, -1, -1], [0, -1, -1, -1]], np.float32))
    observation, _, ended, _, info = envs.step(all_do(STOP, 2))
    envs.close()
    assert ended.all()
    assert observation["robot_start_compass"] == pytest.approx(np.zeros((2, 1)), abs=1e-6)
    turned = [final["robot_start_compass"][0] for final in info["final_obs"]]
    assert turned == pytest.approx([np.pi / 6, -np.pi / 6])
    assert not info["final_info"]["is_success"].any()
    assert list(info["final_info"]["home"]) == ["small", "small"]
