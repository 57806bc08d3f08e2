"""Play episodes on a fake robot in its own time, and see what its faults cost."""

from dataclasses import dataclass, replace

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.body_loop import Task, act_in
from uniteam.mind.agents.registry import make_agent
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.fake.bridge_messages import TruthOf, no_truth
from uniteam.world.fake.dials import Dials
from uniteam.world.fake.fake_stretch import FakeStretch
from uniteam.world.fake.lockstep import Lockstep
from uniteam.world.real.bridge_link import BridgeLink
from uniteam.world.real.channel import Channel
from uniteam.world.real.pace import Pace, Patience
from uniteam.world.real.robot_errors import RobotError
from uniteam.world.real.safety import SafetyLimits
from uniteam.world.real.stretch_robot import StretchRobot
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import MAXIMUM_STEPS, Episode
from uniteam.world.task.grasp_rules import grasp_rule_named
from uniteam.world.task.measures import Measures
from uniteam.world.task.visible_truth import truth_maker

WIDE_FENCE = 100.0
"""m: a simulated home needs none."""


@dataclass(frozen=True)
class Rehearsed:
    """What an episode on a fake robot came to.

    Attributes:
        measures: those of the challenge; their steps are pictures.
        steps: how many actions the agent took.
        seconds: how long it took the robot.
        ended_by: what ended the run before the agent did, in a sentence; empty where nothing did.
    """

    measures: Measures
    steps: int
    seconds: float
    ended_by: str


def rehearse(
    simulator: Simulator, episode: Episode, spec: AgentSpec, dials: Dials, grasp: str, most_steps: int
) -> Rehearsed:
    """Play one episode over the bridge's messages, without its ports.

    Args:
        simulator: of the episode's home.
        episode: what is asked.
        spec: which agent.
        dials: how the robot errs; where its motors are quicker than a Stretch's, the limits are wider by as much.
        grasp: name of the rule by which the gripper takes objects.
        most_steps: after which it is ended.
    """
    robot = FakeStretch(simulator, episode, dials, grasp_rule_named(grasp))
    body = lockstep_robot(FakeBridge(robot), truth_maker(simulator.home) if spec.needs_truth else no_truth)
    agent = make_agent(spec.name, spec.perception, spec.added, spec.removed)
    task, taken = Task(episode.instruction, episode.seed, most_steps), list[int]()
    try:
        act_in(body, agent, task, lambda step, decision: taken.append(step))
        ended_by = ""
    except RobotError as error:
        ended_by = str(error)
    return Rehearsed(robot.measures, len(taken), robot.time, ended_by)


def play_simulated(simulator: Simulator, episode: Episode, spec: AgentSpec, grasp: str, most_steps: int) -> Measures:
    """Play one episode in the simulator itself, and return what it came to; takes what `rehearse` does."""
    rule = grasp_rule_named(grasp)
    environment = Environment(simulator.home, episode, simulator.camera, spec.needs_truth, rule)
    task = Task(episode.instruction, episode.seed, min(most_steps, MAXIMUM_STEPS))
    act_in(environment, spec.make(environment), task)
    return environment.measures


def lockstep_robot(bridge: FakeBridge, truth_of: TruthOf) -> StretchRobot:
    """Return the body of a fake robot whose time passes while it is waited for, at limits that suit its motors."""
    agility, camera = bridge.robot.dials.agility, bridge.robot.simulator.camera
    line, limits, pace = Lockstep(bridge, camera, truth_of), limits_at(agility), pace_at(agility)
    channel = Channel(line, line, limits.stale, pace, Patience())
    return StretchRobot(BridgeLink(channel, limits, pace, Patience()), limits)


def limits_at(agility: float) -> SafetyLimits:
    """Return the usual limits for motors that are some times as quick as a Stretch's, without a fence."""
    usual = SafetyLimits()
    return replace(usual, speed=usual.speed * agility, turn_speed=usual.turn_speed * agility, fence=WIDE_FENCE)


def pace_at(agility: float) -> Pace:
    """Return the usual pace for such motors."""
    usual = Pace()
    return replace(
        usual,
        command=usual.command / agility,
        gain=usual.gain * agility,
        rest=usual.rest / agility,
        settle=usual.settle / agility,
    )
