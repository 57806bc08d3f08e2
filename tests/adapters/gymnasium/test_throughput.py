"""The figures of the environments' speed are of what was done."""

import json
from pathlib import Path

import gymnasium
import pytest

from uniteam.adapters.gymnasium import ENVIRONMENTS
from uniteam.adapters.gymnasium.throughput import measure_throughput
from uniteam.cli import bench
from uniteam.cli.main import main


def test_a_navigation_makes_many_steps_a_second_of_the_processor() -> None:
    found = measure_throughput("uniteam/NavigateToObject-v0", 450)
    assert found.step_count == 450
    assert found.steps_per_second < 1.1 * found.steps_per_cpu_second
    assert found.steps_per_cpu_second > 100.0
    assert found.reset_milliseconds > 0.1  # it was cut after 400 steps, not stopped
    assert found.name in gymnasium.registry


def test_the_command_prints_the_speed_of_each(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(bench, "ENVIRONMENT_STEPS", 3)
    with pytest.raises(SystemExit) as ended:
        main(("bench", "--env", "--out", str(tmp_path / "speed.json")))
    assert ended.value.code == 0
    told = capsys.readouterr().out
    figures = json.loads((tmp_path / "speed.json").read_text())["environments"]
    assert [figure["name"] for figure in figures] == list(ENVIRONMENTS)
    for name in ENVIRONMENTS:
        assert name in told
