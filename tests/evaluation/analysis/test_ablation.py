"""What an ablation plays, and what it says of agents whose truth is known."""

import numpy as np
import pytest
from worlds.filled import filled
from worlds.runs import result

from uniteam.errors import InvalidInputError
from uniteam.evaluation.analysis.ablation import measure_effects
from uniteam.evaluation.analysis.ablation_plan import GROUPS, Effect, plan_ablation
from uniteam.evaluation.analysis.ablation_table import ablation_markdown, enough_words
from uniteam.evaluation.analysis.page_block import block_of, with_block
from uniteam.evaluation.results.intervals import Estimate
from uniteam.evaluation.statistics.significance import mcnemar
from uniteam.mind.agents.beyond import BEYOND
from uniteam.mind.agents.improvements import improved
from uniteam.mind.agents.registry import agent_config
from uniteam.mind.agents.report import REPORT
from uniteam.visualization.colors import SUCCESS
from uniteam.visualization.effect_chart import Block, Column, column_area, draw_effect_chart

PLAN = plan_ablation("truth", GROUPS)


def test_every_improvement_is_asked_for_in_every_way() -> None:
    asked = {group: [e.improvement for e in PLAN.effects if e.group == group] for group in GROUPS}
    for group in ("alone", "removed", "ladder"):
        assert asked[group] == [improvement.name for improvement in REPORT]
    for group in ("beyond-added", "beyond-removed"):
        assert asked[group] == [improvement.name for improvement in BEYOND]
    assert len(asked["whole"]) == 2


@pytest.mark.parametrize(
    "effect", [pytest.param(e, id=f"{e.group}-{e.improvement}") for e in PLAN.effects if e.group != "whole"]
)
def test_the_two_agents_of_an_effect_differ_in_its_improvement_alone(effect: Effect) -> None:
    without, with_ = (PLAN.agents[label] for label in (effect.without, effect.with_))
    configs = [agent_config(spec.name, spec.added, spec.removed) for spec in (without, with_)]
    assert configs[0] is not None and configs[0] != configs[1]
    assert improved(configs[0], [effect.improvement]) == configs[1]


def test_the_ladder_leads_from_the_baseline_to_uniteam_step_by_step() -> None:
    rungs = [effect for effect in PLAN.effects if effect.group == "ladder"]
    assert (rungs[0].without, rungs[-1].with_) == ("baseline", "uniteam")
    assert [rung.with_ for rung in rungs[:-1]] == [rung.without for rung in rungs[1:]]


def test_no_configuration_is_played_twice() -> None:
    configs = [agent_config(s.name, s.added, s.removed) for s in PLAN.agents.values()]
    assert all(config not in configs[:k] for k, config in enumerate(filled(configs)))
    assert {spec.perception for spec in PLAN.agents.values()} == {"truth"}


def test_a_question_brings_the_agents_that_it_needs_and_no_others() -> None:
    agents = plan_ablation("learned", ["removed"]).agents
    assert set(agents) == {"uniteam", *(f"uniteam without {improvement.name}" for improvement in REPORT)}
    assert {spec.perception for spec in agents.values()} == {"learned"}


def test_effects_are_measured_on_the_episodes_that_both_have_played() -> None:
    effects = [e for e in PLAN.effects if e.group == "alone"][:3]
    results = {"baseline": {f"e{k:03d}": result(k, k < 5) for k in range(40)}}
    results[effects[0].with_] = {f"e{k:03d}": result(k, k < 17) for k in range(30)}
    results[effects[1].with_] = {f"e{k:03d}": result(k, k < 6) for k in range(40)}
    counted: list[int] = []
    first, second = measure_effects(effects, results, lambda: counted.append(1))["alone"]
    assert len(counted) == 3
    assert (first.comparison.episodes, second.comparison.episodes) == (30, 40)
    measure = first.comparison.measures["overall_success"]
    assert measure.difference.mean == pytest.approx(12 / 30)
    assert measure.p_corrected == pytest.approx(2.0 * mcnemar(0, 12))
    assert measure.is_shown and not second.comparison.measures["overall_success"].is_shown
    low, high = (f"{100.0 * bound:+.0f}" for bound in (measure.difference.low, measure.difference.high))
    row = f"| {effects[0].improvement} | 30 | 16.7 | 56.7 | +40.0* ({low} to {high}) | 0, 12 | <.001 | "
    text = ablation_markdown({"alone": [first, second]})
    assert row in text and text.count("enough to show a worth of 5 points for none of the 2.") == 2


def test_it_is_said_for_how_many_improvements_there_are_episodes_enough() -> None:
    effect = next(e for e in PLAN.effects if e.group == "alone")
    results = {"baseline": {f"e{k:03d}": result(k, False) for k in range(200)}}
    results[effect.with_] = {f"e{k:03d}": result(k, k == 7) for k in range(200)}
    measured = measure_effects([effect], results, lambda: None)["alone"]
    assert (measured[0].comparison.measures["overall_success"].smallest or 1.0) < 0.05
    assert enough_words(measured, "overall_success").endswith("for all.")


def test_a_block_of_a_page_is_replaced_and_all_else_stays() -> None:
    page = "# Title\n\nMine.\n\n<!-- a -->\n\nold\n\n<!-- end -->\n\nMine too.\n\n<!-- b -->\nother\n<!-- end -->\n"
    once = with_block(page, "a", "new, with \\1 in it")
    assert once == page.replace("\n\nold\n\n", "\n\nnew, with \\1 in it\n\n")
    assert with_block(once, "a", "new, with \\1 in it") == once
    assert (block_of(once, "a"), block_of(once, "b"), block_of(once, "c")) == ("new, with \\1 in it", "other", None)
    assert with_block("", "c", "x") == "<!-- c -->\n\nx\n\n<!-- end -->\n"


@pytest.mark.parametrize(
    "page", ["<!-- a -->\nx", "<!-- a -->\n<!-- b -->\n<!-- end -->", "<!-- a --><!-- end -->" * 2]
)
def test_a_page_whose_marks_are_not_in_order_is_refused(page: str) -> None:
    with pytest.raises(InvalidInputError, match="must have '<!-- a -->' once"):
        with_block(page, "a", "new")


def test_the_chart_draws_an_effect_and_its_interval_where_they_belong() -> None:
    column = Column("alone", {"edge_margin": Estimate(10.0, 5.0, 20.0)}, frozenset({"edge_margin"}))
    picture = draw_effect_chart("worth", [Block(("drop_height", "edge_margin"), [column])], "of twenty")
    area = column_area(0, 1, 60, 2)
    drawn = np.argwhere((picture[area.top : area.top + area.height] == np.array(SUCCESS)).all(-1))
    assert drawn[:, 0].min() > 22  # in the second row
    ends = [(x - area.left) / area.width * 40.0 - 20.0 for x in (drawn[:, 1].min(), drawn[:, 1].max())]
    assert ends == pytest.approx([5.0, 20.0], abs=0.3)
