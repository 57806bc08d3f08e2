"""The figures of the environments' speed are of what was done."""

import gymnasium

from uniteam.adapters.gymnasium.throughput import measure_throughput


def test_a_navigation_makes_many_steps_a_second_of_the_processor() -> None:
    found = measure_throughput("uniteam/NavigateToObject-v0", 450)
    assert found.step_count == 450
    assert found.steps_per_second < 1.1 * found.steps_per_cpu_second
    assert found.steps_per_cpu_second > 100.0
    assert found.reset_milliseconds > 0.1  # it was cut after 400 steps, not stopped
    assert found.name in gymnasium.registry
