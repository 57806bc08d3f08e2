"""`uniteam ablate`: what each improvement is worth."""

from collections.abc import Mapping, Sequence
from datetime import timedelta
from pathlib import Path
from typing import Annotated, Literal

import tyro
from rich.console import Console

from uniteam.cli.evaluate import LostEpisodesError, check_at_least_one, default_directory, lost_sentence, worker_count
from uniteam.cli.perceptions import as_folder
from uniteam.cli.progress import Words, counting, play_under_bar
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import DamagedFileError
from uniteam.evaluation.analysis.ablation import MeasuredEffect, measure_effects
from uniteam.evaluation.analysis.ablation_plan import GROUPS, AblationPlan, plan_ablation
from uniteam.evaluation.analysis.ablation_table import WORDS, ablation_markdown, ablation_tables
from uniteam.evaluation.analysis.comparison_table import HEADINGS
from uniteam.evaluation.analysis.page_block import with_block
from uniteam.evaluation.configuration import Run
from uniteam.evaluation.episode_choice import shard_named
from uniteam.evaluation.evaluation import Evaluation
from uniteam.evaluation.results.intervals import Estimate
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.evaluation.results.run_folder import RunFolder, read_run
from uniteam.evaluation.statistics.library import distributions
from uniteam.files import try_output, write_whole
from uniteam.mind.perception.registry import check_ready
from uniteam.visualization.effect_chart import Block, Column, draw_effect_chart
from uniteam.visualization.picture_file import write_png

Group = Literal["whole", "alone", "removed", "ladder", "beyond-added", "beyond-removed"]
Measure = Literal[
    "find_object_phase_success",
    "pick_object_phase_success",
    "find_recep_phase_success",
    "place_success",
    "overall_success",
    "partial_success",
]
FIGURE = "ablation.png"
TITLE = "# What each improvement is worth\n"

_BLOCKS = (("alone", "removed", "ladder"), ("beyond-added", "beyond-removed"))
"""Questions about the same improvements, which stand side by side in the figure."""


def ablate(
    split: str = "val",
    perception: str = "truth",
    episodes: Annotated[int | None, tyro.conf.arg(metavar="N")] = None,
    groups: tuple[Group, ...] = ("whole", "alone", "removed", "ladder", "beyond-added", "beyond-removed"),
    measure: Measure = "overall_success",
    workers: Annotated[int | None, tyro.conf.arg(metavar="N")] = None,
    camera: Literal["half", "full"] = "half",
    grasp: Literal["challenge", "honest", "arm"] = "challenge",
    shard: Annotated[str | None, tyro.conf.arg(metavar="I/N")] = None,
    out: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None,
    docs: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None,
    report_only: Annotated[bool, tyro.conf.FlagCreatePairsOff] = False,
) -> None:
    """Measure what each improvement is worth: all agents of an ablation on the same episodes, compared in pairs.

    One episode is played by all agents before the next, so that a run that is stopped says something of every
    improvement; the same command goes on. The run's folder is one as 'uniteam evaluate' writes it.

    Args:
        split: A built-in split (minival, val, test-standard, test-challenge, train), a file of episodes, or
            ovmm:FOLDER for a folder of the challenge's own.
        perception: What the agents see with, as for evaluate.
        episodes: How many episodes, taken from the homes in turn; all by default.
        groups: What to ask: all at once (whole); each of the report's alone on baseline, taken from uniteam (removed),
            or one after the other (ladder); each beyond the report added to uniteam, or taken from uniteam-plus.
        measure: What tables and figure show; the page has overall and partial success.
        workers: How many processes; by default as many as there are cores and memory for.
        camera: Images of 240x320 (half) or of 480x640 (full).
        grasp: What the gripper takes, as for evaluate.
        shard: Play one part of N only, such as 2/4, into a folder of its own; 'uniteam merge' makes one run of them.
        out: Directory of the results; runs/ablation-SPLIT-PERCEPTION-CAMERA-GRASP by default.
        docs: Page (.md) to write tables and figure into, between marks that are put behind what it holds; each
            perception has marks of its own.
        report_only: Play nothing; say what was played, also while it goes on, or after a merge.
    """
    check_at_least_one(episodes=episodes, workers=workers)
    distributions()  # rather now than after hours
    if docs is not None:
        try_output(docs, (".md",))
    console = make_console()
    with console.status("reading the split and the models"):
        check_ready(perception)
        plan = plan_ablation(perception, groups)
        part = None if shard is None else shard_named(shard)
        run = Run(split, plan.agents, perception, camera, grasp, episodes, shard=part)
        directory = out or _directory(run)
        opened = None if report_only else Evaluation(run, directory)
    lost = "" if opened is None else _played(opened, workers, console)
    _report(plan, read_run(directory), measure, docs, console)
    if lost:
        raise LostEpisodesError(lost)


