"""The directory of a run: what it keeps, what it takes up again and what it refuses."""

import json
import logging
import os
import subprocess
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.evaluation.results.lock import FolderInUseError, FolderLock
from uniteam.evaluation.results.result import EpisodeResult, result_from_line, result_to_line
from uniteam.evaluation.results.store import ResultStore
from uniteam.files import UnwritableError
from uniteam.world.task.measures import Measures

BASELINE = {"threshold": 0.45, "states": ["PICK", "PLACE"]}
CONFIGURATION = {"version": "1", "split": "val", "agents": {"baseline": BASELINE}}
EPISODES = ("val_3", "val_4", "val_5")
PLACED = Measures(True, True, True, True, 2, 311, True, obj_scene_colls=5, robot_obj_colls=7)
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
LINE = result_to_line("baseline", RESULT)
SECOND_LINE = result_to_line("baseline", replace(RESULT, episode="val_4"))


@contextmanager
def opened(directory: Path, configuration: Mapping[str, Any] = CONFIGURATION) -> Iterator[ResultStore]:
    store = ResultStore(directory, configuration, EPISODES)
    try:
        yield store
    finally:
        store.close()


def begin(directory: Path, *lines: str) -> Path:
    """Make a directory with results, and return the path of their file."""
    with opened(directory):
        path = directory / "results.jsonl"
        path.write_text("".join(lines))
    return path


def recorded(directory: Path) -> list[str]:
    """Return the ids of the baseline's episodes that a directory has results of."""
    with opened(directory) as store:
        return list(store.results.get("baseline", {}))


def changed(**fields: Any) -> str:
    return json.dumps({**json.loads(LINE), **fields}) + "\n"


def test_a_result_survives_the_way_to_a_line_and_back() -> None:
    crashed = replace(RESULT, traceback='File "x.py"\nValueError: ü')
    line = result_to_line("uniteam", crashed)
    assert line.count("\n") == 1
    assert result_from_line(line) == ("uniteam", crashed)


def test_what_an_agent_says_is_kept_readable_whatever_it_says() -> None:
    line = result_to_line("uniteam", replace(RESULT, state="\ud800", failure="\udc80 and more"))
    assert result_from_line(line)[1].failure == "? and more"


def test_a_line_carries_the_measures_under_the_challenges_names() -> None:
    assert json.loads(LINE)["measures"] == {
        "find_object_phase_success": True,
        "pick_object_phase_success": True,
        "find_recep_phase_success": True,
        "place_success": True,
        "overall_success": False,
        "partial_success": 0.75,
        "robot_scene_colls": 2,
        "obj_scene_colls": 5,
        "robot_obj_colls": 7,
        "num_steps": 311,
        "does_want_terminate": True,
    }


def test_a_run_is_taken_up_where_it_was_left(tmp_path: Path) -> None:
    with opened(tmp_path) as store:
        store.append("baseline", RESULT)
    with opened(tmp_path) as again:
        assert again.results == {"baseline": {"val_3": RESULT}}


def test_a_half_written_last_line_is_dropped_and_the_next_result_is_whole(tmp_path: Path) -> None:
    begin(tmp_path, LINE, SECOND_LINE[:70])
    with opened(tmp_path) as store:
        assert list(store.results["baseline"]) == ["val_3"]
        store.append("baseline", replace(RESULT, episode="val_5"))
    assert recorded(tmp_path) == ["val_3", "val_5"]


def test_a_last_line_without_a_line_feed_is_a_result(tmp_path: Path) -> None:
    begin(tmp_path, LINE, SECOND_LINE.rstrip("\n"))
    with opened(tmp_path) as store:
        assert list(store.results["baseline"]) == ["val_3", "val_4"]
        store.append("baseline", replace(RESULT, episode="val_5"))
    assert recorded(tmp_path) == ["val_3", "val_4", "val_5"]


