"""The baseline and the best agent play two certified episodes in a plain home, and succeed."""

import pytest
from worlds.easy_home import easy_home

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.episode_loop import play_episode
from uniteam.world.certification.candidate_tasks import Tally
from uniteam.world.certification.generate_episodes import EpisodeMaker
from uniteam.world.homes.home import Home
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Episode


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Home:
    return easy_home(tmp_path_factory.mktemp("models"))


@pytest.fixture(scope="module")
def episodes(home: Home) -> dict[str, Episode]:
    """Return the home's certified episodes, by what they ask for."""
    return {str(episode.instruction): episode for episode in EpisodeMaker(home, Tally(), "tidy").episodes(2)}


@pytest.mark.parametrize("agent", ["baseline", "uniteam-plus"])
@pytest.mark.parametrize("task", ["Move cup from table to bed", "Move ball from bed to table"])
def test_an_agent_that_is_worth_its_name_succeeds_where_nothing_is_difficult(
    home: Home, episodes: dict[str, Episode], task: str, agent: str
) -> None:
    environment = Environment(home, episodes[task], give_truth=True)
    result = play_episode(environment, AgentSpec(agent, "truth").make(environment))
    assert result.failure == ""
    assert result.measures.overall_success
