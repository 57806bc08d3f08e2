"""An agent that succeeds in the simulator succeeds on a fake robot, over real sockets, with every dial at zero."""

import logging
from pathlib import Path

import pytest
from worlds.easy_home import BESIDE_THE_DOOR, easy_home

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.body_loop import Task, act_in
from uniteam.evaluation.episode_loop import play_episode
from uniteam.mind.agents.registry import make_agent
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.world.certification.candidate_tasks import Tally
from uniteam.world.certification.generate_episodes import EpisodeMaker
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.fake.dials import Dials
from uniteam.world.fake.fake_stretch import FakeStretch
from uniteam.world.fake.joined import over_sockets
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.environment import Environment
from uniteam.world.task.visible_truth import truth_maker

pytest.importorskip("zmq", reason="the extra 'robot' is not installed")
pytestmark = pytest.mark.slow


def test_the_same_agent_succeeds_on_both(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    home = easy_home(tmp_path, BESIDE_THE_DOOR)
    episode = next(
        e for e in EpisodeMaker(home, Tally(), "tidy").episodes(2) if str(e.instruction) == "Move cup from table to bed"
    )
    environment = Environment(home, episode, give_truth=True)
    assert play_episode(environment, AgentSpec("uniteam-plus", "truth").make(environment)).measures.overall_success

    robot = FakeStretch(Simulator(home, HEAD_CAMERA_HALF), episode, Dials(agility=4.0, image_hz=5.0))
    side = FakeBridge(robot)
    task = Task(episode.instruction, episode.seed, 500)
    with over_sockets(side, truth_maker(home)) as body, caplog.at_level(logging.WARNING, "uniteam.world.real"):
        run = act_in(body, make_agent("uniteam-plus"), task)
    assert robot.measures.overall_success, (run, robot.measures, caplog.messages)
    assert side.refusals == []
