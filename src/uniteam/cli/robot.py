"""`uniteam robot`: an agent on a real Stretch."""

import sys
from collections.abc import Callable
from typing import Annotated

import tyro
from rich.console import Console

from uniteam.cli.keys import Keys, listening
from uniteam.cli.perceptions import perception_name
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.evaluation.agent_spec import label_agents
from uniteam.evaluation.body_loop import BodyRun, Task, act_in
from uniteam.interface import Decision, Instruction
from uniteam.mind.agents.registry import is_told_the_truth, make_agent
from uniteam.world.real.connect import connect
from uniteam.world.real.dry_run import DryRunLink
from uniteam.world.real.link import RobotState, View
from uniteam.world.real.motions import Motion, first_motions
from uniteam.world.real.robot_errors import RunStopError
from uniteam.world.real.safety import FASTEST, FASTEST_TURN, SafetyLimits
from uniteam.world.real.stretch_robot import StretchRobot
from uniteam.world.real.zmq_wire import OBSERVATION_PORT

CONSENT = "go"


def robot(
    host: Annotated[str, tyro.conf.Positional, tyro.conf.arg(metavar="HOST")],
    object_: Annotated[str, tyro.conf.arg(name="object")],
    start: str,
    goal: str,
    agent: str = "uniteam-plus",
    perception: str = "learned",
    model: Annotated[str | None, tyro.conf.arg(metavar="ORG/NAME")] = None,
    revision: Annotated[str | None, tyro.conf.arg(metavar="R")] = None,
    dry_run: bool = False,
    steps: Annotated[int, tyro.conf.arg(metavar="N")] = 200,
    speed: Annotated[float, tyro.conf.arg(metavar="M/S")] = 0.15,
    turn_speed: Annotated[float, tyro.conf.arg(metavar="RAD/S")] = 0.4,
    fence: Annotated[float, tyro.conf.arg(metavar="METRES")] = 3.0,
    seed: int = 0,
    port: Annotated[int, tyro.conf.arg(metavar="N")] = OBSERVATION_PORT,
    with_: Annotated[tuple[str, ...], tyro.conf.arg(name="with")] = (),
    without: tuple[str, ...] = (),
) -> None:
    """Let an agent act on a Stretch: say what it will do, ask before the first motion, and stop at the press of a key.

    The robot runs the bridge of stretch_ai. Begin with --dry-run, which moves nothing. The base stops where the robot
    falls silent for half a second, where it would leave the fence, at its run-stop, at any key, at Ctrl-C and at any
    error. The arm feels nothing: keep people and pets away, and a hand on the robot's run-stop.

    Args:
        host: The robot's name or address; here on the robot itself, through stretch_body.
        object_: What to move, such as cup.
        start: On what it is, such as table.
        goal: Onto what to put it, such as cabinet.
        agent: Which agent: a name, or your own as MODULE:ATTRIBUTE.
        perception: What the agent sees with: a name, NAME:ARGUMENT for one that takes an argument, or your own as
            MODULE:ATTRIBUTE.
        model: The weights of a detector: ORG/NAME on the Hugging Face hub, or a folder.
        revision: Which commit of the model.
        dry_run: Only print what it would do; nothing moves.
        steps: After how many actions to end.
        speed: How fast the base drives at most, up to 0.3.
        turn_speed: How fast it turns at most, up to 1.
        fence: How far from where it began the base may go.
        seed: Of the agent's random choices.
        port: The first of the robot's four ports.
        with_: Improvements to add if the agent lacks them, names, or your own as MODULE:ATTRIBUTE.
        without: Improvements to take from the agent, by name.
    """
    if not steps >= 1:
        raise InvalidInputError(f"--steps must be at least 1, got {steps}")
    limits = _limits(speed, turn_speed, fence)
    ((label, spec),) = label_agents((agent,), perception_name(perception, model, revision), with_, without).items()
    if is_told_the_truth(spec.name):
        raise InvalidInputError(f"agent '{spec.name}' must be told the truth, which no robot knows; choose another")
    mind = make_agent(spec.name, spec.perception, spec.added, spec.removed)
    console, task = make_console(), Task(Instruction(object_, start, goal), seed, steps)
    with console.status(f"connecting to {shown(host)}"):
        link = connect(host, port, limits)
    try:
        view = link.glance()
        _check_sees(view, spec.needs_truth, spec.perception)
        _introduce(console, view, limits, f"{label}, {spec.perception}", task)
        if dry_run:
            console.print("Dry run: nothing is sent to the robot, and the agent sees that nothing moves.\n")
            link = DryRunLink(link)
        elif not _is_consented(console):
            console.print("Nothing was moved.")
            return
        with listening() as keys:
            body = StretchRobot(link, limits, (_StopKey(keys),), _teller(console, dry_run))
            try:
                _report(console, act_in(body, mind, task, _narrator(console)), dry_run)
            finally:
                link.halt()
    finally:
        link.close()


