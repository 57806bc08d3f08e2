"""`uniteam evaluate`: agents over a split, and the challenge's table."""

from pathlib import Path
from statistics import fmean
from typing import Annotated, Literal

import tyro
from rich.console import Console
from rich.filesize import decimal

import uniteam
from uniteam.cli.perceptions import as_folder, perception_name
from uniteam.cli.progress import play_under_bar
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError, UniteamError
from uniteam.evaluation.agent_spec import label_agents
from uniteam.evaluation.analysis.breakdown import Groups, grouped
from uniteam.evaluation.analysis.table import Row, challenge_table
from uniteam.evaluation.backends.capacity import allowed_cores, most_workers
from uniteam.evaluation.configuration import Run
from uniteam.evaluation.engines import in_processes, on_ray
from uniteam.evaluation.episode_choice import shard_named
from uniteam.evaluation.evaluation import Evaluation
from uniteam.evaluation.recording.order import RecordingOrder
from uniteam.evaluation.results.summary import summarize
from uniteam.world.task.splits import split_label

LONGEST_EPISODE = 86_400.0 * 7
"""s."""


class LostEpisodesError(UniteamError):
    """Episodes came to nothing by no fault of the agents."""


def evaluate(
    agents: tuple[str, ...] = ("baseline", "uniteam", "uniteam-plus"),
    split: str = "minival",
    perception: str = "learned",
    model: Annotated[str | None, tyro.conf.arg(metavar="ORG/NAME")] = None,
    revision: Annotated[str | None, tyro.conf.arg(metavar="R")] = None,
    episodes: Annotated[int | None, tyro.conf.arg(metavar="N")] = None,
    workers: Annotated[int | None, tyro.conf.arg(metavar="N")] = None,
    camera: Literal["half", "full"] = "half",
    grasp: Literal["challenge", "honest", "arm"] = "challenge",
    out: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None,
    with_: Annotated[tuple[str, ...], tyro.conf.arg(name="with")] = (),
    without: tuple[str, ...] = (),
    breakdown: Annotated[str | None, tyro.conf.arg(metavar="TAG")] = None,
    record: Annotated[str | None, tyro.conf.arg(metavar="all|failures|actions|N")] = None,
    episode_seconds: Annotated[float, tyro.conf.arg(metavar="S")] = 3600.0,
    shard: Annotated[str | None, tyro.conf.arg(metavar="I/N")] = None,
    engine: Literal["processes", "ray"] = "processes",
) -> None:
    """Play a split's episodes with one or more agents, in parallel, and print the challenge's table.

    The results are kept as they come: stop with Ctrl-C and give the same command again to go on. Give it with other
    agents to add rows to the table.

    Args:
        agents: Which agents: names, or your own as MODULE:ATTRIBUTE.
        split: A built-in split (minival, val, test-standard, test-challenge, train), a file of episodes, or
            ovmm:FOLDER for a folder of the challenge's own.
        perception: What the agents see with: learned (colours, depth and words, nothing else), truth (perfect, to find
            out what perception costs), another name, NAME:ARGUMENT for one that takes an argument, or your own as
            MODULE:ATTRIBUTE.
        model: The weights of a detector: ORG/NAME on the Hugging Face hub, or a folder.
        revision: Which commit of the model; give it where results are to be repeated.
        episodes: How many episodes, taken from the homes in turn; all by default.
        workers: How many processes; by default as many as there are cores and memory for.
        camera: Images of 240x320 (half) or of 480x640 (full).
        grasp: What the gripper takes: only a candidate object, as in the challenge, whatever small object the camera
            points at (honest), or what its fingers close around (arm), which needs --with arm_grasp.
        out: Directory of the results; runs/SPLIT-PERCEPTION-CAMERA-GRASP by default, and for a shard its number behind.
        with_: Improvements to add to the agents that lack them: names, or your own as MODULE:ATTRIBUTE.
        without: Improvements to take from the agents that have them, by name.
        breakdown: Add rows by what makes episodes differ: unseen (whether the object's category is in no training
            home), style, area, rooms, shortest_path, least_clearance, object_height, object_pixels, goals, same_class.
        record: Which episodes to record, each into a file of its own below the directory of the results: all, failures
            (those without overall success), or how many of the first ones; actions keeps of all of them the actions
            alone, a few kilobytes each, which is what 'uniteam verify' needs.
        episode_seconds: How long an episode may take; one that takes longer is ended, and fails if it was the agent
            that took so long.
        shard: Play one part of N only, such as 2/4, into a folder of its own: the parts can be played at the same time
            on several machines, and 'uniteam merge' makes one run of them.
        engine: What plays: processes of this machine, or a Ray cluster (ray), that of RAY_ADDRESS or one that runs
            here; --workers is then how many homes are played at a time, by default one for each core of the cluster.
    """
    check_at_least_one(episodes=episodes, workers=workers)
    if not agents:
        raise InvalidInputError("--agents needs at least one name, such as --agents uniteam")
    if not 0.0 < episode_seconds <= LONGEST_EPISODE:
        raise InvalidInputError(f"--episode-seconds must be above 0 and at most a week, got {episode_seconds}")
    perception = perception_name(perception, model, revision)
    console = make_console()
    with console.status("reading the split and the models"):
        labelled = label_agents(agents, perception, with_, without)
        part = None if shard is None else shard_named(shard)
        run = Run(split, labelled, perception, camera, grasp, episodes, episode_seconds, part)
        opened = Evaluation(run, out or default_directory(run))
    with opened as evaluation:
        groups = {} if breakdown is None else grouped(evaluation.wanted, breakdown)
        order = evaluation.recordings(record)
        play_on, count = ENGINES[engine]
        at_once = count(workers, len(evaluation.remaining))
        lost = play_under_bar(evaluation, at_once, console, record=record, engine=play_on)
        evaluation.write_summary()
        tell_results(evaluation, groups, order, console)
    if lost:
        raise LostEpisodesError(lost_sentence(lost, evaluation))


