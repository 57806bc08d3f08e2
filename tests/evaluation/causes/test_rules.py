"""Each rule finds its cause in an episode that is told by hand, and not where the deciding fact is another."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from worlds.stories import grasp, placing, release, story, target, unseen

from uniteam.evaluation.causes.cause import REPORT, Cause
from uniteam.evaluation.causes.decide import RULES, decide
from uniteam.evaluation.causes.story import Standstill, Story, Touch
from uniteam.world.task.measures import Measures

PLACED = Measures(True, True, True, True, 2, 400, True)
LIES: dict[str, Any] = {"rests_on": ("table_1",), "is_over_goal": True}
WALL, LEG = Touch(310, "wall", "PLACE", (2.0, 1.0)), Touch(312, "table_1", "PLACE", (2.0, 1.0))
STILL = Standstill(600, 1249, (1.0, 1.0), 40)
STOPPED = Measures(num_steps=600, does_want_terminate=True)

CASES: dict[str, tuple[Story, Cause, str]] = {
    "a crash": (story(traceback="...\nValueError: no way\n"), Cause.CRASHED, "ValueError: no way"),
    "an object that moved alone": (story(moved_alone="cup_1"), Cause.WORLD, "cup_1 moved before the robot"),
    "a touch of a wall": (replace(placing(measures=PLACED, **LIES), touches=(WALL, LEG)), Cause.AGAINST_WALL, "wall"),
    "a touch": (replace(placing(measures=PLACED, **LIES), touches=(LEG, WALL)), Cause.COLLIDED, "touched table_1"),
    "a phase that was not counted": (
        placing(measures=Measures(False, False, False, False, 0, 400, True), rest_steps=60, **LIES),
        Cause.NOT_COUNTED,
        "an object was never in view from one of its view points",
    ),
    "a receptacle that was not looked at": (
        placing(measures=Measures(True, True, False, False, 0, 400, True), rest_steps=60, **LIES),
        Cause.NOT_COUNTED,
        "the receptacle was never in view",
    ),
    "an object that trembles": (placing(is_over_goal=True, rest_steps=10), Cause.WORLD, "stayed on table_1 for 60"),
    "a contact that is not counted": (placing(rest_steps=60, **LIES), Cause.WORLD, "at a contact that does not count"),
    "a load in the plinth": (
        placing(bottom=0.1, touched="table_1", rest_steps=60, rests_on=("table_1",)),
        Cause.COLLIDED,
        "let go at 0.10 m in table_1, whose lowest surface is 0.75 m high",
    ),
    "a stop when it has just come to rest": (
        placing(rest_steps=40, stay_steps=100, **LIES), Cause.STOPPED_EARLY, "40 of 50 steps",
    ),
    "a thing on the table that holds it": (
        placing(is_over_goal=True, rests_on=("keys_1",)), Cause.ONTO_ANOTHER, "cup_1 lies on keys_1",
    ),
    "a stop too early": (placing(rest_steps=20, stay_steps=20, **LIES), Cause.STOPPED_EARLY, "20 of 50 steps"),
    "a stop while it still rolls": (
        placing(is_over_goal=True, rests_on=None, stay_steps=3), Cause.STOPPED_EARLY, "0 of 50 steps",
    ),
    "a wall between": (placing(is_wall_between=True, to_goal=0.3), Cause.AGAINST_WALL, "a wall is between"),
    "a table that is none": (
        placing(to_goal=2.5, believed="floor or wall"), Cause.WRONG_RECEPTACLE, "floor or wall was taken for a table",
    ),
    "a cabinet beside the table": (
        placing(to_goal=0.4, believed="cabinet_1", rests_on=("cabinet_1",)),
        Cause.WRONG_RECEPTACLE,
        "let go 0.4 m from the nearest goal, table_1; cabinet_1 was taken for a table",
    ),
    "another thing": (placing(rests_on=("box_1",)), Cause.ONTO_ANOTHER, "cup_1 lies on box_1"),
    "too high": (
        placing(bottom=0.9, highest=1.0, goal_lowest=1.3, goal_highest=1.3), Cause.TOO_HIGH, "can hang at 1.00 m",
    ),
    "a load that met the table": (placing(bottom=0.6, touched="table_1"), Cause.COLLIDED, "and let go at 0.60"),
    "a load between two boards": (
        placing(bottom=0.9, touched="table_1", goal_highest=1.6), Cause.COLLIDED, "and let go at 0.90",
    ),
    "a fall through": (placing(has_fallen_through=True), Cause.WORLD, "let go of over table_1 at 0.90 m, and fell thr"),
    "too small": (placing(side=1.3), Cause.TOO_SMALL, "1.30 m long, and table_1 1.20 m"),
    "a cluttered table": (placing(above="bowl_2"), Cause.CLUTTERED, "above bowl_2"),
    "a fall off the edge": (placing(), Cause.FELL_OFF, "let go over table_1"),
    "too large": (placing(to_goal=0.2, arm=0.515), Cause.TOO_LARGE, "the arm was out 0.52 m"),
    "beside": (placing(to_goal=0.2), Cause.BESIDE, "let go 0.20 m beside table_1"),
    "another object taken": (story(grasps=(grasp(took="mug_1"),)), Cause.WRONG_OBJECT, "took mug_1"),
    "another object grasped at": (
        story(grasps=(grasp(believed="mug_1", is_in_view=False, distance=4.0),), objects=(unseen(),)),
        Cause.WRONG_OBJECT,
        "grasped at mug_1, taken for a cup",
    ),
    "another object, for want of a way to the known one": (
        story(grasps=(grasp(believed="mug_1", is_in_view=False),), way=0.7), Cause.NARROW_PASSAGE, "0.70 m wide",
    ),
    "another object, for want of a way out": (
        story(grasps=(grasp(believed="mug_1", is_in_view=False),), objects=(unseen(),), way=0.7, standstill=STILL),
        Cause.NARROW_PASSAGE,
        "0.70 m wide",
    ),
    "another place, for want of a way to the known table": (
        replace(placing(is_wall_between=True, to_goal=0.3), way=0.7), Cause.NARROW_PASSAGE, "to the table is 0.70 m",
    ),
    "another object grasped at, and once the right one from afar": (
        story(grasps=(grasp(distance=1.5), *(grasp(believed="book_1", is_in_view=False, distance=2.0),) * 2)),
        Cause.WRONG_OBJECT,
        "grasped at book_1",
    ),
    "out of reach": (
        story(grasps=(grasp(distance=1.5), grasp(distance=0.95))), Cause.OUT_OF_REACH, "cup_1 was 0.95 m",
    ),
    "out of view": (story(grasps=(grasp(is_in_view=False),)), Cause.OUT_OF_VIEW, "not in the picture; 1 such"),
    "an object not recognised": (
        story(objects=(target(recognised_at=None, taken_for="vase"),)), Cause.NOT_RECOGNISED, "taken for vase",
    ),
    "a receptacle not recognised": (
        story(taken_at=200, held="cup_1", receptacles=(target("table_1", recognised_at=None),)),
        Cause.NOT_RECOGNISED,
        "table_1 was in view for 20 steps",
    ),
    "a narrow passage, stuck": (
        story(objects=(unseen(),), way=0.7, standstill=STILL), Cause.NARROW_PASSAGE, "to the cup is 0.70 m wide",
    ),
    "a narrow passage, given up": (story(way=0.7, measures=STOPPED), Cause.NARROW_PASSAGE, "0.70"),
    "stuck": (story(standstill=STILL), Cause.STUCK, "within a metre for 650 steps"),
    "given up": (story(measures=STOPPED), Cause.GAVE_UP, "stopped after 600 steps in NAVIGATE_TO_OBJECT"),
    "never seen": (story(objects=(unseen(),), way=0.7), Cause.NEVER_SEEN, "more than 3 pixels"),
    "no receptacle found": (
        story(taken_at=200, held="cup_1"), Cause.RECEPTACLE_NEVER_FOUND, "no table was in view",
    ),
    "found and not reached": (story(), Cause.NOT_REACHED, "came no nearer than 3.0 m"),
    "time": (story(objects=(target(nearest=0.5),)), Cause.TIME_RAN_OUT, "ended in NAVIGATE_TO_OBJECT: I drive there."),
}  # fmt: skip


@pytest.mark.parametrize(("told", "cause", "words"), CASES.values(), ids=CASES)
def test_a_told_episode_has_its_cause(told: Story, cause: Cause, words: str) -> None:
    finding = decide(told)
    assert finding.cause is cause
    assert words in finding.words


def test_every_rule_decides_an_episode_and_every_cause_but_that_without_a_recording_is_found() -> None:
    deciding = {next(rule for rule in RULES if rule(told) is not None) for told, _, _ in CASES.values()}
    assert deciding == set(RULES)
    assert {cause for _, cause, _ in CASES.values()} == set(Cause) - {Cause.NOT_RECORDED}


@pytest.mark.parametrize(
    ("told", "not_this"),
    [
        (placing(to_goal=0.2, above="bowl_2"), Cause.CLUTTERED),
        (placing(bottom=0.8, touched="table_1"), Cause.COLLIDED),
        (placing(bottom=0.6, highest=0.8), Cause.TOO_HIGH),
        (placing(stay_steps=40, rest_steps=10, is_over_goal=True, rests_on=("table_1",)), Cause.WORLD),
        (placing(to_goal=0.5), Cause.WRONG_RECEPTACLE),
        (story(grasps=(grasp(believed="mug_1"),)), Cause.WRONG_OBJECT),
        (story(grasps=(grasp(took="cup_1", distance=1.5),), taken_at=200, held="cup_1"), Cause.WRONG_OBJECT),
        (story(grasps=(grasp(distance=0.5),)), Cause.OUT_OF_REACH),
        (story(objects=(target(recognised_at=None), target("cup_2"))), Cause.NOT_RECOGNISED),
        (story(objects=(target(recognised_at=None),), has_said=False), Cause.NOT_RECOGNISED),
        (story(objects=(target(nearest=0.6),), way=0.7, measures=STOPPED), Cause.NARROW_PASSAGE),
        (story(way=0.9, measures=STOPPED), Cause.NARROW_PASSAGE),
        (story(objects=(unseen(),), way=0.7, measures=STOPPED), Cause.NARROW_PASSAGE),
        (story(standstill=replace(STILL, last=800)), Cause.STUCK),
        (
            story(
                grasps=(grasp(is_in_view=False),), objects=(unseen(),), way=0.7, standstill=replace(STILL, blocked=3)
            ),
            Cause.NARROW_PASSAGE,
        ),
        (story(grasps=(grasp(took="mug_1"),), way=0.7), Cause.NARROW_PASSAGE),
        (story(grasps=(grasp(believed="book_1", is_of_class=False, is_in_view=False),), way=0.7), Cause.NARROW_PASSAGE),
        (replace(placing(to_goal=2.5, believed="shelf_2"), way=0.7), Cause.NARROW_PASSAGE),
        (placing(rest_steps=60, bottom=0.9, touched="table_1", **LIES), Cause.COLLIDED),
        (replace(story(taken_at=200), release=release()), Cause.RECEPTACLE_NEVER_FOUND),
    ],
)
def test_a_cause_is_not_found_where_its_deciding_fact_is_another(told: Story, not_this: Cause) -> None:
    assert decide(told).cause is not not_this


def test_the_page_of_failures_has_every_cause_with_its_sentence_of_the_report() -> None:
    page = (Path(__file__).parents[3] / "docs" / "failures.md").read_text()
    table = page.partition("| cause |")[2].partition("\n\n")[0].splitlines()[2:]
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in table]
    assert {cause for cause, _, _ in rows} == {cause.value for cause in Cause}
    assert {cause: sentence for cause, _, sentence in rows if sentence} == {
        cause.value: sentence for cause, sentence in REPORT.items()
    }


def test_finding_says_where_and_when() -> None:
    finding = decide(placing())
    assert (finding.step, finding.place) == (300, (2.0, 2.0))
    stuck = decide(story(standstill=STILL))
    assert (stuck.step, stuck.place) == (600, (1.0, 1.0))


def test_the_reports_own_failures_are_all_among_the_causes() -> None:
    assert set(REPORT.values()) == {
        "a receptacle too large",
        "placing through a wall",
        "stuck in or giving up on narrow passages",
        "overlooking the object",
        "timeout while searching",
        "wrong recognition is behind most",
    }