def test_mending_never_writes_over_what_is_whole(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Killed at any moment of it, the results are there: the file is the same one, only shorter."""
    path = begin(tmp_path, LINE, SECOND_LINE[:70])
    before = path.stat().st_ino
    monkeypatch.setattr(Path, "write_text", None)
    monkeypatch.setattr(Path, "write_bytes", None)
    assert recorded(tmp_path) == ["val_3"]
    assert path.stat().st_ino == before


def test_a_result_that_does_not_fit_on_the_disk_leaves_nothing_behind(tmp_path: Path) -> None:
    pytest.importorskip("resource", reason="needs a limit on the size of files")
    code = (
        "import resource, signal, sys\n"
        "from pathlib import Path\n"
        "from uniteam.evaluation.results.journal import Journal\n"
        "signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
        "journal = Journal(Path(sys.argv[1]))\n"
        "journal.append('{\"first\": 1}\\n')\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (20, 20))\n"
        "journal.append('{\"second\": 2}\\n')\n"
    )
    path = tmp_path / "results.jsonl"
    done = subprocess.run([sys.executable, "-c", code, str(path)], capture_output=True, text=True)
    assert "UnwritableError" in done.stderr
    assert path.read_text() == '{"first": 1}\n'


@pytest.mark.parametrize(
    "line",
    [
        "{\n", "[1, 2]\n", '{"agent": "baseline"}\n', '{"agent": "baseline", "measures": {}}\n', "null\n", "1e999\n",
        "[" * 100_000 + "\n", "9" * 5000 + "\n", "\x1b[31m\n",
        changed(episode=3), changed(episode=""), changed(home=None), changed(unseen=1), changed(seconds=float("nan")),
        changed(seconds=-1.0), changed(seconds=1e300), changed(peak_memory="much"), changed(note="mine"),
        changed(failure="\ud800"), changed(measures=[]), changed(agent=["baseline"]), changed(agent="nobody"),
        changed(measures={**json.loads(LINE)["measures"], "num_steps": 10**30}),
        changed(measures={**json.loads(LINE)["measures"], "num_steps": True}),
        changed(measures={**json.loads(LINE)["measures"], "place_success": 1}),
        changed(measures={**json.loads(LINE)["measures"], "overall_success": True}),
        changed(measures={**json.loads(LINE)["measures"], "num_steps": 312}, episode="val_3"),
        changed(episode="val_9"), LINE.replace('"state":', '"state": "STOPPED", "state":'),
    ],
)  # fmt: skip
def test_a_line_that_is_no_result_of_the_run_is_named_by_its_number(tmp_path: Path, line: str) -> None:
    begin(tmp_path, LINE, line, SECOND_LINE)
    with pytest.raises(DamagedFileError, match=r"line 2 is .*remove that line"):
        recorded(tmp_path)


def test_a_row_that_is_there_twice_counts_once_with_a_word(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    begin(tmp_path, LINE, LINE)
    with caplog.at_level(logging.WARNING):
        assert recorded(tmp_path) == ["val_3"]
    assert "line 2 of" in caplog.text


def test_another_configuration_is_refused_with_what_differs(tmp_path: Path) -> None:
    begin(tmp_path)
    other = {**CONFIGURATION, "agents": {"baseline": {**BASELINE, "threshold": 0.5}}}
    with pytest.raises(InvalidInputError, match=r"agents.baseline.threshold was 0.45 and is now 0.5.*--out"):
        ResultStore(tmp_path, other, EPISODES)
    with pytest.raises(InvalidInputError, match="version was 1 and is now 2"):
        ResultStore(tmp_path, {**CONFIGURATION, "version": "2"}, EPISODES)


def test_another_agent_joins_the_directory_and_the_first_stays(tmp_path: Path) -> None:
    begin(tmp_path, LINE)
    with opened(tmp_path, {**CONFIGURATION, "agents": {"uniteam": {}}}) as store:
        store.append("uniteam", RESULT)
        assert set(store.results) == {"baseline", "uniteam"}
    assert set(json.loads((tmp_path / "config.json").read_text())["agents"]) == {"baseline", "uniteam"}


@pytest.mark.parametrize(
    "content",
    [
        '{"version": "1"',
        "[]",
        "{}",
        "null",
        '{"agents": 3}',
        '{"a":' * 50_000,
        "\xff",
        "9" * 5000,
        '{"agents": {"a": {}, "a": {}}}',
    ],
)
def test_a_damaged_configuration_is_an_error_that_names_the_file(tmp_path: Path, content: str) -> None:
    (tmp_path / "config.json").write_text(content, encoding="latin-1")
    with pytest.raises(DamagedFileError, match=r"config\.json"):
        recorded(tmp_path)


def test_a_configuration_nested_as_deeply_as_json_can_be_read_is_refused_in_words(tmp_path: Path) -> None:
    for depth in (100, 300, 900):
        (tmp_path / "config.json").write_text('{"agents": {"baseline": ' + "[" * depth + "]" * depth + "}}")
        with pytest.raises((DamagedFileError, InvalidInputError), match=r"configuration|config\.json"):
            recorded(tmp_path)


def test_results_without_their_configuration_are_refused(tmp_path: Path) -> None:
    begin(tmp_path, LINE)
    (tmp_path / "config.json").unlink()
    with pytest.raises(DamagedFileError, match=r"config\.json is missing beside results"):
        recorded(tmp_path)


def test_why_an_episode_was_lost_is_kept_and_it_has_no_result(tmp_path: Path) -> None:
    with opened(tmp_path) as store:
        store.record_lost("baseline", "val_3", "its process was killed", "")
    assert recorded(tmp_path) == []
    assert json.loads((tmp_path / "lost.jsonl").read_text())["reason"] == "its process was killed"


def test_a_second_run_into_one_folder_is_refused_while_the_first_goes_on(tmp_path: Path) -> None:
    with opened(tmp_path), pytest.raises(FolderInUseError, match=rf"process {os.getpid()} on .*--out"):
        ResultStore(tmp_path, CONFIGURATION, EPISODES)
    assert recorded(tmp_path) == []


def test_a_killed_run_leaves_its_folder_to_the_next(tmp_path: Path) -> None:
    code = (
        "import sys, time\nfrom pathlib import Path\nfrom uniteam.evaluation.results.lock import FolderLock\n"
        "lock = FolderLock(Path(sys.argv[1]))\nprint('locked', flush=True)\ntime.sleep(600)"
    )
    other = subprocess.Popen([sys.executable, "-c", code, str(tmp_path)], stdout=subprocess.PIPE, text=True)
    assert other.stdout is not None
    assert other.stdout.readline() == "locked\n"
    with pytest.raises(FolderInUseError, match=f"process {other.pid}"):
        FolderLock(tmp_path)
    other.kill()
    other.wait()
    other.stdout.close()
    FolderLock(tmp_path).release()


def test_a_directory_that_cannot_be_is_refused_in_words(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(UnwritableError, match="cannot be written"):
        ResultStore(tmp_path / "file", CONFIGURATION, EPISODES)
