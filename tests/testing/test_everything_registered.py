"""Whatever is registered keeps what its interface promises."""

import pytest

from uniteam.evaluation.agent_spec import AGENTS
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import IMPROVEMENTS, improved
from uniteam.mind.perception.registry import PERCEPTIONS
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


@pytest.mark.parametrize("name", PERCEPTIONS.names())
def test_every_perception_passes(name: str) -> None:
    if name == "learned":
        pytest.importorskip("onnxruntime")
    check_perception(name)


@pytest.mark.parametrize("name", HOMES.names())
def test_every_source_of_homes_passes(name: str) -> None:
    check_home(name)


def test_the_environment_is_a_body() -> None:
    check_body(new_environment)