def _limits(speed: float, turn_speed: float, fence: float) -> SafetyLimits:
    for name, value, most in (("speed", speed, FASTEST), ("turn-speed", turn_speed, FASTEST_TURN)):
        if not 0.0 < value <= most:
            raise InvalidInputError(f"--{name} must be above 0 and at most {most:g}, got {value:g}")
    return SafetyLimits(speed, turn_speed, fence)


def _check_sees(view: View, needs_truth: bool, perception: str) -> None:
    if needs_truth and view.truth is None:
        raise InvalidInputError(
            f"perception '{perception}' needs the truth, which no robot knows; choose another, such as learned "
            "(or give 'uniteam fake-robot' --truth)"
        )


def _introduce(console: Console, view: View, limits: SafetyLimits, label: str, task: Task) -> None:
    """Say what is there, and what will be done."""
    first = "; then ".join(map(str, first_motions(view.state.joints)))
    console.print(f"[bold]{shown(task.instruction)}[/] ({shown(label)})")
    console.print(
        f"The robot shows pictures of {view.camera.height}x{view.camera.width}"
        f"{', and says that it is a simulation that tells the truth' if view.truth is not None else ''}. "
        f"It will begin thus: {first}. Then it acts for at most {task.most_steps} steps, at up to {limits.speed:g} m/s "
        f"and {limits.turn_speed:g} rad/s, within {limits.fence:g} m of where it stands now.",
        soft_wrap=True,
    )


def _is_consented(console: Console) -> bool:
    console.print(
        f"Is its run-stop within reach, and nobody near? Type [bold]{CONSENT}[/] and Enter to let it move; from then "
        "on any key stops it: ",
        end="",
        soft_wrap=True,
    )
    return sys.stdin.readline().strip().lower() == CONSENT


class _StopKey:
    """Stops the robot at the press of a key."""

    def __init__(self, keys: Keys) -> None:
        self._keys = keys

    def __call__(self, state: RobotState) -> None:
        if self._keys.pressed():
            raise RunStopError("a key was pressed, so the robot was told to stop; give the command again to go on")


def _teller(console: Console, dry_run: bool) -> Callable[[Motion, str], None]:
    def tell(motion: Motion, refusal: str) -> None:
        would = "would " if dry_run else ""
        trouble = f"; not done, for [yellow]{shown(refusal)}[/]" if refusal else ""
        console.print(f"       {would}{shown(motion)}{trouble}", soft_wrap=True)

    return tell


def _narrator(console: Console) -> Callable[[int, Decision], None]:
    def say(step: int, decision: Decision) -> None:
        console.print(f"[dim]{step:5d}[/]  [bold]{shown(decision.state)}[/]: {shown(decision.reason)}", soft_wrap=True)

    return say


def _report(console: Console, run: BodyRun, dry_run: bool) -> None:
    how = "The agent has stopped" if run.has_stopped else "The steps are used up"
    console.print(f"{how} after {run.steps} steps{' that were not taken' if dry_run else ''}.")
