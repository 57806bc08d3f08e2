"""`uniteam rehearse`: what a robot's drift and latency cost, measured on fake robots."""

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Annotated, Literal

import tyro
from rich.table import Table

import uniteam
from uniteam.cli.evaluate import check_at_least_one
from uniteam.cli.progress import counting
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.evaluation import rehearsal
from uniteam.evaluation.agent_spec import label_agents
from uniteam.evaluation.episode_choice import choose_episodes
from uniteam.evaluation.rehearsal import Rehearsal, Rehearsed
from uniteam.evaluation.results.intervals import estimate_proportion
from uniteam.evaluation.worker import camera_named
from uniteam.files import try_output, write_whole
from uniteam.world.fake.dials import Dials
from uniteam.world.fake.joined import Join, in_lockstep, over_sockets
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.measures import Measures
from uniteam.world.task.splits import load_split

JOINS: dict[str, Join] = {"lockstep": in_lockstep, "sockets": over_sockets}
"""How an agent's body is joined to a fake robot, by the name that is typed."""


@dataclass(frozen=True)
class Cell:
    """A setting of the dials, and what the episodes came to with it."""

    dials: Dials
    runs: tuple[Rehearsed, ...]


def rehearse(
    agent: str = "uniteam-plus",
    split: str = "minival",
    episodes: Annotated[int, tyro.conf.arg(metavar="N")] = 2,
    drift: tuple[float, ...] = (0.0, 0.02),
    latency: tuple[float, ...] = (0.0, 0.1),
    depth_noise: Annotated[float, tyro.conf.arg(metavar="METRES")] = 0.0,
    holes: Annotated[float, tyro.conf.arg(metavar="SHARE")] = 0.0,
    agility: float = 1.0,
    image_hz: float = 5.0,
    steps: Annotated[int, tyro.conf.arg(metavar="N")] = 1250,
    seed: int = 0,
    perception: str = "truth",
    camera: Literal["half", "full"] = "half",
    grasp: Literal["challenge", "honest", "arm"] = "challenge",
    with_: Annotated[tuple[str, ...], tyro.conf.arg(name="with")] = (),
    without: tuple[str, ...] = (),
    over: Literal["lockstep", "sockets"] = "lockstep",
    out: Annotated[Path | None, tyro.conf.arg(metavar="FILE.json")] = None,
) -> None:
    """Play episodes in the simulator, and on fake robots at pairs of a drift and a latency, and print how many succeed.

    The agent acts through the same messages, checks and motions as on a real Stretch, but time passes only while it is
    waited for: a slow machine takes longer and finds the same. An episode takes a minute or more of computing.

    Args:
        agent: Which agent: a name, or your own as MODULE:ATTRIBUTE.
        split: A built-in split (minival, val, test-standard, test-challenge, train) or a file of episodes.
        episodes: How many episodes, taken from the homes in turn.
        drift: The odometry's errors to try, each a share of what is driven and turned.
        latency: The delays to try, by which every message is late, in either direction (s).
        depth_noise: The depth's standard deviation at 1 m; it grows with the square of the distance.
        holes: The share of the depth image in which nothing returns.
        agility: How many times as fast the motors are as a Stretch's.
        image_hz: Pictures a second.
        steps: After how many actions an episode ends.
        seed: Of drift, noise and holes.
        perception: What the agent sees with: a name, NAME:ARGUMENT for one that takes an argument, or your own as
            MODULE:ATTRIBUTE.
        camera: Images of 240x320 (half) or of 480x640 (full).
        grasp: What the gripper takes: only a candidate object, as in the challenge, whatever small object the camera
            points at (honest), or what its fingers close around (arm), which needs --with arm_grasp.
        with_: Improvements to add if the agent lacks them, names, or your own as MODULE:ATTRIBUTE.
        without: Improvements to take from the agent, by name.
        over: What carries the messages: a call (lockstep), or four ports of this machine (sockets), which leave to
            chance in which moment a message arrives.
        out: A .json file for the figures and each episode's end.
    """
    check_at_least_one(episodes=episodes, steps=steps)
    if not drift or not latency:
        raise InvalidInputError("--drift and --latency need at least one number each, such as --drift 0 0.02")
    settings = [Dials(late, far, depth_noise, holes, agility, image_hz, seed) for far in drift for late in latency]
    ((label, spec),) = label_agents((agent,), perception, with_, without).items()
    how = Rehearsal(spec, grasp, steps, JOINS[over])
    if out is not None:
        try_output(out, (".json",))
    console, episodes_of = make_console(), load_split(split)
    chosen = [episodes_of.episodes[index] for index in choose_episodes(episodes_of.episodes, episodes)]
    cells: dict[Dials, list[Rehearsed]] = {dials: [] for dials in settings}
    simulated: list[Measures] = []
    with counting(console, "rehearsing", (1 + len(settings)) * len(chosen)) as advance:
        for episode in chosen:
            simulator = Simulator(episodes_of.homes[episode.home], camera_named(camera))
            simulated.append(rehearsal.play_simulated(simulator, episode, how))
            advance()
            for dials in settings:
                cells[dials].append(rehearsal.rehearse(simulator, episode, dials, how))
                advance()
    caption = (
        f"{label}, split {split}, {len(chosen)} episodes, perception {perception}, camera {camera}, grasp {grasp}, "
        f"agility {agility:g}, over {over}, uniteam {uniteam.__version__}; overall successes, 95 % interval, partial "
        "success, and how many episodes end unlike those in the simulator itself"
    )
    console.print(_table([Cell(dials, tuple(runs)) for dials, runs in cells.items()], simulated, shown(caption)))
    if out is not None:
        _write(out, cells, simulated, caption)
        console.print(f"Figures: {shown(out)}", soft_wrap=True)


def _table(cells: Sequence[Cell], simulated: Sequence[Measures], caption: str) -> Table:
    """Return a row for the simulator, one for each drift, and a column for each latency."""
    latencies = list(dict.fromkeys(cell.dials.latency for cell in cells))
    table = Table("drift", *(f"latency {latency:g} s" for latency in latencies), caption=caption)
    table.add_row("the simulator itself", _share(simulated))
    for drift in dict.fromkeys(cell.dials.drift for cell in cells):
        row = (_words(cell, simulated) for cell in cells if cell.dials.drift == drift)
        table.add_row(f"{100 * drift:g} %", *row)
    return table


def _words(cell: Cell, simulated: Sequence[Measures]) -> str:
    measures = [run.measures for run in cell.runs]
    pairs = zip(measures, simulated, strict=True)
    differing = sum(one.overall_success != other.overall_success for one, other in pairs)
    ended = sum(bool(run.ended_by) for run in cell.runs)
    stopped = f", {ended} stopped" if ended else ""
    return f"{_share(measures)}, {differing} unlike the simulator{stopped}"


def _share(measures: Sequence[Measures]) -> str:
    successes, count = sum(one.overall_success for one in measures), len(measures)
    interval = estimate_proportion(successes, count)
    partial = sum(one.partial_success for one in measures) / count
    return f"{successes} of {count} ({100 * interval.low:.0f}-{100 * interval.high:.0f} %), {100 * partial:.0f} %"


def _write(out: Path, cells: dict[Dials, list[Rehearsed]], simulated: Sequence[Measures], caption: str) -> None:
    rows = [{"dials": asdict(dials), "runs": [asdict(run) for run in runs]} for dials, runs in cells.items()]
    figures = {"caption": caption, "simulator": [asdict(one) for one in simulated], "settings": rows}
    write_whole(out, (json.dumps(figures, indent=2) + "\n").encode())
