"""`uniteam swap`: what is played, and what of it is counted as healed."""

from pathlib import Path

import pytest
from worlds.called import call
from worlds.runs import result, write_run

from uniteam.errors import InvalidInputError
from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.analysis.swap_plan import MODULES, plan_swaps


def test_the_plan_has_each_agent_as_it_is_and_with_one_module_replaced() -> None:
    plan = plan_swaps(["baseline"], "noisy:1", list(MODULES))
    assert plan.agents == {
        "baseline": AgentSpec("baseline", "noisy:1"),
        "baseline, perception by the truth": AgentSpec("baseline", "truth"),
        "baseline, map by the truth": AgentSpec("true-map:baseline", "noisy:1"),
        "baseline, exploration by the truth": AgentSpec("true-exploration:baseline", "noisy:1"),
        "baseline, navigation by the truth": AgentSpec("true-navigation:baseline", "noisy:1"),
        "baseline, pick by the truth": AgentSpec("true-pick:baseline", "noisy:1"),
        "baseline, place by the truth": AgentSpec("true-place:baseline", "noisy:1"),
    }
    assert [(swap.as_it_is, swap.module) for swap in plan.swaps] == [
        ("baseline", module) for module in ("perception", "map", "exploration", "navigation", "pick", "place")
    ]
    with pytest.raises(InvalidInputError, match="perception is the truth already"):
        plan_swaps(["baseline"], "truth", ["perception"])
    with pytest.raises(InvalidInputError, match="no part of agent 'random' can be replaced"):
        plan_swaps(["random"], "truth", ["pick"])


def test_healed_and_broken_episodes_are_counted_in_pairs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    agents = {
        "baseline": [result(k, k < 10) for k in range(40)],
        "baseline, pick by the truth": [result(k, 2 <= k < 30) for k in range(40)],
        "baseline, place by the truth": [result(k, k < 11) for k in range(20)],
    }
    folder = write_run(tmp_path / "run", agents)
    given = ("swap", "--report-only", "--agents", "baseline", "--modules", "pick", "place", "--out", str(folder))
    assert call(*given) == 0
    lines = [[c.strip() for c in line.strip("│┃").split("│")] for line in capsys.readouterr().out.splitlines()]
    pick, place = (next(line for line in lines if line[0] == module) for module in ("pick", "place"))
    assert pick == ["pick", "40", "30", "20", "2", "+45.0*", "<.001"]
    assert place[:6] == ["place", "20", "10", "1", "0", "+5.0"]


def test_what_cannot_be_swapped_is_answered_in_a_sentence(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert call("swap", "--modules", "perception", "--out", str(tmp_path / "run")) == 2
    assert "perception is the truth already" in capsys.readouterr().err
    folder = write_run(tmp_path / "other", {"baseline": [result(1, True)]})
    assert call("swap", "--report-only", "--agents", "baseline", "--out", str(folder)) == 2
    assert "have played the same episode" in capsys.readouterr().err
