"""Standings, scored anew from the line of each episode."""

from dataclasses import replace
from pathlib import Path

import pytest
from worlds.runs import result, write_run

from uniteam.evaluation.analysis.leaderboard import Standings, standings_of
from uniteam.evaluation.analysis.leaderboard_markdown import published_markdown, standings_markdown
from uniteam.evaluation.analysis.published import PUBLISHED, PublishedRow
from uniteam.evaluation.results.intervals import estimate_proportion
from uniteam.evaluation.results.run_folder import read_run

HOMES = ("test-1", "test-lived_in-1")


def standings(folder: Path, counts: dict[str, int], successes: dict[str, int], *but_homes: str) -> Standings:
    """Return the standings of agents that played the first episodes and succeeded at the first of those."""
    agents = {
        agent: [result(k, k < successes[agent], home=HOMES[k % 2], unseen=k % 4 > 1) for k in range(count)]
        for agent, count in counts.items()
    }
    return standings_of(read_run(write_run(folder, agents)), but_homes)


def test_the_best_stands_first_and_each_part_has_its_episodes(tmp_path: Path) -> None:
    found = standings(tmp_path / "run", {"a": 40, "b": 40, "c": 40}, {"a": 4, "b": 30, "c": 10})
    assert [standing.agent for standing in found.own] == ["b", "c", "a"]
    assert found.shared == []
    best = found.own[0]
    assert best.summary.estimates["overall_success"] == estimate_proportion(30, 40)
    counts = {part: (s.episode_count, s.estimates["overall_success"].mean) for part, s in best.parts.items()}
    assert counts == {"tidy": (20, 0.75), "lived in": (20, 0.75), "seen": (20, 0.8), "unseen": (20, 0.7)}


def test_agents_that_have_played_unlike_many_stand_on_what_all_have_played_too(tmp_path: Path) -> None:
    found = standings(tmp_path / "run", {"a": 40, "b": 12}, {"a": 6, "b": 12})
    assert [standing.summary.episode_count for standing in found.own] == [12, 40]
    assert [(s.agent, s.summary.episode_count) for s in found.shared] == [("b", 12), ("a", 12)]
    assert found.shared[1].summary.estimates["overall_success"] == estimate_proportion(6, 12)
    text = standings_markdown([found])
    assert "On the 12 episodes that all of them have played:" in text
    assert "| `a` | 12 | 100.0 (76–100) | 50.0 (25–75) | 50.0 (25–75) | 50.0 (25–75) |" in text
    assert "| `a` | 15.0 (5–36) of 20 | 15.0 (5–36) of 20 | 20.0 (8–42) of 20 | 10.0 (3–30) of 20 |" in text


def test_homes_can_be_left_out(tmp_path: Path) -> None:
    found = standings(tmp_path / "run", {"a": 40}, {"a": 40}, "test-lived_in-1")
    assert list(found.own[0].parts) == ["tidy", "seen", "unseen"]
    assert "| `a` | 100.0 (84–100) of 20 | none |" in standings_markdown([found])


def test_a_name_cannot_break_a_table(tmp_path: Path) -> None:
    run = read_run(write_run(tmp_path / "run", {"a|b": [replace(result(1, True), home="h")]}))
    assert "| `a\\|b` | 1 |" in standings_markdown([standings_of(run)])


def test_published_rows_are_marked_as_unlike_and_say_where_they_are_from() -> None:
    text = published_markdown()
    assert text.startswith("Published figures, UNLIKE those above")
    assert len(text.splitlines()) == len(PUBLISHED) + 4
    assert "| HomeRobot heuristic | val, ground truth | 54.1 | 48.5 | 31.5 | 5.1 | 34.8 |  | arXiv 2306.11565 |" in text


COMPLETE = [row for row in PUBLISHED if row.find_object is not None and row.partial is not None]


@pytest.mark.parametrize("row", COMPLETE, ids=lambda row: f"{row.system}, {row.setting}")
def test_a_published_partial_success_is_the_mean_of_its_phases(row: PublishedRow) -> None:
    """Where all four were printed: a figure that was copied wrongly would show."""
    phases = [v for v in (row.find_object, row.pick, row.find_receptacle, row.overall) if v is not None]
    assert row.partial == pytest.approx(sum(phases) / 4.0, abs=0.06)
