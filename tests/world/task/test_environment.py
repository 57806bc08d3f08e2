"""The environment: what an agent sees, when an episode is over, and that the same actions give the same trace."""

import json
import pickle
from dataclasses import asdict, fields, is_dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from worlds.filled import filled
from worlds.judged_scene import EPISODE, judged_home

from uniteam.errors import InvalidActionError, InvalidInputError
from uniteam.geometry import BasePose, PinholeCamera, invert_transform
from uniteam.interface import (
    Action,
    BaseDisplacement,
    Decision,
    DiscreteAction,
    JointDisplacement,
    Joints,
    Observation,
)
from uniteam.world.simulation.step_events import StepEvents
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import MAXIMUM_STEPS, Episode, Split
from uniteam.world.task.grasp_rules import EpisodeGraspRule, challenge, honest
from uniteam.world.task.splits import load_split

SMALL_CAMERA = PinholeCamera.from_horizontal_fov(48, 64, np.radians(42.0))


@pytest.fixture(scope="module")
def split() -> Split:
    return load_split("minival")


def _environment(split: Split, episode: Episode | None = None, give_truth: bool = False) -> Environment:
    episode = split.episodes[0] if episode is None else episode
    return Environment(split.homes[episode.home], episode, SMALL_CAMERA, give_truth)


def _random_actions(seed: int, count: int) -> list[Action]:
    rng = np.random.default_rng(seed)
    moves: list[Action] = [action for action in DiscreteAction if action is not DiscreteAction.STOP]
    for _ in range(count):
        moves.append(BaseDisplacement(float(rng.uniform(0.1, 1.0)), 0.0, float(rng.uniform(-3.0, 3.0))))
        moves.append(JointDisplacement(Joints(float(rng.uniform(-0.2, 0.2)), float(rng.uniform(-0.2, 0.2)))))
    return [moves[i] for i in rng.permutation(len(moves))[:count]]


def _same(one: Observation, other: Observation) -> bool:
    return (
        np.array_equal(one.rgb, other.rgb)
        and np.array_equal(one.depth, other.depth)
        and np.array_equal(one.camera_to_start, other.camera_to_start)
        and (one.base_to_start, one.joints, one.is_holding) == (other.base_to_start, other.joints, other.is_holding)
    )


def test_two_environments_side_by_side_agree_to_the_bit(split: Split) -> None:
    one, other = _environment(split), _environment(split)
    assert _same(one.reset(), other.reset())
    for action in filled(_random_actions(0, 40)):
        assert _same(one.step(action), other.step(action))
        assert one.measures == other.measures


def test_a_reset_brings_back_the_first_observation_and_clears_the_measures(split: Split) -> None:
    environment = _environment(split)
    first = environment.reset()
    for action in _random_actions(1, 20):
        environment.step(action)
    assert _same(environment.reset(), first)
    assert environment.measures.num_steps == 0


def test_an_object_that_was_carried_away_lies_in_its_place_after_a_reset(split: Split) -> None:
    environment = _environment(split)
    certificate = environment.episode.certificate
    assert certificate is not None
    environment.reset()
    before = environment.simulator.object_pose(certificate.object)
    simulator = environment.simulator
    simulator.reset(certificate.grasp)
    environment.step(DiscreteAction.MANIPULATION_MODE)
    assert environment.step(DiscreteAction.SNAP_OBJECT).is_holding
    environment.reset()
    assert simulator.held is None
    assert np.array_equal(simulator.object_pose(certificate.object), before)


def test_an_environment_plays_another_episode_of_its_home_as_a_fresh_one_would(split: Split) -> None:
    environment = _environment(split)
    environment.reset()
    environment.step(DiscreteAction.MOVE_FORWARD)
    simulator = environment.simulator
    first = split.episodes[0]
    assert first.certificate is not None
    second = replace(first, id="another", start=first.certificate.release, seed=1)
    assert _same(environment.reset(second), _environment(split, second).reset())
    assert environment.simulator is simulator
    assert environment.episode is second


