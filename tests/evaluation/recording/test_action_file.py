"""Actions in a file come back as they were, to the bit, and a file that is none is refused."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from uniteam.errors import DamagedFileError
from uniteam.evaluation.recording.action_data import action_from_data, action_to_data
from uniteam.evaluation.recording.action_file import read_actions, write_actions
from uniteam.interface import Action, BaseDisplacement, DiscreteAction, JointDisplacement, Joints

ACTIONS: tuple[Action, ...] = (
    DiscreteAction.TURN_LEFT,
    BaseDisplacement(0.1 + 0.2, 0.0, 1.0 / 3.0),
    JointDisplacement(Joints(lift=1e-17, arm=0.0, head_tilt=-0.7), BaseDisplacement(0.0, 0.0, 0.1)),
    DiscreteAction.STOP,
)


def test_actions_come_back_and_the_same_ones_give_the_same_bytes(tmp_path: Path) -> None:
    paths = [tmp_path / f"{k}.actions.gz" for k in range(2)]
    for path in paths:
        write_actions(path, "mine", "e1", ACTIONS)
        assert read_actions(path, "mine", "e1") == ACTIONS
    assert paths[0].read_bytes() == paths[1].read_bytes()


def test_numbers_of_numpy_are_written_too(tmp_path: Path) -> None:
    action = BaseDisplacement(np.float64(0.1), np.float32(0.5), 0.0)  # type: ignore[arg-type]
    write_actions(tmp_path / "a", "mine", "e1", [action])
    assert read_actions(tmp_path / "a", "mine", "e1") == (BaseDisplacement(0.1, 0.5, 0.0),)


@given(st.tuples(*[st.floats(allow_nan=False, allow_infinity=False)] * 3))
def test_every_displacement_comes_back(numbers: tuple[float, float, float]) -> None:
    action = BaseDisplacement(*numbers)
    assert action_from_data(action_to_data(action)) == action


@pytest.mark.parametrize(("agent", "episode"), [("other", "e1"), ("mine", "e2")])
def test_a_file_of_another_agent_or_episode_is_refused(tmp_path: Path, agent: str, episode: str) -> None:
    write_actions(tmp_path / "a", "mine", "e1", ACTIONS)
    with pytest.raises(DamagedFileError, match="of mine's episode 'e1'"):
        read_actions(tmp_path / "a", agent, episode)


@pytest.mark.parametrize("kept", [0, 12, -4])
def test_a_file_that_is_missing_or_torn_is_refused(tmp_path: Path, kept: int) -> None:
    with pytest.raises(DamagedFileError, match="No such file"):
        read_actions(tmp_path / "a", "mine", "e1")
    write_actions(tmp_path / "a", "mine", "e1", ACTIONS)
    (tmp_path / "a").write_bytes((tmp_path / "a").read_bytes()[:kept])
    with pytest.raises(DamagedFileError, match="cannot be read"):
        read_actions(tmp_path / "a", "mine", "e1")
