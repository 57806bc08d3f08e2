"""Shards that make one run, and those that do not belong together."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
from worlds.runs import CONFIGURATION, result, write_run

from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.evaluation.results.merge import merge_shards
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.evaluation.results.run_folder import read_run
from uniteam.evaluation.results.summary import summarize_run

RESULTS = [result(k, k % 3 == 0, home=f"h{k // 2}", steps=200 + k) for k in range(10)]
OTHERS = [result(k, k % 2 == 0, home=f"h{k // 2}", steps=300 + k) for k in range(10)]


def told(number: int, episodes: Sequence[EpisodeResult], count: int = 2) -> dict[str, Any]:
    return {"number": number, "count": count, "asked": 10, "episodes": [each.episode for each in episodes]}


def shards(folder: Path, **second: Any) -> list[Path]:
    """Write two shards of a run of ten episodes, the second with what differs, and return their folders."""
    halves = [write_run(folder / "one", {"b": RESULTS[:5], "a": OTHERS[:5]}, shard=told(1, RESULTS[:5]))]
    agents = second.pop("agents", {"b": RESULTS[5:], "a": OTHERS[5:]})
    return [*halves, write_run(folder / "two", agents, **{"shard": told(2, RESULTS[5:]), **second})]


def test_shards_make_the_run_that_would_have_been_played_without_them(tmp_path: Path) -> None:
    merged = merge_shards(shards(tmp_path)[::-1], tmp_path / "out")
    assert (merged.attempts, merged.missing) == (20, ())
    run = read_run(tmp_path / "out")
    assert {agent: list(own.values()) for agent, own in run.results.items()} == {"b": RESULTS, "a": OTHERS}
    assert run.configuration == {**CONFIGURATION, "agents": {"b": {"agent": "b"}, "a": {"agent": "a"}}}
    summary = summarize_run(run.configuration, {"b": RESULTS[::-1], "a": OTHERS}, 10)
    assert (tmp_path / "out" / "summary.json").read_text() == json.dumps(summary, indent=2) + "\n"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["one", "out", "two"]


def test_what_was_lost_stays_told(tmp_path: Path) -> None:
    folders = shards(tmp_path)
    (folders[1] / "lost.jsonl").write_text('{"agent": "a", "episode": "e007"}\n')
    merge_shards(folders, tmp_path / "out")
    assert (tmp_path / "out" / "lost.jsonl").read_text() == '{"agent": "a", "episode": "e007"}\n'


def test_what_is_missing_is_said_and_the_rest_is_there(tmp_path: Path) -> None:
    folders = shards(tmp_path, agents={"b": RESULTS[5:8], "a": OTHERS[5:]})
    merged = merge_shards(folders, tmp_path / "out")
    assert merged.missing == ("2 of b's episodes in shard 2 of 2 (e008, e009)",)
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert (summary["b"]["episode_count"], summary["b"]["episodes_asked"]) == (8, 10)
    assert merge_shards(folders[:1], tmp_path / "half").missing == ("shard 2 of 2",)


@pytest.mark.parametrize(
    ("second", "sentence"),
    [
        ({"code": "0ther"}, "shards of different runs .*code was c0de and is now 0ther"),
        ({"agents": {"b": RESULTS[5:]}}, "shards of different runs .*agents.a was"),
        ({"shard": told(2, RESULTS[5:], count=3)}, "shards was 2 and is now 3"),
        ({"shard": {**told(2, RESULTS[5:]), "asked": 12}}, "episodes was 10 and is now 12"),
        ({"shard": told(1, RESULTS[4:])}, "episode 'e004' is in '.*one' and in '.*two'; give each shard once"),
    ],
)
def test_shards_that_do_not_belong_together_are_refused(tmp_path: Path, second: dict[str, Any], sentence: str) -> None:
    with pytest.raises(InvalidInputError, match=sentence):
        merge_shards(shards(tmp_path, **second), tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_run_that_is_whole_and_one_that_does_not_say_what_it_is_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InvalidInputError, match="is no shard"):
        merge_shards([write_run(tmp_path / "whole", {"b": RESULTS})], tmp_path / "out")
    with pytest.raises(DamagedFileError, match="does not say which shard"):
        merge_shards([write_run(tmp_path / "odd", {"b": RESULTS}, shard={"number": "1"})], tmp_path / "out")


def test_a_result_that_the_shard_has_not_is_refused(tmp_path: Path) -> None:
    folders = shards(tmp_path, agents={"b": RESULTS[4:], "a": OTHERS[5:]})
    with pytest.raises(DamagedFileError, match="b's 'e004', which its shard has not"):
        merge_shards(folders, tmp_path / "out")


def test_a_folder_that_holds_something_is_left_as_it_is(tmp_path: Path) -> None:
    (tmp_path / "out").mkdir()
    merge_shards(shards(tmp_path / "first"), tmp_path / "out")
    before = {path: path.read_bytes() for path in (tmp_path / "out").iterdir()}
    with pytest.raises(InvalidInputError, match="holds something already"):
        merge_shards(shards(tmp_path / "again"), tmp_path / "out")
    assert {path: path.read_bytes() for path in (tmp_path / "out").iterdir()} == before
