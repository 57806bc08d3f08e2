"""The report of runs: its figures are the terminal's, and a browser shows and filters them."""

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from worlds.browser import PHONE, WIDE, chromium, nameless, opened
from worlds.filled import filled
from worlds.runs import result, write_run

from uniteam.errors import DamagedFileError
from uniteam.evaluation.analysis.contestants import Contestant, contestants_named
from uniteam.evaluation.results.intervals import estimate_proportion
from uniteam.evaluation.results.summary import summarize
from uniteam.visualization.report_page.page import report_page

RESULTS = Path(__file__).parents[2] / "results" / "val-truth-half-challenge"


def no_replays(contestant: Contestant, episode: str) -> str | None:
    return None


def data_of(page: str) -> dict[str, Any]:
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.DOTALL)
    assert found is not None
    data: dict[str, Any] = json.loads(found[1])
    return data


def two_agents(folder: Path) -> Path:
    """Write a run in which `able` succeeds at three of four episodes and `poor` at one of two."""
    able = [result(k, k != 2, steps=100 + k, unseen=k == 3) for k in range(4)]
    return write_run(folder / "run", {"able": able, "poor": [result(0, True), result(1, False)]})


def test_the_tables_figures_are_those_of_the_terminal(tmp_path: Path) -> None:
    contestants = contestants_named([str(two_agents(tmp_path))])
    data = data_of(report_page(contestants, no_replays))
    for row, contestant in filled(zip(data["agents"], contestants, strict=True)):
        estimate = summarize(list(contestant.results.values())).estimates["overall_success"]
        shown = [100.0 * value for value in (estimate.mean, estimate.low, estimate.high)]
        assert row["cells"]["Overall"] == pytest.approx(shown, abs=1e-3)
        assert row["episodes"] == len(contestant.results)
    assert [row["episodes"] for row in data["shared"]] == [2, 2]
    assert [row["cells"]["Overall"][0] for row in data["shared"]] == [100.0, 50.0]
    assert data["unlike"] == []


def test_success_is_broken_down_by_what_makes_episodes_differ() -> None:
    data = data_of(report_page(contestants_named([str(RESULTS)]), no_replays))
    tags = {tag["title"]: tag["groups"] for tag in data["tags"]}
    assert {"Style of the home", "Shortest path (m)", "Least clearance on it (m)"} < set(tags)
    assert [group["heading"] for group in tags["Seen and unseen"]] == ["seen categories", "unseen categories"]
    for groups in filled(tags.values()):
        for number, agent in filled(enumerate(data["agents"])):
            counted = [group["agents"][number] for group in groups if group["agents"][number]]
            assert sum(part["count"] for part in counted) == agent["episodes"]
            mean = sum(part["count"] * part["success"][0] for part in counted) / agent["episodes"]
            assert mean == pytest.approx(agent["cells"]["Overall"][0], abs=1e-2)


def test_runs_that_are_unlike_are_said_to_be(tmp_path: Path) -> None:
    runs = [
        write_run(tmp_path / "a", {"able": [result(0, True)]}),
        write_run(tmp_path / "b", {"poor": [result(0, False)]}, camera="full"),
    ]
    data = data_of(report_page(contestants_named(map(str, runs)), no_replays))
    assert len(data["unlike"]) == 1
    assert data["unlike"][0].startswith("camera: half in")


def test_causes_stand_beside_their_episodes_where_the_run_has_them(tmp_path: Path) -> None:
    run = two_agents(tmp_path)
    told = {"episode": "e002", "cause": "never seen", "step": 12, "words": "It lay behind a door.", "phase": "find"}
    (run / "causes.json").write_text(json.dumps([{"agent": "able", "failures": [told], "episodes": 4}]))
    attempts = data_of(report_page(contestants_named([str(run)]), no_replays))["attempts"]
    causes = {(a["episode"], a["agent"]): a["cause"] for a in attempts}
    assert causes["e002", 0] == {"cause": "never seen", "step": 12, "words": "It lay behind a door."}
    assert causes["e001", 1] is None
    (run / "causes.json").write_text("[{}]")
    with pytest.raises(DamagedFileError, match="remove the file or write it anew"):
        report_page(contestants_named([str(run)]), no_replays)


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    with chromium() as found:
        yield found


@pytest.mark.slow
@pytest.mark.parametrize("viewport", [WIDE, PHONE], ids=["wide", "phone"])
def test_a_browser_shows_the_report_without_a_network(browser: Any, tmp_path: Path, viewport: dict[str, int]) -> None:
    page = tmp_path / "report.html"
    page.write_text(report_page(contestants_named([str(RESULTS)]), no_replays))
    with opened(browser, page, viewport, theme="dark") as tab:
        assert tab.seconds < 2.0
        assert tab.page.evaluate("document.documentElement.scrollWidth") <= viewport["width"]
        assert nameless(tab.page) == []
        assert tab.page.locator("#attempts tbody tr").count() == 200
        tab.page.click("#more")
        assert tab.page.locator("#attempts tbody tr").count() > 200


@pytest.mark.slow
def test_filters_choose_episodes_and_score_what_is_chosen(browser: Any, tmp_path: Path) -> None:
    run, page = two_agents(tmp_path), tmp_path / "report.html"
    (run / "causes.json").write_text(
        json.dumps([{"agent": "able", "failures": [{"episode": "e002", "cause": "never seen", "step": 12}]}])
    )
    page.write_text(report_page(contestants_named([str(run)]), lambda c, e: "replays/e.html" if e == "e002" else None))
    rows = "#attempts tbody tr"
    with opened(browser, page) as tab:
        assert tab.page.locator(rows).count() == 6
        tab.page.select_option("[name=agent]", "able")
        assert tab.page.locator(rows).count() == 4
        wilson = estimate_proportion(3, 4)
        expected = f"able 75.0 % ({100 * wilson.low:.0f}–{100 * wilson.high:.0f}) of 4"
        assert tab.page.inner_text("#shown").endswith(expected)
        tab.page.select_option("[name=outcome]", "failed")
        assert tab.page.locator(rows).count() == 1
        assert "never seen" in tab.page.inner_text(rows)
        assert tab.page.get_attribute(f"{rows} a", "href") == "replays/e.html#step=12"
        tab.page.fill("[name=words]", "no such words")
        assert tab.page.locator(rows).count() == 0
        assert tab.page.inner_text("#shown") == "No episode is so."