def _directory(run: Run) -> Path:
    usual = default_directory(run)
    return usual.with_name(f"ablation-{usual.name}")


def _played(opened: Evaluation, workers: int | None, console: Console) -> str:
    """Play what remains, and return what became of episodes that were lost."""
    with opened as evaluation:
        console.print(_cost(evaluation), soft_wrap=True)
        count = worker_count(workers, len(evaluation.remaining))
        lost = play_under_bar(evaluation, count, console, _counting_rounds, lambda episode: episode.id)
        evaluation.write_summary()
        return lost_sentence(lost, evaluation) if lost else ""


def _cost(evaluation: Evaluation) -> str:
    """Return how much there is to play, and how long it takes where that is known."""
    agents, episodes, left = len(evaluation.run.agents), len(evaluation.wanted), len(evaluation.remaining)
    words = f"{agents} agents on {episodes} episodes, {left} attempts to play."
    seconds = [result.seconds for own in evaluation.results().values() for result in own if not result.crashed]
    if not seconds or not left:
        return words
    mean = sum(seconds) / len(seconds)
    return f"{words} At {mean:.1f} s each, as so far, that is {timedelta(seconds=round(left * mean))} of one process."


def _counting_rounds(evaluation: Evaluation) -> Words:
    """Return the words that count the episodes which all agents have played."""
    left = {episode.id: 0 for episode in evaluation.wanted}
    for attempt in evaluation.remaining:
        left[evaluation.split.episodes[attempt.episode].id] += 1

    def after(agent: str, result: EpisodeResult) -> str:
        left[result.episode] -= 1
        return f"{sum(not count for count in left.values())} of {len(left)} episodes played by all"

    return after


def _report(plan: AblationPlan, run: RunFolder, measure: Measure, docs: Path | None, console: Console) -> None:
    with counting(console, "comparing", len(plan.effects)) as count:
        measured = measure_effects(plan.effects, run.results, count)
    if not measured:
        raise DamagedFileError(f"no two agents in '{run.directory}' have played the same episode; play some first")
    told = _told(run)
    title = f"{HEADINGS[measure]} success: what each improvement is worth"
    picture = draw_effect_chart(title, _blocks(measured, measure), told)
    figure = (
        run.directory / FIGURE if docs is None else docs.with_name(f"{docs.stem}-{as_folder(_perception(run))}.png")
    )
    write_png(figure, picture)
    if docs is not None:
        page = docs.read_text() if docs.is_file() else TITLE
        block = (
            f"{told}\n\n{WORDS}\n\n![What each improvement is worth]({figure.name})\n\n{ablation_markdown(measured)}"
        )
        write_whole(docs, with_block(page, f"ablation: {_perception(run)}", block).encode())
    for table in ablation_tables(measured, measure):
        console.print(table)
        console.print()
    console.print(f"{shown(WORDS)} {shown(told)}")
    console.print(f"Figure: {shown(figure)}" + (f"; page: {shown(docs)}" if docs else ""), soft_wrap=True)


def _perception(run: RunFolder) -> str:
    return str(run.configuration["perception"])


def _told(run: RunFolder) -> str:
    """Return what the figures are from."""
    told = run.configuration
    counts = sorted({len(own) for own in run.results.values()})
    played = f"{counts[0]}" if len(counts) == 1 else f"{counts[0]} to {counts[-1]}"
    split = f"{told['split']} (version {told['split_version']})"
    return (
        f"{len(run.results)} agents, {played} episodes each of split {split}, perception {told['perception']}, "
        f"camera {told['camera']}, grasp {told['grasp']}, uniteam {told['version']}, code {told['code']}."
    )


def _blocks(measured: Mapping[str, Sequence[MeasuredEffect]], measure: str) -> list[Block]:
    blocks = []
    for groups in _BLOCKS:
        there = [group for group in groups if group in measured]
        rows = dict.fromkeys(effect.effect.improvement for group in there for effect in measured[group])
        if there:
            blocks.append(Block(tuple(rows), [_column(group, measured[group], measure) for group in there]))
    return blocks


def _column(group: str, effects: Sequence[MeasuredEffect], measure: str) -> Column:
    points, is_shown = {}, set()
    for effect in effects:
        found = effect.comparison.measures[measure]
        low, mean, high = (100.0 * v for v in (found.difference.low, found.difference.mean, found.difference.high))
        points[effect.effect.improvement] = Estimate(mean, low, high)
        is_shown |= {effect.effect.improvement} if found.is_shown else set()
    return Column(GROUPS[group], points, frozenset(is_shown))
