"""`uniteam leaderboard`, and whether this project's own pages show what its results come to."""

from pathlib import Path

import pytest
from worlds.called import call
from worlds.runs import result, write_run

from uniteam.evaluation.analysis.leaderboard import standings_of
from uniteam.evaluation.results.run_folder import read_run

ROOT = Path(__file__).parents[2]
WATCHED = [f"test-{seed}" for seed in range(2000, 2006)] + [f"test-lived_in-{seed}" for seed in range(2000, 2003)]


@pytest.fixture
def run(tmp_path: Path) -> Path:
    return write_run(tmp_path / "results" / "run", {"uniteam": [result(k, k < 10) for k in range(20)]})


@pytest.fixture
def page(tmp_path: Path) -> Path:
    path = tmp_path / "page.md"
    path.write_text("# Mine\n\n<!-- leaderboard -->\n\nold\n\n<!-- end -->\n\nMore.\n")
    return path


@pytest.mark.parametrize("name", ["README.md", "docs/leaderboard.md"])
def test_the_projects_pages_show_what_its_results_come_to(
    name: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(ROOT)
    assert call("leaderboard", "--check", name) == 0, capsys.readouterr().err


def test_the_figure_of_the_homes_that_were_not_watched_is_what_the_results_come_to() -> None:
    run = read_run(ROOT / "results" / "val-truth-half-challenge")
    summary = next(s for s in standings_of(run, WATCHED).own if s.agent == "uniteam-plus").summary
    estimate = summary.estimates["overall_success"]
    mean, low, high = (100.0 * value for value in (estimate.mean, estimate.low, estimate.high))
    text = " ".join((ROOT / "README.md").read_text().split())
    assert f"On the {summary.episode_count} episodes of the other homes" in text
    assert f"its overall success is {mean:.1f} ({low:.0f}–{high:.0f})" in text


def test_the_runs_in_results_are_printed_beside_published_figures_that_are_unlike(
    run: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(run.parents[1])
    assert call("leaderboard") == 0
    told = " ".join(capsys.readouterr().out.split())
    assert "Split val version 2, perception truth" in told and "50.0" in told
    assert "UNLIKE those above" in told and "HomeRobot heuristic" in told


def test_a_page_is_checked_and_written_and_all_else_in_it_stays(
    run: Path, page: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert call("leaderboard", str(run), "--check", str(page)) == 2
    assert f"'uniteam leaderboard --write {page}' writes it anew" in " ".join(capsys.readouterr().err.split())
    assert call("leaderboard", str(run), "--write", str(page)) == 0
    text = page.read_text()
    assert text.startswith("# Mine\n\n<!-- leaderboard -->\n\nSplit `val`") and text.endswith("<!-- end -->\n\nMore.\n")
    assert call("leaderboard", str(run), "--check", str(page)) == 0
    with (run / "results.jsonl").open() as file:
        lines = file.readlines()
    (run / "results.jsonl").write_text("".join(lines[:-1]))
    assert call("leaderboard", str(run), "--check", str(page)) == 2


def test_a_figure_that_contradicts_its_episode_is_found(run: Path, capsys: pytest.CaptureFixture[str]) -> None:
    lines = (run / "results.jsonl").read_text().replace('"overall_success": false', '"overall_success": true', 1)
    (run / "results.jsonl").write_text(lines)
    assert call("leaderboard", str(run)) == 2
    assert "its measures contradict each other" in capsys.readouterr().err


def test_what_cannot_be_is_answered_in_a_sentence(
    run: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "plain.md").write_text("# No marks\n")
    assert call("leaderboard", str(run), "--write", str(tmp_path / "plain.md")) == 2
    assert "has no marks '<!-- leaderboard -->'" in capsys.readouterr().err
    assert call("leaderboard", str(run), "--check", str(tmp_path / "none.md")) == 2
    assert "cannot be read" in capsys.readouterr().err
    assert call("leaderboard", str(run), "--but-homes", "home-33") == 2
    assert "unknown home in these results 'home-33'" in capsys.readouterr().err
    monkeypatch.chdir(run)
    assert call("leaderboard") == 2
    assert "there are no folders of runs in 'results' here" in capsys.readouterr().err
