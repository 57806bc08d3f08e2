"""Actions as vectors of named numbers: what each number is, and that what is done comes back."""

import math

import numpy as np
import pytest
from worlds.filled import filled

from uniteam.adapters.action_vector import ACTION_NAMES, action_bounds, action_of, vector_of
from uniteam.errors import InvalidActionError
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.interface import Action, BaseDisplacement, DiscreteAction, JointDisplacement, Joints
from uniteam.world.task.environment import Environment
from uniteam.world.task.splits import load_split


def named(action: Action) -> dict[str, float]:
    """Return the numbers of an action that are not 0, by name."""
    return {name: float(x) for name, x in zip(ACTION_NAMES, vector_of(action), strict=True) if x != 0.0}


def test_each_action_has_its_numbers_in_metres_and_radians() -> None:
    assert named(DiscreteAction.MOVE_FORWARD) == {"base_x.delta": 0.25}
    assert named(DiscreteAction.TURN_RIGHT) == {"base_heading.delta": pytest.approx(-math.pi / 6)}
    assert named(DiscreteAction.SNAP_OBJECT) == {"gripper": 1.0}
    assert named(DiscreteAction.DESNAP_OBJECT) == {"gripper": -1.0}
    assert named(DiscreteAction.MANIPULATION_MODE) == {"manipulation_mode": 1.0}
    assert named(DiscreteAction.NAVIGATION_MODE) == {"navigation_mode": 1.0}
    assert named(DiscreteAction.EXTEND_ARM) == {"extend_arm": 1.0}
    assert named(DiscreteAction.STOP) == {"stop": 1.0}
    assert named(DiscreteAction.EMPTY_ACTION) == {}
    assert named(BaseDisplacement(0.5, -0.25, 0.125)) == {
        "base_x.delta": 0.5, "base_y.delta": -0.25, "base_heading.delta": 0.125,
    }  # fmt: skip
    delta = Joints(*(0.0625 * k for k in range(1, 8)))
    assert named(JointDisplacement(delta, BaseDisplacement(x=0.25))) == {
        "base_x.delta": 0.25, "lift.delta": 0.0625, "arm.delta": 0.125, "wrist_yaw.delta": 0.1875,
        "wrist_pitch.delta": 0.25, "wrist_roll.delta": 0.3125, "head_pan.delta": 0.375, "head_tilt.delta": 0.4375,
    }  # fmt: skip


def test_an_action_comes_back_from_its_numbers() -> None:
    whole = filled(
        a for a in DiscreteAction if a.value not in ("move_forward", "turn_left", "turn_right", "empty_action")
    )
    for action in whole:
        assert action_of(vector_of(action)) is action
    assert action_of(vector_of(DiscreteAction.MOVE_FORWARD)) == BaseDisplacement(x=0.25)
    moves = (
        BaseDisplacement(0.5, -0.25, 0.125),
        JointDisplacement(Joints(0.25, -0.125, head_pan=0.5), BaseDisplacement(y=0.5)),
    )
    for move in moves:
        assert action_of(vector_of(move)) == move


def asked(**numbers: float) -> Action:
    return action_of([numbers.get(name.removesuffix(".delta"), 0.0) for name in ACTION_NAMES])


def test_one_thing_is_done_and_what_a_policy_only_hints_at_is_not() -> None:
    assert asked(stop=0.6, gripper=1.0) is DiscreteAction.STOP
    assert asked(gripper=-0.6, navigation_mode=1.0) is DiscreteAction.DESNAP_OBJECT
    assert asked(manipulation_mode=0.6, base_x=0.5) is DiscreteAction.MANIPULATION_MODE
    assert asked(stop=0.5, gripper=0.5, extend_arm=0.5, base_x=0.5) == BaseDisplacement(x=0.5)


def test_what_is_beyond_the_bounds_is_cut() -> None:
    assert named(asked(base_x=3.0, base_heading=-9.0)) == {
        "base_x.delta": 1.0, "base_heading.delta": pytest.approx(-math.pi),
    }  # fmt: skip
    low, high = action_bounds()
    assert low.shape == high.shape == (len(ACTION_NAMES),)
    assert high[ACTION_NAMES.index("lift.delta")] == pytest.approx(1.1)


@pytest.mark.parametrize("given", [[0.0] * 14, [0.0] * 14 + [np.nan], "forward", None])
def test_what_is_no_action_is_refused_with_the_names(given: object) -> None:
    with pytest.raises(InvalidActionError, match=r"15 finite numbers \(base_x.delta"):
        action_of(given)


def test_an_episode_played_from_its_vectors_comes_to_the_same() -> None:
    split = load_split("minival")
    episode = split.episodes[1]
    environment = Environment(split.homes[episode.home], episode)
    agent = AgentSpec("oracle", "truth").make(environment)
    agent.reset(episode.instruction, episode.seed)
    observation, vectors = environment.reset(), []
    while not environment.is_over:
        action = agent.act(observation).action
        vectors.append(vector_of(action))
        observation = environment.step(action)
    measures, end = environment.measures, environment.simulator.base
    assert measures.overall_success

    environment.reset()
    for vector in filled(vectors):
        environment.step(action_of(vector))
    assert environment.measures == measures
    assert environment.simulator.base.distance_to(end.x, end.y) < 1e-4
