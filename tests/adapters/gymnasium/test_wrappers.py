"""The wrappers say the same in another form."""

import warnings
from pathlib import Path

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from worlds.gym_scene import judged_split
from worlds.judged_scene import EPISODE

from uniteam.adapters.action_vector import vector_of
from uniteam.adapters.gymnasium.ovmm_env import OvmmEnv
from uniteam.adapters.gymnasium.task_env import SKILLS, TaskEnv
from uniteam.adapters.gymnasium.wrappers import ImageAndVector, PixelsAndState, SmallPictures
from uniteam.adapters.state_vector import state_vector
from uniteam.errors import InvalidInputError
from uniteam.interface import BaseDisplacement, DiscreteAction, JointDisplacement, Joints
from uniteam.world.task.environment import Environment
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


def test_the_whole_task_shows_and_takes_what_a_dataset_of_it_holds(tmp_path: Path) -> None:
    split = judged_split(tmp_path)
    env = PixelsAndState(OvmmEnv(split=split, camera="half", actions="metric"))
    with warnings.catch_warnings():
        warnings.filterwarnings("error")
        warnings.filterwarnings("ignore", message=".*different from the unwrapped version")
        warnings.filterwarnings("ignore", message=".*symmetric and normalized space")  # its numbers are in m and rad
        warnings.filterwarnings("ignore", message=".*(minimum|maximum) value is -?infinity")
        check_env(env, skip_render_check=True)
    world = Environment(split.homes[EPISODE.home], EPISODE)
    seen, (given, _) = world.reset(), env.reset(seed=0)
    actions = (
        DiscreteAction.TURN_LEFT, BaseDisplacement(x=0.5), JointDisplacement(Joints(-0.25, 0.25, 0.5, head_tilt=0.125)),
        DiscreteAction.MANIPULATION_MODE, DiscreteAction.STOP,
    )  # fmt: skip
    for action in actions:
        np.testing.assert_array_equal(given["pixels"]["head"], seen.rgb)
        np.testing.assert_allclose(
            given["agent_pos"], state_vector(seen.joints, seen.base_to_start, seen.is_holding), atol=1e-6
        )
        seen = world.step(action)
        given, _, is_over, _, _ = env.step(vector_of(action))
    assert is_over
    assert env.task == str(EPISODE.instruction)


def test_another_task_is_not_shown_as_a_dataset_holds_it(tmp_path: Path) -> None:
    with pytest.raises(InvalidInputError, match="head_rgb, joint, is_holding is not observed here"):
        PixelsAndState(TaskEnv("NavigateToObject", judged_split(tmp_path)))
