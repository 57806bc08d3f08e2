"""The whole task is the evaluation's own: the same actions come to the same pictures and measures."""

from dataclasses import asdict, replace
from typing import Any

import gymnasium
import numpy as np
import pytest
from worlds.filled import filled
from worlds.gym_scene import judged_split
from worlds.judged_scene import EPISODE

from uniteam.adapters.gymnasium.ovmm_env import OvmmEnv
from uniteam.adapters.gymnasium.task_env import TaskEnv
from uniteam.adapters.gymnasium.tasks.ovmm import ovmm
from uniteam.errors import UnknownNameError
from uniteam.interface import Action, DiscreteAction, Joints
from uniteam.stretch import HEAD_CAMERA_SMALL
from uniteam.world.oracle.oracle import Oracle
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Split
from uniteam.world.task.grasp_rules import challenge
from uniteam.world.task.splits import load_split

NUMBER = {action: number for number, action in enumerate(DiscreteAction)}


@pytest.fixture(scope="module")
def split(tmp_path_factory: pytest.TempPathFactory) -> Split:
    return judged_split(tmp_path_factory.mktemp("homes"))


def test_the_same_actions_come_to_the_same_as_in_the_evaluation(split: Split) -> None:
    world = Environment(split.homes[EPISODE.home], EPISODE, HEAD_CAMERA_SMALL)
    env = OvmmEnv(split=split)
    seen, (observation, _) = world.reset(), env.reset()
    actions = [a for a in DiscreteAction if a is not DiscreteAction.STOP] * 3 + [DiscreteAction.STOP]
    for action in filled(actions):
        np.testing.assert_array_equal(observation["head_rgb"], seen.rgb)
        np.testing.assert_allclose(observation["head_depth"][..., 0] * 10.0, seen.depth, rtol=1e-6)
        np.testing.assert_allclose(
            observation["robot_start_gps"], [seen.base_to_start.x, seen.base_to_start.y], atol=1e-6
        )
        seen = world.step(action)
        observation, _, is_ended, _, info = env.step(NUMBER[action])
        assert {name: info[name] for name in asdict(world.measures)} == asdict(world.measures)
        assert is_ended is world.is_over
    assert is_ended


class AsGiven:
    """Takes the actions of an agent as they are."""

    space = gymnasium.spaces.Discrete(1)

    def read(self, given: Any, joints: Joints, is_holding: bool) -> Action:
        return given


def test_the_return_is_the_partial_success_of_the_episode() -> None:
    split = load_split("minival")
    episode = split.episodes[0]
    world = Environment(split.homes[episode.home], episode, HEAD_CAMERA_SMALL)
    oracle, env = Oracle(world), TaskEnv(replace(ovmm(challenge), controls={"any": AsGiven()}), split)
    env.reset(options={"episode_id": episode.id})
    oracle.reset(episode.instruction, episode.seed)
    seen, rewards = world.reset(), []
    while not world.is_over:
        action = oracle.act(seen).action
        seen = world.step(action)
        _, reward, is_ended, _, info = env.step(action)
        rewards.append(reward)
    assert world.measures.overall_success
    assert is_ended and info["is_success"]
    assert [reward for reward in rewards if reward] == [0.25] * 4


def test_it_is_cut_after_1250_steps(split: Split) -> None:
    env = OvmmEnv(split=split)
    env.reset()
    wait = NUMBER[DiscreteAction.EMPTY_ACTION]
    ends = [env.step(wait)[2:4] for _ in range(1250)]
    assert set(ends[:-1]) == {(False, False)}
    assert ends[-1] == (False, True)


def test_an_unknown_grasp_rule_is_told() -> None:
    with pytest.raises(UnknownNameError, match="unknown grasp rule 'honnest': did you mean 'honest'"):
        OvmmEnv(grasp="honnest")
