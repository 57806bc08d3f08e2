"""`uniteam dial`: success against the noise of perception."""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, Literal

import tyro
from rich.console import Console

import uniteam
from uniteam.cli.evaluate import LostEpisodesError, check_at_least_one, lost_sentence, worker_count
from uniteam.cli.progress import play_under_bar
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.evaluation.agent_spec import label_agents
from uniteam.evaluation.analysis.table import Row, challenge_table
from uniteam.evaluation.configuration import Run
from uniteam.evaluation.evaluation import Evaluation
from uniteam.evaluation.results.summary import Summary
from uniteam.files import try_output, write_whole
from uniteam.mind.perception.noise.noisy import noisy_of
from uniteam.visualization.captions import MILESTONES
from uniteam.visualization.picture_file import write_png
from uniteam.visualization.success_chart import curves_of, draw_success_chart
from uniteam.world.task.splits import load_split

Measure = Literal[
    "find_object_phase_success",
    "pick_object_phase_success",
    "find_recep_phase_success",
    "place_success",
    "overall_success",
]
Figures = dict[str, dict[float, Summary]]
"""By agent, then by level."""


def dial(
    agents: tuple[str, ...] = ("baseline", "uniteam-plus"),
    split: str = "minival",
    levels: tuple[float, ...] = (0.0, 0.25, 0.5, 0.75, 1.0),
    episodes: Annotated[int | None, tyro.conf.arg(metavar="N")] = None,
    workers: Annotated[int | None, tyro.conf.arg(metavar="N")] = None,
    camera: Literal["half", "full"] = "half",
    grasp: Literal["challenge", "honest"] = "challenge",
    measure: Measure = "overall_success",
    out: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None,
) -> None:
    """Play a split at several levels of perception's noise, print the table, and draw success against noise.

    At level 0 perception is the truth, at level 1 it errs as a published detector does. Each level is a run of its own
    in a folder of DIR, with the perception noisy:LEVEL: stop with Ctrl-C and give the same command again to go on, or
    give it with more levels or agents, and what was played is not played again.

    Args:
        agents: Which agents: names, or your own as MODULE:ATTRIBUTE.
        split: A built-in split (minival, val, test-standard, test-challenge, train) or a file of episodes.
        levels: Levels of noise, from 0 to 1.
        episodes: How many episodes, taken from the homes in turn; all by default.
        workers: How many processes; by default as many as there are cores and memory for.
        camera: Images of 240x320 (half) or of 480x640 (full).
        grasp: What the gripper takes: only a candidate object, as in the challenge, or whatever small object the camera
            points at (honest).
        measure: What the figure shows.
        out: Directory of the results; runs/dial-SPLIT-CAMERA-GRASP by default.
    """
    check_at_least_one(episodes=episodes, workers=workers)
    if not agents or not levels:
        raise InvalidInputError("--agents and --levels need at least one each, such as --agents baseline --levels 0 1")
    asked = sorted({float(f"{noisy_of(str(level)).level:g}") for level in levels})
    console = make_console()
    with console.status("reading the split and the models"):
        label_agents(agents, "truth")
        load_split(split)
    directory = out or Path("runs") / f"dial-{Path(split).name.split('.')[0]}-{camera}-{grasp}"
    picture = directory / "dial.png"
    try_output(picture)
    figures, lost, count = Figures(), list[str](), 0
    for number, level in enumerate(asked, start=1):
        console.print(f"Level {level:g} ({number} of {len(asked)})")
        perception = f"noisy:{level:g}"
        run = Run(split, label_agents(agents, perception), perception, camera, grasp, episodes)
        summaries, count, sentence = _played(run, directory / f"noisy-{level:g}", workers, console)
        lost += filter(None, [sentence])
        for agent, summary in summaries.items():
            figures.setdefault(agent, {})[level] = summary
    caption = (
        f"Split {split}, {count} episodes, perception noisy, camera {camera}, grasp {grasp}, "
        f"uniteam {uniteam.__version__}; 95 % intervals."
    )
    _report(figures, count, caption, console)
    _write(figures, directory, measure, caption)
    console.print(f"Figure: {shown(picture)}; figures: {shown(directory / 'dial.json')}", soft_wrap=True)
    if lost:
        raise LostEpisodesError("; ".join(lost))


def _played(run: Run, directory: Path, workers: int | None, console: Console) -> tuple[Mapping[str, Summary], int, str]:
    """Play what remains of a level; return each agent's figures, of how many episodes, and what became of lost ones."""
    with Evaluation(run, directory) as evaluation:
        lost = play_under_bar(evaluation, worker_count(workers, len(evaluation.remaining)), console)
        evaluation.write_summary()
        return evaluation.summaries(), len(evaluation.wanted), lost_sentence(lost, evaluation) if lost else ""


def _report(figures: Figures, count: int, caption: str, console: Console) -> None:
    rows = {
        f"{agent}, noise {level:g}": Row(summary, count)
        for agent, by_level in figures.items()
        for level, summary in sorted(by_level.items())
    }
    console.print(challenge_table(rows, shown(f"Percent, steps: mean over interval. {caption}"), console.width, shown))


def _write(figures: Figures, directory: Path, measure: str, caption: str) -> None:
    """Write `dial.json` and `dial.png`; raises UnwritableError."""
    data: dict[str, Any] = {
        agent: [{"level": level, **summary.to_data()} for level, summary in sorted(by_level.items())]
        for agent, by_level in figures.items()
    }
    write_whole(directory / "dial.json", (json.dumps({"caption": caption, "agents": data}, indent=2) + "\n").encode())
    estimates = {
        agent: {level: summary.estimates[measure] for level, summary in by_level.items()}
        for agent, by_level in figures.items()
    }
    title = f"{MILESTONES[measure]}, percent of the episodes"
    write_png(directory / "dial.png", draw_success_chart(title, curves_of(estimates), caption))
