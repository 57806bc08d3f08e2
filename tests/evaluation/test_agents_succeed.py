"""The baseline and the best agent play two certified episodes in plain homes, and succeed.

HomeRobot's baseline fails on most episodes, and in plain homes too. These two are among those that it solves.
"""

import pytest
from worlds.easy_home import BESIDE_THE_DOOR, IN_THE_CORNER, easy_home

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.episode_loop import play_episode
from uniteam.world.certification.candidate_tasks import Tally
from uniteam.world.certification.generate_episodes import EpisodeMaker
from uniteam.world.task.environment import Environment

EPISODES = {"Move cup from table to bed": BESIDE_THE_DOOR, "Move ball from bed to table": IN_THE_CORNER}


@pytest.fixture(scope="module", params=tuple(EPISODES.items()), ids=tuple(EPISODES))
def environment(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Environment:
    """Return the environment of a certified episode."""
    instruction, table_at = request.param
    home = easy_home(tmp_path_factory.mktemp("models"), table_at)
    episodes = {str(episode.instruction): episode for episode in EpisodeMaker(home, Tally(), "tidy").episodes(2)}
    return Environment(home, episodes[instruction], give_truth=True)


@pytest.mark.parametrize("agent", ["baseline", "uniteam-plus"])
def test_an_agent_succeeds_where_little_is_difficult(environment: Environment, agent: str) -> None:
    result = play_episode(environment, AgentSpec(agent, "truth").make(environment))
    assert result.failure == ""
    assert result.measures.overall_success
