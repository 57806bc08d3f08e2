"""Folders of runs that nobody played: results of which the truth is known."""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from uniteam.evaluation.results.result import EpisodeResult, result_to_line
from uniteam.world.task.measures import Measures

CONFIGURATION = {
    "version": "0.1.0", "code": "c0de", "split": "val", "split_version": 2, "split_digest": "d1", "homes_digest": "d2",
    "models_digest": "d3", "software": {"python": "3.11"}, "perception": "truth", "camera": "half",
    "grasp": "challenge", "episode_seconds": 3600.0,
}  # fmt: skip


def result(
    number: int, success: bool, home: str | None = None, steps: int = 300, unseen: bool = False
) -> EpisodeResult:
    """Return the result of episode `number`: an overall success, or one that found the object and no more."""
    measures = Measures(True, success, success, success, 0, steps, True)
    home = home or f"home-{number}"
    return EpisodeResult(f"e{number:03d}", home, "Move cup from table to sink", unseen, measures, "DONE", "", 1.0, 1.0)


def write_run(folder: Path, agents: Mapping[str, Sequence[EpisodeResult]], **configuration: Any) -> Path:
    """Write a run's folder and return it; `configuration` replaces fields of the usual one."""
    folder.mkdir(parents=True)
    told = {**CONFIGURATION, **configuration, "agents": {agent: {"agent": agent} for agent in agents}}
    (folder / "config.json").write_text(json.dumps(told))
    lines = (result_to_line(agent, each) for agent, results in agents.items() for each in results)
    (folder / "results.jsonl").write_text("".join(lines))
    return folder
