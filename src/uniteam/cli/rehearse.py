"""`uniteam rehearse`: what a robot's drift and latency cost, measured on fake robots."""

from collections.abc import Mapping, Sequence
from contextlib import closing
from dataclasses import asdict
from itertools import groupby
from pathlib import Path
from typing import Annotated, Literal

import tyro
from rich.table import Table

import uniteam
from uniteam.cli.evaluate import check_at_least_one
from uniteam.cli.perceptions import as_folder
from uniteam.cli.progress import counting
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.evaluation import rehearsal
from uniteam.evaluation.agent_spec import label_agents
from uniteam.evaluation.configuration import Run, resolve
from uniteam.evaluation.episode_choice import choose_episodes
from uniteam.evaluation.rehearsal import Rehearsal, Rehearsed
from uniteam.evaluation.rehearsal_store import RehearsalStore
from uniteam.evaluation.results.intervals import estimate_proportion
from uniteam.evaluation.worker import camera_named
from uniteam.files import write_json
from uniteam.world.fake.dials import Dials
from uniteam.world.fake.joined import Join, in_lockstep, over_sockets
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.episode import Episode, Split
from uniteam.world.task.splits import load_split, split_label

JOINS: dict[str, Join] = {"lockstep": in_lockstep, "sockets": over_sockets}
"""How an agent's body is joined to a fake robot, by the name that is typed."""


FIGURES = "rehearsal.json"


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
    out: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None,
) -> None:
    """Play episodes in the simulator, and on fake robots at pairs of a drift and a latency, and print how many succeed.

    The agent acts through the same messages, checks and motions as on a real Stretch, but time passes only while it is
    waited for: a slow machine takes longer and finds the same. An episode takes a minute or more of computing. What
    was played is kept: stop with Ctrl-C and give the same command again to go on, or give it with more numbers.

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
        out: Directory of what each episode came to, and of the figures; runs/rehearsal-AGENT-SPLIT-PERCEPTION by
            default.
    """
    check_at_least_one(episodes=episodes, steps=steps)
    if not drift or not latency:
        raise InvalidInputError("--drift and --latency need at least one number each, such as --drift 0 0.02")
    settings = [Dials(late, far, depth_noise, holes, agility, image_hz, seed) for far in drift for late in latency]
    ((label, spec),) = label_agents((agent,), perception, with_, without).items()
    how = Rehearsal(spec, grasp, steps, JOINS[over])
    console, episodes_of = make_console(), load_split(split)
    chosen = [episodes_of.episodes[index] for index in choose_episodes(episodes_of.episodes, episodes)]
    folder = out or Path("runs") / f"rehearsal-{as_folder(label)}-{split_label(split)}-{as_folder(perception)}"
    resolved = resolve(Run(split, {label: spec}, perception, camera, grasp), episodes_of)
    with closing(RehearsalStore(folder, {**resolved, "steps": steps, "over": over})) as store:
        jobs = [(episode, dials) for episode in chosen for dials in (None, *settings)]
        if left := [job for job in jobs if (job[0].id, job[1]) not in store.known]:
            _play(left, store, episodes_of, camera, how)
        simulated = [store.known[episode.id, None] for episode in chosen]
        found = {dials: [store.known[episode.id, dials] for episode in chosen] for dials in settings}
    caption = (
        f"{label}, split {split}, {len(chosen)} episodes, perception {perception}, camera {camera}, grasp {grasp}, "
        f"agility {agility:g}, over {over}, uniteam {uniteam.__version__}; overall successes, 95 % interval, partial "
        "success, and how many episodes end unlike those in the simulator itself"
    )
    console.print(_table(found, simulated, shown(caption)))
    _write(folder / FIGURES, found, simulated, caption)
    console.print(f"Figures: {shown(folder / FIGURES)}", soft_wrap=True)


def _play(
    jobs: Sequence[tuple[Episode, Dials | None]], store: RehearsalStore, split: Split, camera: str, how: Rehearsal
) -> None:
    """Play episodes on fake robots, or in the simulator itself where there are no dials, and keep what they come to."""
    with counting(make_console(), "rehearsing", len(jobs)) as advance:
        for home, of_home in groupby(jobs, key=lambda job: job[0].home):
            simulator = Simulator(split.homes[home], camera_named(camera))
            for episode, dials in of_home:
                if dials is None:
                    rehearsed = rehearsal.play_simulated(simulator, episode, how)
                else:
                    rehearsed = rehearsal.rehearse(simulator, episode, dials, how)
                store.append(episode.id, dials, rehearsed)
                advance()


def _table(found: Mapping[Dials, Sequence[Rehearsed]], simulated: Sequence[Rehearsed], caption: str) -> Table:
    """Return a row for the simulator, one for each drift, and a column for each latency."""
    latencies = dict.fromkeys(dials.latency for dials in found)
    table = Table("drift", *(f"latency {latency:g} s" for latency in latencies), caption=caption)
    table.add_row("the simulator itself", _share(simulated))
    for drift in dict.fromkeys(dials.drift for dials in found):
        row = (_words(runs, simulated) for dials, runs in found.items() if dials.drift == drift)
        table.add_row(f"{100 * drift:g} %", *row)
    return table


def _words(runs: Sequence[Rehearsed], simulated: Sequence[Rehearsed]) -> str:
    pairs = zip(runs, simulated, strict=True)
    differing = sum(one.measures.overall_success != other.measures.overall_success for one, other in pairs)
    ended = sum(bool(run.ended_by) for run in runs)
    stopped = f", {ended} stopped" if ended else ""
    return f"{_share(runs)}, {differing} unlike the simulator{stopped}"


def _share(runs: Sequence[Rehearsed]) -> str:
    successes, count = sum(run.measures.overall_success for run in runs), len(runs)
    interval = estimate_proportion(successes, count)
    partial = sum(run.measures.partial_success for run in runs) / count
    return f"{successes} of {count} ({100 * interval.low:.0f}-{100 * interval.high:.0f} %), {100 * partial:.0f} %"


def _write(
    path: Path, found: Mapping[Dials, Sequence[Rehearsed]], simulated: Sequence[Rehearsed], caption: str
) -> None:
    rows = [{"dials": asdict(dials), "runs": [asdict(run) for run in runs]} for dials, runs in found.items()]
    write_json(path, {"caption": caption, "simulator": [asdict(run) for run in simulated], "settings": rows})
