"""The figures of the table and their intervals."""

from io import StringIO

import pytest
from rich.console import Console
from rich.markup import escape

from uniteam.evaluation.analysis.table import Row, challenge_table
from uniteam.evaluation.results.failure_cause import explain_failure
from uniteam.evaluation.results.intervals import estimate_mean, estimate_proportion, student_quantile
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.evaluation.results.summary import summarize
from uniteam.world.task.measures import Measures


def result(measures: Measures, traceback: str = "") -> EpisodeResult:
    return EpisodeResult("e", "h", "Move cup from table to sink", False, measures, "DONE", "", 1.0, 1.0, traceback)


@pytest.mark.parametrize(
    ("successes", "trials", "low", "high"),
    [(0, 10, 0.0, 0.2775), (5, 10, 0.2366, 0.7634), (10, 10, 0.7225, 1.0), (81, 263, 0.2553, 0.3662)],
)
def test_wilsons_interval_is_the_published_one(successes: int, trials: int, low: float, high: float) -> None:
    """The last row is the example of Newcombe (1998), Statistics in Medicine 17, table I."""
    estimate = estimate_proportion(successes, trials)
    assert estimate.mean == successes / trials
    assert (estimate.low, estimate.high) == pytest.approx((low, high), abs=1e-4)


@pytest.mark.parametrize(("degrees", "quantile"), [(1, 12.706), (2, 4.303), (3, 3.182), (9, 2.262), (399, 1.966)])
def test_students_quantile_agrees_with_the_printed_tables(degrees: int, quantile: float) -> None:
    assert student_quantile(degrees) == pytest.approx(quantile, rel=0.008)


def test_a_means_interval_does_not_leave_what_is_possible() -> None:
    estimate = estimate_mean([0.0, 0.0, 1.0], (0.0, 1.0))
    assert estimate.mean == pytest.approx(1.0 / 3.0)
    assert (estimate.low, estimate.high) == (0.0, 1.0)


def test_one_value_says_nothing_of_the_spread() -> None:
    assert (estimate_mean([300.0], (0.0, 1250.0)).low, estimate_mean([300.0], (0.0, 1250.0)).high) == (0.0, 1250.0)


def test_a_summary_counts_a_crash_as_a_failure() -> None:
    success = result(Measures(True, True, True, True, 0, 200, True))
    touched = result(Measures(True, True, True, True, 3, 400, True))
    crashed = result(Measures(num_steps=30), traceback="ValueError")
    data = summarize([success, touched, crashed]).to_data()
    assert data["episode_count"] == 3
    assert data["crash_count"] == 1
    assert data["overall_success"]["mean"] == pytest.approx(1 / 3)
    assert data["place_success"]["mean"] == pytest.approx(2 / 3)
    assert data["partial_success"]["mean"] == pytest.approx((1.0 + 0.75 + 0.0) / 3)
    assert data["num_steps"]["mean"] == pytest.approx(210)
    assert data["num_steps"]["low"] < 210 < data["num_steps"]["high"]


def test_the_table_has_the_challenges_columns_and_says_what_it_is_from() -> None:
    rows = {"uniteam": Row(summarize([result(Measures(True, num_steps=9))]), 1)}
    table = challenge_table(rows, "split val, truth", 100, str)
    headings = [str(column.header) for column in table.columns]
    assert headings == ["agent", "FindObj", "Pick", "FindRec", "Overall", "Partial", "Steps", "episodes"]
    assert str(table.caption) == "split val, truth"
    assert "100.0" in str(list(table.columns[1].cells))
    assert "25.0" in str(list(table.columns[5].cells))


def printed(label: str, asked: int, width: int) -> str:
    """Return the table of one agent as a terminal of a width shows it."""
    rows = {label: Row(summarize([result(Measures(True, num_steps=9))] * 3), asked)}
    console = Console(width=width, file=StringIO(), emoji=False)
    console.print(challenge_table(rows, "split val", width, escape))
    return console.file.getvalue()  # type: ignore[attr-defined]


def test_a_row_that_is_from_fewer_episodes_than_asked_for_says_so() -> None:
    assert "3 of 4" in printed("uniteam", 4, 100)
    assert "of" not in printed("uniteam", 3, 100).replace("of val", "")


@pytest.mark.parametrize("width", [40, 60, 73, 80, 120])
def test_every_terminal_from_40_columns_shows_the_agents_name_and_every_figure(width: int) -> None:
    shown = printed("baseline", 3, width)
    assert max(len(line) for line in shown.splitlines()) <= width
    for word in ("baseline", "FindObj", "100.0", "Overall", "Partial", "25.0", "Steps", "9.0", "episodes"):
        assert word in shown


@pytest.mark.parametrize("label", ["uniteam-plus", "my_long_module.of_agents:ExplorerOfHomes"])
@pytest.mark.parametrize("width", [40, 60, 73, 80, 90, 100, 110, 120])
def test_no_width_of_a_terminal_breaks_a_word_of_an_agents_name_that_it_has_room_for(width: int, label: str) -> None:
    assert (label in printed(label, 3, width)) is (width >= 60 or len(label) < 20)


@pytest.mark.parametrize(("width", "is_shown"), [(60, True), (80, False), (120, True)])
def test_the_three_kinds_of_collisions_are_shown_where_there_is_room(width: int, is_shown: bool) -> None:
    shown = printed("baseline", 3, width)
    for heading in ("Arm", "Held", "Objects"):
        assert (heading in shown) is is_shown


def test_collisions_of_the_held_object_and_with_small_objects_cost_no_success() -> None:
    brushed = Measures(True, True, True, True, 0, 200, True, obj_scene_colls=4, robot_obj_colls=2)
    data = summarize([result(brushed)]).to_data()
    assert data["overall_success"]["mean"] == 1.0
    assert (data["obj_scene_colls"]["mean"], data["robot_obj_colls"]["mean"]) == (4.0, 2.0)


def test_a_label_is_shown_as_it_is_told_to_be() -> None:
    assert "uniteam[/b]" in printed("uniteam[/b]", 3, 100)


def test_a_failure_is_explained_by_the_first_thing_missed() -> None:
    stuck = Measures(find_object_phase_success=True, num_steps=1250)
    sentence = explain_failure(stuck, "PICK", "The object is out of reach.")
    assert sentence == (
        "found the object but never grasped a candidate; ran out of steps after 1250 steps in PICK "
        "(The object is out of reach)"
    )
    assert explain_failure(Measures(True, True, True, True, 0, 99, True), "DONE", "Done.") == ""
    assert "touched the scene in 2 steps" in explain_failure(Measures(True, True, True, True, 2, 99, True), "DONE", "")
