"""What was decided of a recording is kept beside it, and holds for that recording and those rules alone."""

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from worlds.recorded import record_made
from worlds.saboteur import Saboteur

import uniteam
from uniteam.errors import DamagedFileError
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.analysis.kept_causes import cause_of, cause_path, deciding_code
from uniteam.evaluation.causes.cause import Cause
from uniteam.interface import DiscreteAction

MARK = "as it was kept"


def recorded(path: Path, action: DiscreteAction) -> Path:
    record_made(
        path, lambda environment: Saboteur(environment, lambda decisions: iter([action])), AgentSpec("random", "truth")
    )
    return path


@pytest.fixture(scope="module")
def grasping(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return recorded(tmp_path_factory.mktemp("made") / "grasp.zip", DiscreteAction.SNAP_OBJECT)


@pytest.fixture
def recording(grasping: Path, tmp_path: Path) -> Path:
    return Path(shutil.copy(grasping, tmp_path / "one.zip"))


def edit(path: Path, change: Callable[[dict[str, Any]], None]) -> None:
    data = json.loads(path.read_text())
    change(data)
    path.write_text(json.dumps(data))


def mark(data: dict[str, Any]) -> None:
    data["diagnosis"]["words"] = MARK


def decided(recording: Path) -> tuple[Cause, str]:
    found = cause_of(recording).diagnosis
    assert found is not None
    return found.cause, found.words


def test_a_cause_is_decided_once(recording: Path) -> None:
    first = cause_of(recording)
    assert first.diagnosis is not None and first.diagnosis.cause is Cause.OUT_OF_VIEW
    assert cause_of(recording) == first
    edit(cause_path(recording), mark)
    assert decided(recording) == (Cause.OUT_OF_VIEW, MARK)


def test_another_recording_in_its_place_is_decided_anew(recording: Path) -> None:
    cause_of(recording)
    recorded(recording, DiscreteAction.STOP)
    assert decided(recording)[0] is Cause.GAVE_UP
    edit(cause_path(recording), mark)
    assert decided(recording) == (Cause.GAVE_UP, MARK)


def test_other_rules_decide_anew(recording: Path) -> None:
    cause_of(recording)
    edit(cause_path(recording), mark)
    edit(cause_path(recording), lambda data: data.update(rules="others"))
    assert decided(recording)[1] != MARK


def test_a_line_of_a_rule_or_of_what_it_looks_at_makes_other_rules(tmp_path: Path) -> None:
    copy = Path(shutil.copytree(Path(uniteam.__file__).parent / "evaluation", tmp_path / "evaluation"))
    digests = [deciding_code(copy)]
    for changed in ("causes/rules/search_rules.py", "causes/reading/places.py", "recording/recording.py"):
        with (copy / changed).open("a") as file:
            file.write("\n")
        digests.append(deciding_code(copy))
    assert len(set(digests)) == 4


def test_what_was_kept_and_is_damaged_is_decided_anew(recording: Path) -> None:
    first = cause_of(recording)
    cause_path(recording).write_bytes(b"{")
    assert cause_of(recording) == first
    edit(cause_path(recording), mark)
    assert decided(recording)[1] == MARK


def test_a_cause_that_cannot_be_kept_is_told_all_the_same(recording: Path) -> None:
    cause_path(recording).mkdir()
    assert decided(recording)[0] is Cause.OUT_OF_VIEW


def test_a_recording_that_is_gone_is_no_recording_whatever_was_kept(recording: Path) -> None:
    cause_of(recording)
    recording.unlink()
    with pytest.raises(DamagedFileError, match=r"one\.zip"):
        cause_of(recording)
