"""The directory of a run: what it keeps, what it takes up again and what it refuses."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.evaluation.results.result import EpisodeResult, result_from_line, result_to_line
from uniteam.evaluation.results.store import ResultStore
from uniteam.world.task.measures import Measures

BASELINE = {"threshold": 0.45, "states": ("PICK", "PLACE")}
CONFIGURATION = {"version": "1", "split": "val", "agents": {"baseline": BASELINE}}
PLACED = Measures(True, True, True, True, robot_scene_colls=2, num_steps=311, does_want_terminate=True)
RESULT = EpisodeResult(
    episode="val_3",
    home="home_7",
    instruction="Move cup from table to sink",
    unseen=True,
    measures=PLACED,
    state="DONE",
    failure="placed the object but touched the scene in 2 steps",
    seconds=9.5,
    peak_memory=700.0,
)


def test_a_result_survives_the_way_to_a_line_and_back() -> None:
    crashed = replace(RESULT, traceback='File "x.py"\nValueError: ü')
    line = result_to_line("uniteam", crashed)
    assert line.count("\n") == 1
    assert result_from_line(line) == ("uniteam", crashed)


def test_a_line_carries_the_measures_under_the_challenges_names() -> None:
    measures = json.loads(result_to_line("uniteam", RESULT))["measures"]
    assert measures == {
        "find_object_phase_success": True,
        "pick_object_phase_success": True,
        "find_recep_phase_success": True,
        "place_success": True,
        "overall_success": False,
        "partial_success": 0.75,
        "robot_scene_colls": 2,
        "num_steps": 311,
        "does_want_terminate": True,
    }


def test_a_run_is_taken_up_where_it_was_left(tmp_path: Path) -> None:
    ResultStore(tmp_path, CONFIGURATION).append("baseline", RESULT)
    again = ResultStore(tmp_path, CONFIGURATION)
    assert again.results == {"baseline": {"val_3": RESULT}}


def test_a_half_written_last_line_is_dropped_and_the_next_result_is_whole(tmp_path: Path) -> None:
    ResultStore(tmp_path, CONFIGURATION).append("baseline", RESULT)
    path = tmp_path / "results.jsonl"
    path.write_text(path.read_text() + result_to_line("baseline", replace(RESULT, episode="val_4"))[:70])
    store = ResultStore(tmp_path, CONFIGURATION)
    assert list(store.results["baseline"]) == ["val_3"]
    store.append("baseline", replace(RESULT, episode="val_5"))
    assert list(ResultStore(tmp_path, CONFIGURATION).results["baseline"]) == ["val_3", "val_5"]


@pytest.mark.parametrize(
    "line", ["{", "[1, 2]", '{"agent": "baseline"}', '{"agent": "baseline", "measures": {}}', "null"]
)
def test_a_damaged_line_is_named_by_its_number(tmp_path: Path, line: str) -> None:
    ResultStore(tmp_path, CONFIGURATION).append("baseline", RESULT)
    path = tmp_path / "results.jsonl"
    path.write_text(path.read_text() + line + "\n" + result_to_line("baseline", RESULT))
    with pytest.raises(DamagedFileError, match="line 2"):
        ResultStore(tmp_path, CONFIGURATION)


def test_another_configuration_is_refused_with_what_differs(tmp_path: Path) -> None:
    ResultStore(tmp_path, CONFIGURATION)
    changed = {**CONFIGURATION, "agents": {"baseline": {**BASELINE, "threshold": 0.5}}}
    with pytest.raises(InvalidInputError, match=r"agents.baseline.threshold was 0.45 and is now 0.5.*--out"):
        ResultStore(tmp_path, changed)
    with pytest.raises(InvalidInputError, match="version was 1 and is now 2"):
        ResultStore(tmp_path, {**CONFIGURATION, "version": "2"})


def test_another_agent_joins_the_directory_and_the_first_stays(tmp_path: Path) -> None:
    ResultStore(tmp_path, CONFIGURATION).append("baseline", RESULT)
    store = ResultStore(tmp_path, {**CONFIGURATION, "agents": {"uniteam": {}}})
    store.append("uniteam", RESULT)
    assert set(store.results) == {"baseline", "uniteam"}
    assert set(json.loads((tmp_path / "config.json").read_text())["agents"]) == {"baseline", "uniteam"}


def test_a_damaged_configuration_is_an_error_that_names_the_file(tmp_path: Path) -> None:
    (tmp_path / "config.json").write_text('{"version": "1"')
    with pytest.raises(DamagedFileError, match=r"config\.json"):
        ResultStore(tmp_path, CONFIGURATION)
