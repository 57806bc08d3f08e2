"""The environments keep what Gymnasium asks of them, and one seed gives one trace."""

import json
import warnings
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from worlds.gym_scene import judged_split

from uniteam.adapters.gymnasium import ENVIRONMENTS
from uniteam.adapters.gymnasium.task_env import TaskEnv
from uniteam.errors import InvalidActionError, InvalidInputError, UnknownNameError
from uniteam.world.task.episode import Split


@pytest.fixture(scope="module")
def split(tmp_path_factory: pytest.TempPathFactory) -> Split:
    return judged_split(tmp_path_factory.mktemp("homes"))


def played(env: gymnasium.Env[Any, Any], seed: int, steps: int = 12) -> list[Any]:
    """Return what comes of some steps of a random policy after a seed, episodes that follow included."""
    observation, info = env.reset(seed=seed)
    trace: list[Any] = [observation, info]
    env.action_space.seed(seed)
    for _ in range(steps):
        step = env.step(env.action_space.sample())
        trace += step
        if step[2] or step[3]:
            trace += env.reset()
    return trace


@pytest.mark.parametrize("name", ENVIRONMENTS)
def test_gymnasium_checks_it_without_a_warning(name: str, split: Split) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        env = gymnasium.make(name, split=split)
        check_env(env.unwrapped)


@pytest.mark.parametrize("name", ENVIRONMENTS)
def test_the_same_seed_gives_the_same_trace_and_another_another(name: str, split: Split) -> None:
    first, second = (gymnasium.make(name, split=split) for _ in range(2))
    ours, theirs = played(first, 3), played(second, 3)
    np.testing.assert_equal(ours, theirs)
    np.testing.assert_equal(played(first, 3), theirs)
    if name != "uniteam/OVMM-v0":  # its start is the episode's
        assert any(not np.array_equal(ours[0][key], played(first, 4, 0)[0][key]) for key in ours[0])


def test_it_is_made_by_the_module_and_the_name(tmp_path: Path) -> None:
    env = gymnasium.make("uniteam.adapters.gymnasium:uniteam/Gaze-v0", split=judged_split(tmp_path))
    assert isinstance(env.unwrapped, TaskEnv)
    assert env.unwrapped.task.name == "Gaze"


@pytest.mark.parametrize("name", ENVIRONMENTS)
def test_its_specification_can_be_written_down(name: str) -> None:
    specification = gymnasium.spec(name)
    assert gymnasium.envs.registration.EnvSpec.from_json(specification.to_json()) == specification
    assert json.loads(specification.to_json())["max_episode_steps"] is None


def test_the_instruction_is_told(split: Split) -> None:
    env = TaskEnv("Place", split)
    assert env.task_description == ""
    _, info = env.reset(seed=0)
    assert info["instruction"] == env.task_description == "Move cup from sink to table"
    assert (info["episode_id"], info["home"], info["is_success"]) == ("judged", "small", False)
    assert env.step(np.zeros(10))[4]["instruction"] == info["instruction"]


def test_it_is_cut_after_its_steps_and_not_ended(split: Split) -> None:
    env = TaskEnv("Gaze", split)
    env.reset(seed=0)
    ends = [env.step(np.zeros(5))[2:4] for _ in range(300)]
    assert set(ends[:-1]) == {(False, False)}
    assert ends[-1] == (False, True)
    with pytest.raises(InvalidInputError, match="over after 300 steps; call reset"):
        env.step(np.zeros(5))


def test_an_action_that_is_none_moves_nothing(split: Split) -> None:
    env = TaskEnv("NavigateToObject", split)
    before, _ = env.reset(seed=0)
    with pytest.raises(InvalidActionError, match=r"4 finite numbers \(forward, turn, selector, stop\)"):
        env.step(np.full(4, np.nan))
    after = env.step(np.zeros(4))[0]
    np.testing.assert_equal(before["robot_start_gps"], after["robot_start_gps"])


def test_the_discrete_moves_of_a_navigation(split: Split) -> None:
    env = TaskEnv("NavigateToObject", split, actions="discrete")
    env.reset(seed=0)
    assert env.step(2)[0]["robot_start_compass"][0] == pytest.approx(np.radians(10.0))
    assert env.step(0)[2] is True


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"camera": "tiny"}, "unknown camera 'tiny'"),
        ({"actions": "continous"}, "unknown way to act 'continous': did you mean 'continuous'"),
        ({"render_mode": "rgb"}, "no render mode 'rgb'; there are rgb_array, third_person"),
        ({"episodes_per_home": 0}, "episodes_per_home=0 is too few"),
        ({"split": "vall"}, "unknown split or episode file 'vall'"),
        ({"task": "Gase"}, "unknown skill 'Gase': did you mean 'Gaze'"),
    ],
)
def test_a_wrong_option_is_told(split: Split, options: dict[str, Any], message: str) -> None:
    with pytest.raises((UnknownNameError, InvalidInputError), match=message):
        TaskEnv(**{"task": "Gaze", "split": split, **options})


def test_an_episode_is_played_by_its_id(split: Split) -> None:
    env = TaskEnv("Gaze", split)
    assert env.episode_ids == ("judged",)
    assert env.reset(options={"episode_id": "judged"})[1]["episode_id"] == "judged"
    with pytest.raises(UnknownNameError, match="unknown episode of split judged 'judge'"):
        env.reset(options={"episode_id": "judge"})


def test_to_step_or_render_before_the_first_reset_is_told(split: Split) -> None:
    env = TaskEnv("Gaze", split, render_mode="rgb_array")
    for call in (lambda: env.step(np.zeros(5)), env.render):
        with pytest.raises(InvalidInputError, match="no episode has begun; call reset"):
            call()


def test_the_two_pictures_are_of_the_head_camera_and_of_the_robot_from_above(split: Split) -> None:
    head = TaskEnv("Gaze", split, render_mode="rgb_array", camera="half")
    above = TaskEnv("Gaze", split, render_mode="third_person")
    for env, shape in ((head, (320, 240, 3)), (above, (480, 640, 3))):
        env.reset(seed=0)
        picture = env.render()
        assert picture is not None
        assert (picture.shape, picture.dtype) == (shape, np.uint8)
        assert picture.std() > 5.0


def test_what_is_observed_cannot_reach_back(split: Split) -> None:
    env = TaskEnv("Place", split)
    observation, _ = env.reset(seed=0)
    for value in observation.values():
        if isinstance(value, np.ndarray):
            value[...] = 1
    np.testing.assert_equal(env.reset(seed=0)[0], TaskEnv("Place", split).reset(seed=0)[0])


def test_libraries_can_add_their_statistics_of_the_episode(split: Split) -> None:
    env = gymnasium.wrappers.RecordEpisodeStatistics(TaskEnv("NavigateToObject", split))
    env.reset(seed=0)
    rewards = [float(env.step(np.zeros(4))[1])]
    _, last, _, _, info = env.step(np.array([0.0, 0.0, 0.0, 1.0]))
    assert info["episode"]["r"] == pytest.approx(sum(rewards) + float(last))
    assert info["episode"]["l"] == 2
