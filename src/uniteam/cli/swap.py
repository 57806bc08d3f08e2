"""`uniteam swap`: one module at a time replaced by the truth."""

from pathlib import Path
from typing import Annotated, Literal

import tyro

from uniteam.cli.evaluate import LostEpisodesError, check_at_least_one, default_directory, lost_sentence, worker_count
from uniteam.cli.progress import play_under_bar
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.evaluation.analysis.swap_effects import measure_swaps, swap_table
from uniteam.evaluation.analysis.swap_plan import plan_swaps
from uniteam.evaluation.configuration import Run
from uniteam.evaluation.evaluation import Evaluation
from uniteam.evaluation.results.run_folder import read_run
from uniteam.evaluation.statistics.library import distributions
from uniteam.mind.perception.registry import check_ready

Module = Literal["perception", "map", "exploration", "navigation", "pick", "place"]


def swap(
    agents: tuple[str, ...] = ("uniteam-plus",),
    split: str = "val",
    modules: tuple[Module, ...] = ("map", "exploration", "navigation", "pick", "place"),
    perception: str = "truth",
    episodes: Annotated[int | None, tyro.conf.arg(metavar="N")] = None,
    workers: Annotated[int | None, tyro.conf.arg(metavar="N")] = None,
    camera: Literal["half", "full"] = "half",
    out: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None,
    report_only: Annotated[bool, tyro.conf.FlagCreatePairsOff] = False,
) -> None:
    """Replace one module at a time by the truth, and count the failures that this heals, on the same episodes.

    A module that heals few failures is not where research pays. One episode is played by all before the next; the run's
    folder is one as 'uniteam evaluate' writes it, and the same command goes on.

    Args:
        agents: Which agents: names, or a configuration of your own as MODULE:ATTRIBUTE.
        split: A built-in split (minival, val, test-standard, test-challenge, train) or a file of episodes.
        modules: What to replace: perception (of --perception learned or another), map (the true obstacles, as far as
            the agent has seen), exploration (it is told where object and goal receptacles are), navigation (true paths
            and exact motions), pick (once the robot is at the object, it is grasped as the episode's certificate says),
            place (likewise).
        perception: What the agents see with, as for evaluate.
        episodes: How many episodes, taken from the homes in turn; all by default.
        workers: How many processes; by default as many as there are cores and memory for.
        camera: Images of 240x320 (half) or of 480x640 (full).
        out: Directory of the results; runs/swap-SPLIT-PERCEPTION-CAMERA-GRASP by default.
        report_only: Play nothing; say what was played, also while it goes on.
    """
    check_at_least_one(episodes=episodes, workers=workers)
    if not agents or not modules:
        raise InvalidInputError("--agents and --modules need at least one name each, such as --modules pick place")
    distributions()  # rather now than after hours
    console = make_console()
    with console.status("reading the split and the models"):
        check_ready(perception)
        plan = plan_swaps(agents, perception, modules)
        run = Run(split, plan.agents, perception, camera, episode_count=episodes)
        usual = default_directory(run)
        directory = out or usual.with_name(f"swap-{usual.name}")
        opened = None if report_only else Evaluation(run, directory)
    lost = ""
    if opened is not None:
        with opened as evaluation:
            count = worker_count(workers, len(evaluation.remaining))
            reasons = play_under_bar(evaluation, count, console, group_of=lambda episode: episode.id)
            evaluation.write_summary()
            lost = lost_sentence(reasons, evaluation) if reasons else ""
    played = read_run(directory)
    effects = measure_swaps(plan.swaps, played.results)
    if not effects:
        raise DamagedFileError(f"no two agents in '{directory}' have played the same episode; play some first")
    console.print(swap_table(effects))
    console.print(
        f"Split {shown(split)}, perception {shown(perception)}; results in {shown(directory)}.", soft_wrap=True
    )
    if lost:
        raise LostEpisodesError(lost)