def tell_results(evaluation: Evaluation, groups: Groups, order: RecordingOrder, console: Console) -> None:
    """Print the challenge's table, with a row more for each group of episodes, and say where the files are."""
    console.print(challenge_table(_rows(evaluation, groups), _caption(evaluation), console.width, shown))
    _report(evaluation, console)
    _report_recordings(evaluation, order, console)


def default_directory(run: Run) -> Path:
    """Return the directory of a run that names none."""
    words = (split_label(run.split), as_folder(run.perception), run.camera, run.grasp)
    part = () if run.shard is None else (f"shard-{run.shard.number}-of-{run.shard.count}",)
    return Path("runs") / "-".join((*words, *part))


def check_at_least_one(**counts: int | None) -> None:
    """Raise InvalidInputError where a count that was given is below 1."""
    for name, count in counts.items():
        if count is not None and count < 1:
            raise InvalidInputError(f"--{name} must be at least 1, got {count}")


def worker_count(asked: int | None, jobs: int) -> int:
    """Return how many worker processes to use, and say so where it is fewer than were asked for."""
    room = most_workers()
    count = min(asked or allowed_cores(), room, max(jobs, 1))
    if asked is not None and count < asked and jobs:
        why = f"there are cores and memory for {room}" if count == room else f"{jobs} episodes are to be played"
        make_console(stderr=True).print(f"[yellow]{count} workers instead of {asked}: {why}.[/]", soft_wrap=True)
    return count


def task_count(asked: int | None, jobs: int) -> int:
    """Return how many tasks to give to a cluster at a time: all, where nothing is asked, since it has them wait."""
    return asked or max(jobs, 1)


ENGINES = {"processes": (in_processes, worker_count), "ray": (on_ray, task_count)}
"""By name, what plays a run, and how many attempts at a time."""


def lost_sentence(lost: list[str], evaluation: Evaluation) -> str:
    """Return what became of the episodes that were lost for these reasons."""
    reasons = "; ".join(list(dict.fromkeys(lost))[:3])
    return (
        f"{len(lost)} of the episodes were lost by no fault of the agents ({reasons}); they are not counted, "
        f"{evaluation.store.directory / 'lost.jsonl'} says more, and the same command plays them again"
    )


def _rows(evaluation: Evaluation, groups: Groups) -> dict[str, Row]:
    """Return the table's rows: each agent's, and one for each group of episodes."""
    rows = {}
    for agent, results in evaluation.results().items():
        rows[agent] = Row(summarize(results), len(evaluation.wanted))
        for heading, episodes in groups.items():
            wanted = {episode.id for episode in episodes}
            some = [result for result in results if result.episode in wanted]
            if some:
                rows[f"{agent}, {heading}"] = Row(summarize(some), len(wanted))
    return rows


def _caption(evaluation: Evaluation) -> str:
    run, count = evaluation.run, len(evaluation.wanted)
    episodes = f"{count} episode{'' if count == 1 else 's'}"
    split = f"{evaluation.split.name} (version {evaluation.split.version})"
    words = (
        f"Percent, steps: mean over 95 % interval. Split {split}, perception {run.perception}, "
        f"camera {run.camera}, grasp {run.grasp}, {episodes}, uniteam {uniteam.__version__}."
    )
    return shown(words)


def _report_recordings(evaluation: Evaluation, order: RecordingOrder, console: Console) -> None:
    """Say where the recordings are that were asked for, and which of them there cannot be any more."""
    if not order.episodes:
        return
    asked = [
        order.path(agent, result.episode)
        for agent in evaluation.run.agents
        for result in evaluation.results().get(agent, [])
        if result.episode in order.episodes and order.is_kept(result)
    ]
    sizes = [path.stat().st_size for path in asked if path.is_file()]
    size = f" of {decimal(int(fmean(sizes)))} on average, the largest {decimal(max(sizes))}" if sizes else ""
    console.print(f"Recordings: {len(sizes)}{size}, in {shown(order.folder)}.", soft_wrap=True)
    if len(sizes) < len(asked):
        console.print(
            f"[yellow]{len(asked) - len(sizes)} episodes have results but no recordings: they were played before "
            "without --record, or ended by their time.[/] 'uniteam run --record FILE' records one of them.",
            soft_wrap=True,
        )


def _report(evaluation: Evaluation, console: Console) -> None:
    """Say where the results are, and what went wrong."""
    store = evaluation.store
    results = [result for own in evaluation.results().values() for result in own]
    crashed = sum(result.crashed for result in results)
    if crashed:
        console.print(f"[red]Crashed and counted as failures: {crashed}.[/] Each result's 'traceback' says where.")
    memory = max((result.peak_memory for result in results), default=0.0)
    directory = shown(store.directory)
    console.print(f"Results, configuration and summary: {directory} (a worker used at most {memory:.0f} MB).")
