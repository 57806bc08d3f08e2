"""Results that are handed in: what their actions come to is found out, and nothing is taken on trust."""

import logging
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest
from worlds.submitted import AGENT, SCRIPT, alter, write_submission

from uniteam.errors import DamagedFileError, InvalidInputError, UniteamError
from uniteam.evaluation.recording.action_file import write_actions
from uniteam.evaluation.recording.order import ACTION_SUFFIX, RECORDINGS, recording_path
from uniteam.evaluation.verification.replay_actions import check_claims
from uniteam.evaluation.verification.submission import open_submission
from uniteam.interface import DiscreteAction
from uniteam.world.task.splits import load_split

FIRST, SECOND = (load_split("minival").episodes[k].id for k in (0, 5))


@pytest.fixture(scope="module")
def played(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_submission(tmp_path_factory.mktemp("submission"))


@pytest.fixture
def folder(played: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(played, tmp_path / "run"))


def found_in(folder: Path) -> dict[str, list[str]]:
    submission = open_submission(folder)
    return {claim.episode.id: found for claim, found in check_claims(submission, submission.claims)}


def test_true_results_are_confirmed_from_actions_alone_and_from_a_recording(folder: Path) -> None:
    assert found_in(folder) == {FIRST: [], SECOND: []}


def test_a_measure_that_was_bettered_is_named(folder: Path) -> None:
    alter(
        folder / "results.jsonl",
        lambda text: text.replace('"does_want_terminate": true', '"does_want_terminate": false', 1),
    )
    assert found_in(folder) == {FIRST: ["does_want_terminate was false and is now true"], SECOND: []}


@pytest.mark.parametrize(
    ("actions", "words"),
    [
        (SCRIPT, "num_steps was 12 and is now 11"),
        ((*SCRIPT, DiscreteAction.STOP, DiscreteAction.STOP), "the episode is over after 12 of its 13 actions"),
        ((*SCRIPT, DiscreteAction.TURN_LEFT), "does_want_terminate was true and is now false"),
    ],
)
def test_other_actions_are_found_out(folder: Path, actions: tuple[DiscreteAction, ...], words: str) -> None:
    write_actions(recording_path(folder / RECORDINGS, AGENT, FIRST, ACTION_SUFFIX), AGENT, FIRST, actions)
    found = found_in(folder)
    assert words in found[FIRST]
    assert found[SECOND] == []


def test_actions_that_end_before_the_episode_does_are_found_out(folder: Path) -> None:
    """As they would be of an agent that looks back at its best moment."""
    write_actions(recording_path(folder / RECORDINGS, AGENT, FIRST, ACTION_SUFFIX), AGENT, FIRST, SCRIPT)
    alter(
        folder / "results.jsonl",
        lambda text: text.replace('"does_want_terminate": true', '"does_want_terminate": false', 1).replace(
            '"num_steps": 12', '"num_steps": 11', 1
        ),
    )
    assert found_in(folder)[FIRST] == ["the 11 actions end before the episode does"]


def test_actions_of_another_episode_are_found_out(folder: Path) -> None:
    path = recording_path(folder / RECORDINGS, AGENT, FIRST, ACTION_SUFFIX)
    write_actions(path, AGENT, SECOND, SCRIPT)
    (told,) = found_in(folder)[FIRST]
    assert f"is uniteam actions 1 of random's episode '{SECOND}'" in told


@pytest.mark.parametrize(
    ("change", "kind", "sentence"),
    [
        (lambda text: text.replace("test-1000", "test-9999"), DamagedFileError, "which the split has not"),
        (
            lambda text: text.replace('"unseen": true', '"unseen": false', 1),
            DamagedFileError,
            "unseen was false and is",
        ),
        (
            lambda text: text.replace('"traceback": ""', '"traceback": "x"', 1),
            DamagedFileError,
            "it crashed, and has measures of one that did not",
        ),
        (lambda text: "", InvalidInputError, "holds no result"),
    ],
)
def test_results_that_cannot_be_are_refused_before_anything_is_played(
    folder: Path, change: Callable[[str], str], kind: type[UniteamError], sentence: str
) -> None:
    alter(folder / "results.jsonl", change)
    with pytest.raises(kind, match=sentence):
        open_submission(folder)


def test_results_without_recordings_are_refused(folder: Path) -> None:
    recording_path(folder / RECORDINGS, AGENT, FIRST, ACTION_SUFFIX).unlink()
    with pytest.raises(InvalidInputError, match="no recording of 1 of its 2 results, such as random's"):
        open_submission(folder)


def test_another_version_of_the_split_is_refused_and_other_code_is_told(
    folder: Path, caplog: pytest.LogCaptureFixture
) -> None:
    alter(folder / "config.json", lambda text: text.replace('"code": "', '"code": "0'))
    with caplog.at_level(logging.WARNING):
        open_submission(folder)
    assert "was played by other software" in caplog.text
    alter(folder / "config.json", lambda text: text.replace('"split_version": 2', '"split_version": 1'))
    with pytest.raises(InvalidInputError, match="split_version was 1 and is now 2"):
        open_submission(folder)


def test_a_seed_draws_the_same_episodes_again_and_another_one_others(folder: Path) -> None:
    submission = open_submission(folder)
    drawn = [submission.sample(1, seed)[0].episode.id for seed in range(8)]
    assert drawn == [submission.sample(1, seed)[0].episode.id for seed in range(8)]
    assert set(drawn) == {FIRST, SECOND}
    assert [claim.episode.id for claim in submission.sample(9, 0)] == sorted((FIRST, SECOND))
