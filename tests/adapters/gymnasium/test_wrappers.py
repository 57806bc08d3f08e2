"""The wrappers say the same in another form."""

import warnings
from pathlib import Path

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from worlds.gym_scene import judged_split

from uniteam.adapters.gymnasium.task_env import SKILLS, TaskEnv
from uniteam.adapters.gymnasium.wrappers import ImageAndVector, SmallPictures
from uniteam.errors import InvalidInputError
from uniteam.world.task.splits import load_split


@pytest.mark.parametrize("skill", SKILLS)
def test_pictures_become_channels_and_the_rest_a_vector(tmp_path: Path, skill: str) -> None:
    env = TaskEnv(skill, judged_split(tmp_path))
    wrapped = ImageAndVector(env)
    with warnings.catch_warnings():
        warnings.filterwarnings("error")
        warnings.filterwarnings("ignore", message=".*different from the unwrapped version")
        check_env(wrapped, skip_render_check=True)
    seen, _ = env.reset(seed=0)
    given = wrapped.observation(seen)
    np.testing.assert_allclose(given["image"][..., 0] / 255.0, seen["head_depth"][..., 0], atol=0.5 / 255)
    others = sorted(name for name, value in seen.items() if np.ndim(value) == 3 and name != "head_depth")
    np.testing.assert_array_equal(given["image"][..., 1:], np.concatenate([seen[name] for name in others], axis=-1))
    assert isinstance(env.observation_space, gymnasium.spaces.Dict)
    spaces = env.observation_space
    rest = [gymnasium.spaces.flatdim(spaces[name]) for name in seen if np.ndim(seen[name]) < 3]
    assert given["vector"].shape == (sum(rest),)
    assert given in wrapped.observation_space


def test_a_class_is_one_hot(tmp_path: Path) -> None:
    env = TaskEnv("NavigateToReceptacle", judged_split(tmp_path))
    seen, _ = env.reset(seed=0)
    vector = ImageAndVector(env).observation(seen)["vector"]
    assert vector[seen["goal_receptacle"]] == 1.0
    assert vector[:-3].sum() == 1.0


def test_shrunk_pictures_are_those_of_the_small_camera() -> None:
    split = load_split("minival")
    large, small = SmallPictures(TaskEnv("NavigateToObject", split, "full")), TaskEnv("NavigateToObject", split)
    assert large.observation_space == small.observation_space
    for seed in range(3):
        shrunk, direct = large.reset(seed=seed)[0], small.reset(seed=seed)[0]
        apart = np.abs(shrunk["head_depth"] - direct["head_depth"]) * 10.0
        assert np.median(apart) < 0.02
        assert np.mean(apart < 0.1) > 0.95
        for name in ("ovmm_nav_goal_segmentation", "receptacle_segmentation"):
            assert np.mean(shrunk[name] == direct[name]) > 0.98


def test_what_has_no_pictures_cannot_be_wrapped() -> None:
    with pytest.raises(InvalidInputError, match="a dictionary with pictures"):
        ImageAndVector(gymnasium.make("CartPole-v1"))
