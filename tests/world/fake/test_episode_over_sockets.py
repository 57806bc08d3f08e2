"""An agent that succeeds in the simulator succeeds on a fake robot, over real sockets, with every dial at zero."""

import logging
from dataclasses import replace
from pathlib import Path

import pytest
from worlds.easy_home import BESIDE_THE_DOOR, easy_home
from worlds.fake_robot import PACE, UNHURRIED, served

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.episode_loop import play_episode
from uniteam.interface import Agent, Body, DiscreteAction
from uniteam.mind.agents.registry import make_agent
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.world.certification.candidate_tasks import Tally
from uniteam.world.certification.generate_episodes import EpisodeMaker
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.fake.dials import Dials
from uniteam.world.fake.fake_stretch import FakeStretch
from uniteam.world.real.bridge_link import BridgeLink
from uniteam.world.real.channel import Channel
from uniteam.world.real.safety import SafetyLimits
from uniteam.world.real.stretch_robot import StretchRobot
from uniteam.world.real.system_clock import SystemClock
from uniteam.world.real.zmq_wire import ZmqWire
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Episode
from uniteam.world.task.visible_truth import truth_maker

pytest.importorskip("zmq", reason="the extra 'robot' is not installed")
pytestmark = pytest.mark.slow

FAST = SafetyLimits(speed=2.0, turn_speed=6.0, fence=20.0, stale=2.0)


def play(agent: Agent, body: Body, episode: Episode, most_steps: int) -> int:
    """Play until the agent stops, and return how many steps it took."""
    agent.reset(episode.instruction, episode.seed)
    observation = body.reset()
    for step in range(most_steps):
        action = agent.act(observation).action
        if action is DiscreteAction.STOP:
            return step
        observation = body.step(action)
    return most_steps


def test_the_same_agent_succeeds_on_both(tmp_path: Path, caplog: pytest.LogCaptureFixture) -> None:
    home = easy_home(tmp_path, BESIDE_THE_DOOR)
    episode = next(
        e for e in EpisodeMaker(home, Tally(), "tidy").episodes(2) if str(e.instruction) == "Move cup from table to bed"
    )
    environment = Environment(home, episode, give_truth=True)
    assert play_episode(environment, AgentSpec("uniteam-plus", "truth").make(environment)).measures.overall_success

    robot = FakeStretch(Simulator(home, HEAD_CAMERA_HALF), episode, Dials(agility=12.0, image_hz=20.0))
    side = FakeBridge(robot)
    pace = replace(PACE, gain=8.0, rest=0.06)
    with served(side, truth_maker(home)) as ports, caplog.at_level(logging.WARNING, "uniteam.world.real"):
        channel = Channel(ZmqWire("127.0.0.1", ports.first), SystemClock(), FAST.stale, pace, UNHURRIED)
        body = StretchRobot(BridgeLink(channel, FAST, pace, UNHURRIED), FAST)
        steps = play(make_agent("uniteam-plus"), body, episode, 500)
        body.close()
    assert robot.measures.overall_success, (steps, robot.measures, caplog.messages)
    assert side.refusals == []