def test_a_start_in_collision_is_refused(split: Split) -> None:
    wall = split.homes[split.episodes[0].home].stage.walls[0]
    x, y = (wall.start[0] + wall.end[0]) / 2, (wall.start[1] + wall.end[1]) / 2
    with pytest.raises(InvalidInputError, match="start"):
        _environment(split, replace(split.episodes[0], start=BasePose(x, y, 0.0)))


def test_an_observation_cannot_be_written_into(split: Split) -> None:
    observation = _environment(split, give_truth=True).reset()
    assert observation.truth is not None
    arrays = (observation.rgb, observation.depth, observation.camera_to_start, observation.truth.instances)
    for array in arrays:
        with pytest.raises(ValueError, match="read-only"):
            array[:] = 0


def test_a_step_before_the_reset_is_refused(split: Split) -> None:
    environment = _environment(split)
    with pytest.raises(InvalidInputError, match=r"call reset\(\)"):
        environment.step(DiscreteAction.TURN_LEFT)
    assert environment.measures.num_steps == 0


def test_what_is_no_action_is_refused_before_anything_moves(split: Split) -> None:
    environment = _environment(split)
    first = environment.reset()
    nan, still = float("nan"), Joints(0.0, 0.0)
    wrong: list[Any] = [
        Decision(DiscreteAction.STOP, "S", "r"), None, "turn_left", 2, np.int64(2), DiscreteAction,
        BaseDisplacement(x=nan), BaseDisplacement(heading=float("inf")), BaseDisplacement(x=10**400),
        BaseDisplacement(x=True), BaseDisplacement(y=1j), BaseDisplacement(x="1"), BaseDisplacement(x=np.zeros(1)),  # type: ignore[arg-type]
        JointDisplacement(Joints(nan, 0.0)), JointDisplacement(still, base=None), JointDisplacement(None),  # type: ignore[arg-type]
    ]  # fmt: skip
    for action in wrong:
        with pytest.raises(InvalidActionError):
            environment.step(action)
    assert environment.measures.num_steps == 0
    assert environment.simulator.joints == first.joints


def test_numbers_of_any_width_leave_plain_floats(split: Split) -> None:
    environment = _environment(split)
    environment.reset()
    observation = environment.step(BaseDisplacement(heading=np.float16(0.7)))  # type: ignore[arg-type]
    json.dumps(asdict(observation.base_to_start))
    assert type(observation.base_to_start.heading) is float


def test_an_environment_says_what_to_send_in_its_place(split: Split) -> None:
    with pytest.raises(TypeError, match="send its home and episode"):
        pickle.dumps(_environment(split))


def test_the_events_tell_what_came_of_the_last_step(split: Split) -> None:
    environment = _environment(split)
    environment.reset()
    assert environment.events == StepEvents()
    for _ in range(60):
        environment.step(DiscreteAction.MOVE_FORWARD)
        if environment.events.blocked:
            break
    assert environment.events.blocked


def test_poses_are_given_from_where_the_episode_began(split: Split) -> None:
    environment = _environment(split)
    start = environment.reset()
    assert np.allclose([start.base_to_start.x, start.base_to_start.y, start.base_to_start.heading], 0.0)
    turned = environment.step(DiscreteAction.TURN_LEFT)
    assert turned.base_to_start.heading == pytest.approx(np.radians(30.0))
    to_start = invert_transform(environment.episode.start.matrix())
    assert np.allclose(turned.camera_to_start, to_start @ environment.simulator.camera_to_world())
    assert 1.2 < turned.camera_to_start[2, 3] < 1.4


def test_truth_is_given_only_to_those_who_asked(split: Split) -> None:
    assert _environment(split).reset().truth is None
    assert _environment(split, give_truth=True).reset().truth is not None


