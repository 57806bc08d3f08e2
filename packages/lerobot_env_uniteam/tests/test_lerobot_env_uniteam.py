"""LeRobot finds the environment by the package's name and gets of it what it asks an environment for."""

from importlib.metadata import distribution

import numpy as np
import pytest

pytest.importorskip("lerobot", reason="LeRobot is not installed")

from lerobot.envs import make_env, preprocess_observation
from lerobot.envs.configs import EnvConfig
from lerobot.utils.import_utils import register_third_party_plugins

from uniteam.adapters.action_vector import ACTION_NAMES, vector_of
from uniteam.interface import DiscreteAction


@pytest.fixture(autouse=True)
def found() -> None:
    register_third_party_plugins()


def config(**options: object) -> EnvConfig:
    made: EnvConfig = EnvConfig.get_choice_class("uniteam")(split="minival", **options)
    return made


def test_the_distribution_has_the_name_that_lerobot_looks_for() -> None:
    assert distribution("lerobot_env_uniteam").metadata["Name"] == "lerobot_env_uniteam"
    assert config().type == "uniteam"


@pytest.mark.parametrize("in_processes", [False, True])
def test_environments_show_and_take_what_the_features_say(in_processes: bool) -> None:
    wanted = config(episode_length=3)
    env = make_env(wanted, n_envs=2, use_async_envs=in_processes)["uniteam"][0]
    try:
        observation, _ = env.reset(seed=[0, 1], options={"lerobot_new_rollout": True})
        given = preprocess_observation(observation)
        assert set(given) == {"observation.images.head", "observation.state"}
        assert tuple(given["observation.images.head"].shape) == (2, 3, 320, 240)
        assert tuple(given["observation.state"].shape) == (2, wanted.features["agent_pos"].shape[0])
        assert env.call("_max_episode_steps") == (3, 3)
        assert all(words.startswith("Move ") for words in env.call("task_description"))
        assert env.call("task") == env.call("task_description")
        action = np.stack([vector_of(DiscreteAction.TURN_LEFT), vector_of(DiscreteAction.STOP)])
        _, _, terminated, _, info = env.step(action)
        assert terminated.tolist() == [False, True]
        assert info["final_info"]["is_success"].tolist() == [False, False]
    finally:
        env.close()


def test_the_action_is_that_of_datasets() -> None:
    env = make_env(config(), n_envs=1)["uniteam"][0]
    assert env.single_action_space.shape == (len(ACTION_NAMES),)
    before = env.reset(seed=[0])[0]["agent_pos"][0]
    after = env.step(vector_of(DiscreteAction.TURN_LEFT)[None])[0]["agent_pos"][0]
    turned = after - before
    assert turned[np.abs(turned) > 1e-6].tolist() == pytest.approx([np.pi / 6])


def test_a_camera_that_there_is_not_is_refused() -> None:
    with pytest.raises(ValueError, match="there are half, full"):
        config(camera="tiny")
