"""Whatever is registered keeps what its interface promises."""

from pathlib import Path
from typing import Any

import pytest
from worlds.procthor_miniature import write_miniature

from uniteam.errors import UnavailableError
from uniteam.evaluation.agent_spec import AGENTS
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import IMPROVEMENTS, improved
from uniteam.mind.perception.registry import PERCEPTIONS, make_perception
from uniteam.registry import Family, Registry
from uniteam.testing import check_agent, check_body, check_home, check_perception
from uniteam.testing.episodes import new_environment
from uniteam.world.generation.registry import HOMES


@pytest.mark.parametrize("name", AGENTS.names())
def test_every_agent_passes(name: str) -> None:
    check_agent(name)


@pytest.mark.slow
@pytest.mark.parametrize("name", IMPROVEMENTS.names())
def test_every_improvement_alone_on_the_baseline_passes(name: str) -> None:
    check_agent(improved(BASELINE, [name]))


BROUGHT = ("detic", "yoloe", "recognize-anything")
"""Perceptions of files or code of the user's own."""


def examples(registry: Registry[Any]) -> list[str]:
    """Return every name, those of families with an argument."""
    found = [(name, registry.look_up(name)) for name in registry.names()]
    return [f"{name}:{what.example}" if isinstance(what, Family) else name for name, what in found]


@pytest.mark.parametrize("name", examples(PERCEPTIONS))
def test_every_perception_passes(name: str) -> None:
    if name.partition(":")[0] in BROUGHT:
        pytest.skip("it is made of what is brought; its tests bring a stand-in")
    try:
        make_perception(name)
    except UnavailableError as missing:
        pytest.skip(f"its adapter has tests of its own; here {missing}")
    check_perception(name)


@pytest.mark.parametrize("name", HOMES.names())
def test_every_source_of_homes_passes(name: str, tmp_path: Path) -> None:
    is_brought = isinstance(HOMES.look_up(name), Family)
    check_home(f"{name}:{write_miniature(tmp_path)}" if is_brought else name)


def test_the_environment_is_a_body() -> None:
    check_body(new_environment)
