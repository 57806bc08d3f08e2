"""`uniteam run`: one episode, narrated and filmed."""

from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from types import TracebackType
from typing import Annotated, Literal

import tyro
from rich.console import Console
from rich.table import Table

from uniteam.cli.perceptions import perception_name
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.evaluation.agent_spec import label_agents
from uniteam.evaluation.configuration import Run, resolve
from uniteam.evaluation.episode_loop import Observer, Step, play_episode
from uniteam.evaluation.recording.order import SUFFIX
from uniteam.evaluation.recording.provenance import provenance_of
from uniteam.evaluation.recording.recorder import Recorder
from uniteam.evaluation.results.result import EpisodeResult, measures_to_data
from uniteam.evaluation.worker import camera_named
from uniteam.files import try_output
from uniteam.visualization.film import Film
from uniteam.visualization.narration import Narrator
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Episode
from uniteam.world.task.grasp_rules import grasp_rule_named
from uniteam.world.task.splits import load_split

_STYLES = {"state": "bold", "action": "cyan", "trouble": "red", "success": "green"}


def run(
    agent: str = "uniteam-plus",
    split: str = "minival",
    episode: int = 0,
    video: Annotated[Path | None, tyro.conf.arg(metavar="FILE.mp4")] = None,
    record: Annotated[Path | None, tyro.conf.arg(metavar="FILE.zip")] = None,
    perception: str = "learned",
    model: Annotated[str | None, tyro.conf.arg(metavar="ORG/NAME")] = None,
    revision: Annotated[str | None, tyro.conf.arg(metavar="R")] = None,
    camera: Literal["half", "full"] = "half",
    grasp: Literal["challenge", "honest", "arm"] = "challenge",
    with_: Annotated[tuple[str, ...], tyro.conf.arg(name="with")] = (),
    without: tuple[str, ...] = (),
) -> None:
    """Play one episode, tell what happens a line at a time, and film it if asked to.

    Args:
        agent: Which agent: a name, or your own as MODULE:ATTRIBUTE.
        split: A built-in split (minival, val, test-standard, test-challenge, train), a file of episodes, or
            ovmm:FOLDER for a folder of the challenge's own.
        episode: Which episode of the split, counted from 0.
        video: An .mp4 file to film it into.
        record: A .zip file to record it into, from which it can be explained and replayed.
        perception: What the agent sees with: learned (colours, depth and words, nothing else), truth (perfect, to find
            out what perception costs), another name, NAME:ARGUMENT for one that takes an argument, or your own as
            MODULE:ATTRIBUTE.
        model: The weights of a detector: ORG/NAME on the Hugging Face hub, or a folder.
        revision: Which commit of the model; give it where results are to be repeated.
        camera: Images of 240x320 (half) or of 480x640 (full).
        grasp: What the gripper takes: only a candidate object, as in the challenge, whatever small object the camera
            points at (honest), or what its fingers close around (arm), which needs --with arm_grasp.
        with_: Improvements to add if the agent lacks them, names, or your own as MODULE:ATTRIBUTE.
        without: Improvements to take from the agent, by name.
    """
    perception = perception_name(perception, model, revision)
    console = make_console()
    ((label, spec),) = label_agents((agent,), perception, with_, without).items()
    episodes = load_split(split)
    chosen = _choose(episodes.episodes, episode, split)
    with ExitStack() as stack:
        status = stack.enter_context(console.status("starting (the first time on a machine, compiling)"))
        home, rule = episodes.homes[chosen.home], grasp_rule_named(grasp)
        environment = Environment(home, chosen, camera_named(camera), spec.needs_truth, rule)
        observers: list[Observer] = [lambda step: status.stop(), Narrator(_speak_to(console))]
        if video is not None:
            stack.push(_teller_of_film(video, console))
            film = stack.enter_context(Film(video, environment, f"{label} · {episodes.name} · episode {episode}"))
            observers.append(film)
        where = shown(f"({episodes.name}, episode {episode}, {label}, {perception}, grasp {grasp})")
        console.print(f"[bold]{shown(chosen.instruction)}[/] {where}\n")
        recorder = None
        if record is not None:
            try_output(record, (SUFFIX,))
            configuration = resolve(Run(split, {label: spec}, perception, camera, grasp), episodes)
            recorder = Recorder(environment, provenance_of(label, spec, split, configuration))
            observers.append(recorder)
        result = play_episode(environment, spec.make(environment), lambda step: _show(step, observers))
        _report(result, console)
        if record is not None and recorder is not None:
            recorder.write(record, result)
            console.print(f"Recording: {shown(record)} ({record.stat().st_size / 1e6:.1f} MB)", soft_wrap=True)


def _teller_of_film(
    video: Path, console: Console
) -> Callable[[type[BaseException] | None, BaseException | None, TracebackType | None], None]:
    """Return what says where the film is once it is closed: the whole of it, or up to where it was stopped."""

    def tell(kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        if kind is None or issubclass(kind, KeyboardInterrupt):
            console.print(f"Film: {shown(video)}{'' if kind is None else ', up to here'}", soft_wrap=True)

    return tell


def _choose(episodes: tuple[Episode, ...], index: int, split: str) -> Episode:
    if not 0 <= index < len(episodes):
        raise InvalidInputError(f"split '{split}' has episodes 0 to {len(episodes) - 1}, there is no episode {index}")
    return episodes[index]


def _show(step: Step, observers: list[Observer]) -> None:
    for observer in observers:
        observer(step)


def _speak_to(console: Console) -> Callable[[int, str, str], None]:
    def say(number: int, kind: str, sentence: str) -> None:
        style = _STYLES[kind]
        console.print(f"[dim]{number:5d}[/]  [{style}]{shown(sentence)}[/]", soft_wrap=True)

    return say


def _report(result: EpisodeResult, console: Console) -> None:
    """Print the final measures under the challenge's names."""
    table = Table(box=None, show_header=False)
    for name, value in measures_to_data(result.measures).items():
        table.add_row(name, str(value))
    console.print()
    console.print(table)
    verdict = f"[red]{shown(result.failure)}[/]" if result.failure else "[green]overall success[/]"
    rate = result.measures.num_steps / result.seconds
    console.print(
        f"{verdict}\n{result.seconds:.1f} s, {rate:.0f} steps a second, narration, film and recording included."
    )
