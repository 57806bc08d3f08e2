"""Play episodes on a fake robot in its own time, and see what its faults cost."""

from dataclasses import dataclass

from uniteam.evaluation.agent_spec import AgentSpec
from uniteam.evaluation.body_loop import Task, act_in
from uniteam.mind.agents.registry import make_agent
from uniteam.world.fake.bridge import FakeBridge
from uniteam.world.fake.bridge_messages import no_truth
from uniteam.world.fake.dials import Dials
from uniteam.world.fake.fake_stretch import FakeStretch
from uniteam.world.fake.joined import Join
from uniteam.world.real.robot_errors import RobotError
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import MAXIMUM_STEPS, Episode
from uniteam.world.task.grasp_rules import grasp_rule_named
from uniteam.world.task.measures import Measures
from uniteam.world.task.visible_truth import truth_maker


@dataclass(frozen=True)
class Rehearsal:
    """How every episode is played.

    Attributes:
        spec: which agent.
        grasp: name of the rule by which the gripper takes objects.
        most_steps: after how many actions an episode is ended.
        join: how the agent's body is joined to a fake robot.
    """

    spec: AgentSpec
    grasp: str
    most_steps: int
    join: Join


@dataclass(frozen=True)
class Rehearsed:
    """What an episode came to, on a fake robot or in the simulator.

    Attributes:
        measures: those of the challenge; on a robot their steps are pictures.
        steps: how many actions the agent took.
        seconds: how long it took the robot; 0 in the simulator, in which only steps count.
        ended_by: what ended the run before the agent did, in a sentence; empty where nothing did.
    """

    measures: Measures
    steps: int
    seconds: float
    ended_by: str


def rehearse(simulator: Simulator, episode: Episode, dials: Dials, how: Rehearsal) -> Rehearsed:
    """Play one episode on a fake robot.

    Args:
        simulator: of the episode's home.
        episode: what is asked.
        dials: how the robot errs; where its motors are quicker than a Stretch's, the limits are wider by as much.
        how: it is played.
    """
    spec = how.spec
    robot = FakeStretch(simulator, episode, dials, grasp_rule_named(how.grasp))
    agent = make_agent(spec.name, spec.perception, spec.added, spec.removed)
    task, taken, ended_by = Task(episode.instruction, episode.seed, how.most_steps), list[int](), ""
    try:
        with how.join(FakeBridge(robot), truth_maker(simulator.home) if spec.needs_truth else no_truth) as body:
            act_in(body, agent, task, lambda step, decision: taken.append(step))
    except RobotError as error:
        ended_by = str(error)
    return Rehearsed(robot.measures, len(taken), robot.time, ended_by)


def play_simulated(simulator: Simulator, episode: Episode, how: Rehearsal) -> Rehearsed:
    """Play one episode in the simulator itself; takes what `rehearse` does, but for the dials."""
    rule, spec = grasp_rule_named(how.grasp), how.spec
    environment = Environment(simulator.home, episode, simulator.camera, spec.needs_truth, rule)
    task = Task(episode.instruction, episode.seed, min(how.most_steps, MAXIMUM_STEPS))
    act_in(environment, spec.make(environment), task)
    return Rehearsed(environment.measures, environment.measures.num_steps, 0.0, "")
