"""Whether runs differ in nothing but their agents: what else differs would be taken for what an agent is worth."""

from collections.abc import Mapping, Sequence
from typing import Any

from uniteam.evaluation.results.run_folder import RunFolder

MUST_AGREE = {
    "split": "split",
    "split_version": "version of the split",
    "split_digest": "contents of the split",
    "homes_digest": "homes",
    "models_digest": "models",
    "version": "version of uniteam",
    "code": "code of world, mind and evaluation",
    "perception": "perception",
    "camera": "camera",
    "grasp": "rule of the grasp",
    "episode_seconds": "time for an episode",
}
"""Fields of a run's configuration, and what they are in words."""


def differences_of(runs: Sequence[RunFolder]) -> list[str]:
    """Return a phrase for each thing that runs must agree in, and do not."""
    return [f"{words}: {_values(runs, name)}" for name, words in MUST_AGREE.items() if len(_distinct(runs, name)) > 1]


def software_differs(runs: Sequence[RunFolder]) -> bool:
    """Return whether runs were made with other versions of packages or on other processors: last bits may differ."""
    return len(_distinct(runs, "software")) > 1


def _values(runs: Sequence[RunFolder], name: str) -> str:
    return ", ".join(f"{run.configuration.get(name, 'not told')} in {run.directory}" for run in runs)


def _distinct(runs: Sequence[RunFolder], name: str) -> list[Any]:
    found: list[Any] = []
    for run in runs:
        value: Mapping[str, Any] | str | None = run.configuration.get(name)
        found += [] if value in found else [value]
    return found
