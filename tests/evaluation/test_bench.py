"""The stopwatch's figures add up."""

import pytest

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.bench import measure
from uniteam.evaluation.memory import peak_memory
from uniteam.world.task.splits import load_split


def test_the_sections_of_a_step_add_up_to_the_whole() -> None:
    shown: list[int] = []
    of_other_tests = peak_memory()
    report = measure(load_split("minival"), AgentSpec("oracle", "truth"), 1, lambda: shown.append(1))
    assert shown == [1]
    assert report.episode_count == 1
    assert report.step_count > 10
    assert set(report.milliseconds) == {"camera", "physics", "perception", "map", "planner", "rest"}
    assert sum(report.milliseconds.values()) == pytest.approx(1000.0 / report.steps_per_second, rel=1e-6)
    assert report.milliseconds["camera"] > 0.1
    assert report.milliseconds["planner"] == 0.0
    assert 50 < report.peak_memory_mb < max(1500, 1.01 * of_other_tests)