def test_the_truth_names_what_the_frame_shows_in_the_order_of_its_pixels(split: Split) -> None:
    environment = _environment(split, give_truth=True)
    environment.reset()
    several = 0
    for _ in range(6):
        truth = environment.step(DiscreteAction.TURN_LEFT).truth
        assert truth is not None
        shown = environment.simulator.render().instances
        first_shown = list(dict.fromkeys(shown[shown >= 0].tolist()))
        several += len(first_shown) > 1
        names = [detection.candidates for detection in truth.detections]
        assert names == [((environment.home.instances[index].category, 1.0),) for index in first_shown]
        assert list(dict.fromkeys(truth.instances[truth.instances >= 0].tolist())) == list(range(len(first_shown)))
        assert np.array_equal(truth.instances >= 0, shown >= 0)
    assert several > 2


def test_no_field_of_an_observation_tells_of_what_is_not_seen(tmp_path: Path) -> None:
    """Two homes that differ in what lies behind the robot look the same to the last bit."""
    seen = []
    for without in ("", "ball"):
        environment = Environment(judged_home(tmp_path, without), EPISODE, SMALL_CAMERA, give_truth=True)
        observations = (environment.reset(), environment.step(DiscreteAction.TURN_RIGHT))
        assert [name for o in observations for name in _names(o)] != []
        assert not any("ball" in _names(o) for o in observations)
        seen.append([_as_bytes(o) for o in observations])
    assert seen[0] == seen[1]


def _names(observation: Observation) -> list[str]:
    assert observation.truth is not None
    return [detection.name for detection in observation.truth.detections]


def _as_bytes(value: Any) -> Any:
    """Return a value whose arrays, however deep in it, are bytes, so that it can be compared."""
    if isinstance(value, np.ndarray):
        return value.tobytes()
    if is_dataclass(value) and not isinstance(value, type):
        return {field.name: _as_bytes(getattr(value, field.name)) for field in fields(value)}
    return [_as_bytes(each) for each in value] if isinstance(value, tuple) else value


@pytest.mark.parametrize(("rule", "held"), [(honest, "ball"), (challenge, None)])
def test_only_an_honest_gripper_takes_a_wrong_thing_which_counts_for_nothing(
    tmp_path: Path, rule: EpisodeGraspRule, held: str | None
) -> None:
    environment = Environment(judged_home(tmp_path), EPISODE, SMALL_CAMERA, grasp=rule)
    environment.reset()
    environment.simulator.reset(BasePose(0.95, 2.8, np.pi / 2))  # the ball lies ahead, a cup beside it
    environment.step(DiscreteAction.MANIPULATION_MODE)
    environment.step(JointDisplacement(Joints(0.0, 0.0, head_tilt=-0.25)))
    assert environment.step(DiscreteAction.SNAP_OBJECT).is_holding is (held is not None)
    assert environment.simulator.held == held
    assert not environment.step(DiscreteAction.DESNAP_OBJECT).is_holding
    for _ in range(60):
        environment.step(DiscreteAction.EMPTY_ACTION)
    assert environment.measures.partial_success == 0.0
    assert not environment.measures.place_success


def test_stop_ends_the_episode(split: Split) -> None:
    environment = _environment(split)
    environment.reset()
    environment.step(DiscreteAction.STOP)
    assert environment.is_over
    assert environment.measures.does_want_terminate
    with pytest.raises(InvalidInputError, match="is over"):
        environment.step(DiscreteAction.TURN_LEFT)


def test_the_steps_of_an_episode_run_out(split: Split, monkeypatch: pytest.MonkeyPatch) -> None:
    assert MAXIMUM_STEPS == 1250
    monkeypatch.setattr("uniteam.world.task.environment.MAXIMUM_STEPS", 20)
    environment = _environment(split)
    environment.reset()
    for _ in range(20):
        assert not environment.is_over
        environment.step(DiscreteAction.EMPTY_ACTION)
    assert environment.is_over
    assert not environment.measures.does_want_terminate


def test_an_episode_is_not_played_in_another_home(split: Split) -> None:
    home = split.homes[split.episodes[0].home]
    with pytest.raises(InvalidInputError, match="elsewhere"):
        Environment(home, replace(split.episodes[0], home="elsewhere"))
