"""`uniteam dial`: success against the noise of perception."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, Literal

import tyro
from rich.console import Console

import uniteam
from uniteam.cli.evaluate import LostEpisodesError, check_at_least_one, lost_sentence, worker_count
from uniteam.cli.perceptions import as_folder
from uniteam.cli.progress import play_under_bar
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.evaluation.agent_spec import label_agents
from uniteam.evaluation.analysis.table import Row, challenge_table
from uniteam.evaluation.configuration import Run
from uniteam.evaluation.evaluation import Evaluation
from uniteam.evaluation.results.intervals import Estimate
from uniteam.evaluation.results.summary import Summary
from uniteam.files import try_output, write_json
from uniteam.mind.perception.noise.noisy import noisy_of
from uniteam.visualization.captions import MILESTONES
from uniteam.visualization.picture_file import write_png
from uniteam.visualization.success_chart import Curve, draw_success_chart
from uniteam.world.task.splits import load_split, split_label

Measure = Literal[
    "find_object_phase_success",
    "pick_object_phase_success",
    "find_recep_phase_success",
    "place_success",
    "overall_success",
]
FIGURE, FIGURES = "dial.png", "dial.json"


@dataclass(frozen=True)
class Point:
    """An agent's figures with one perception; `level` is its noise, None for one that is not on the dial."""

    agent: str
    perception: str
    level: float | None
    summary: Summary


def dial(
    agents: tuple[str, ...] = ("baseline", "uniteam-plus"),
    split: str = "minival",
    levels: tuple[float, ...] = (0.0, 0.25, 0.5, 0.75, 1.0),
    episodes: Annotated[int | None, tyro.conf.arg(metavar="N")] = None,
    workers: Annotated[int | None, tyro.conf.arg(metavar="N")] = None,
    camera: Literal["half", "full"] = "half",
    grasp: Literal["challenge", "honest", "arm"] = "challenge",
    measure: Measure = "overall_success",
    beside: tuple[str, ...] = (),
    out: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None,
) -> None:
    """Play a split at several levels of perception's noise, print the table, and draw success against noise.

    At level 0 perception is the truth, at level 1 it errs about as a published detector does. Each level is a run of
    its own in a folder of DIR, with the perception noisy:LEVEL: stop with Ctrl-C and give the same command again to go
    on, or give it with more levels or agents, and what was played is not played again.

    Args:
        agents: Which agents: names, or your own as MODULE:ATTRIBUTE.
        split: A built-in split (minival, val, test-standard, test-challenge, train), a file of episodes, or
            ovmm:FOLDER for a folder of the challenge's own.
        levels: Levels of noise, from 0 to 1.
        episodes: How many episodes, taken from the homes in turn; all by default.
        workers: How many processes; by default as many as there are cores and memory for.
        camera: Images of 240x320 (half) or of 480x640 (full).
        grasp: What the gripper takes: only a candidate object, as in the challenge, whatever small object the camera
            points at (honest), or what its fingers close around (arm), which needs --with arm_grasp.
        measure: What the figure shows.
        beside: Other perceptions to play with, drawn as level lines: where one crosses an agent's curve is the noise
            that costs that agent as much.
        out: Directory of the results; runs/dial-SPLIT-CAMERA-GRASP by default.
    """
    check_at_least_one(episodes=episodes, workers=workers)
    if not agents or not levels:
        raise InvalidInputError("--agents and --levels need at least one each, such as --agents baseline --levels 0 1")
    asked = sorted({float(f"{noisy_of(str(level)).level:g}") for level in levels})
    perceptions = {f"noisy:{level:g}": level for level in asked} | dict.fromkeys(beside)
    console = make_console()
    with console.status("reading the split and the models"):
        for perception in perceptions:
            for spec in label_agents(agents, perception).values():
                spec.describe()  # raises for an unknown name, before anything is played
        load_split(split)
    directory = out or Path("runs") / f"dial-{split_label(split)}-{camera}-{grasp}"
    try_output(directory / FIGURE)
    points, lost, count = list[Point](), list[str](), 0
    for number, (perception, level) in enumerate(perceptions.items(), start=1):
        console.print(f"Perception {shown(perception)} ({number} of {len(perceptions)})")
        run = Run(split, label_agents(agents, perception), perception, camera, grasp, episodes)
        summaries, count, sentence = _played(run, directory / as_folder(perception), workers, console)
        lost += filter(None, [sentence])
        points += [Point(agent, perception, level, summary) for agent, summary in summaries.items()]
    caption = (
        f"Split {split}, {count} episodes, camera {camera}, grasp {grasp}, "
        f"uniteam {uniteam.__version__}; 95 % intervals."
    )
    rows = {f"{point.agent}, {point.perception}": Row(point.summary, count) for point in points}
    console.print(challenge_table(rows, shown(f"Percent, steps: mean over interval. {caption}"), console.width, shown))
    _write(points, directory, measure, caption)
    console.print(f"Figure: {shown(directory / FIGURE)}; figures: {shown(directory / FIGURES)}", soft_wrap=True)
    if lost:
        raise LostEpisodesError("; ".join(lost))


def _played(run: Run, directory: Path, workers: int | None, console: Console) -> tuple[Mapping[str, Summary], int, str]:
    """Play what remains of a run; return each agent's figures, of how many episodes, and what became of lost ones."""
    with Evaluation(run, directory) as evaluation:
        lost = play_under_bar(evaluation, worker_count(workers, len(evaluation.remaining)), console)
        evaluation.write_summary()
        return evaluation.summaries(), len(evaluation.wanted), lost_sentence(lost, evaluation) if lost else ""


def _write(points: Sequence[Point], directory: Path, measure: str, caption: str) -> None:
    """Write the figures as data and as a picture; raises UnwritableError."""
    data: list[dict[str, Any]] = [
        {"agent": p.agent, "perception": p.perception, "level": p.level, **p.summary.to_data()} for p in points
    ]
    write_json(directory / FIGURES, {"caption": caption, "points": data})
    picture = draw_success_chart(f"{MILESTONES[measure]}, percent of the episodes", _curves(points, measure), caption)
    write_png(directory / FIGURE, picture)


def _curves(points: Sequence[Point], measure: str) -> list[Curve]:
    """Return a line for each agent over the levels, and a level one for each perception beside them."""
    by_level: dict[str, list[tuple[float, Estimate]]] = {}
    beside = []
    for point in points:
        estimate = point.summary.estimates[measure]
        if point.level is None:
            beside.append(Curve(f"{point.agent}, {point.perception}", [(0.0, estimate), (1.0, estimate)]))
        else:
            by_level.setdefault(point.agent, []).append((point.level, estimate))
    return [*(Curve(agent, line) for agent, line in by_level.items()), *beside]
