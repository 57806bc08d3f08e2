"""`uniteam train`: the networks of perception `learned`, from nothing."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import Annotated, Literal

import tyro
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn
from rich.table import Table

from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.files import try_folder

MOST_HOMES, MOST_STEPS = 4_000, 10_000_000


def train(
    part: Annotated[Literal["segmenter", "namer", "calibration", "thresholds"], tyro.conf.Positional],
    work: Annotated[Path, tyro.conf.arg(metavar="DIR")] = Path("training"),
    homes: Annotated[int, tyro.conf.arg(metavar="N")] = 200,
    proposal_homes: Annotated[int, tyro.conf.arg(metavar="N")] = 40,
    steps: Annotated[int, tyro.conf.arg(metavar="N")] = 20_000,
    start: Annotated[str, tyro.conf.arg(metavar="WEIGHTS")] = "imagenet",
    library: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None,
    camera: Literal["half", "full"] = "half",
) -> None:
    """Make a network of perception `learned`: render views of training homes, train, judge, and write it.

    What is made is kept: stop with Ctrl-C, and the same command goes on. Train the segmenter first, then the namer,
    which learns from the segmenter's mistakes too, then fit the calibration, then the thresholds. The networks are in
    DIR/weights; see them at work with: uniteam perception --weights DIR/weights

    Args:
        part: What to make.
        work: Folder of views, checkpoints, logs and networks.
        homes: How many training homes to render 60 views of; for the calibration, to look at; for the thresholds, how
            many episodes to play.
        proposal_homes: In how many more homes the segmenter makes proposals for the namer to learn from.
        steps: How many steps to train, of 4 frames or 32 crops each.
        start: What to begin with: imagenet, shipped (the networks of this package), or a folder of networks.
        library: Folder of models that the training homes not yet rendered are made of; the pack where it is left out.
        camera: Of the calibration and the thresholds, images of 240x320 (half) or of 480x640 (full).
    """
    _check(homes, proposal_homes, steps)
    try_folder(work)
    console = make_console()
    if part == "calibration":
        from uniteam.cli.calibrate import calibrate

        calibrate(work, homes, camera, console)
        return
    if part == "thresholds":
        from uniteam.cli.fit_thresholds import fit_thresholds

        fit_thresholds(work, homes, camera, console)
        return
    pipeline = _pipeline()
    from uniteam.training.start import start_folder
    from uniteam.world.assets.catalogue import load_library

    models = load_library(library) if library is not None else None
    order = pipeline.Order(work, homes, proposal_homes, steps, start_folder(start), models)
    make = pipeline.make_segmenter if part == "segmenter" else pipeline.make_namer
    with progress_of(console) as advance:
        figures = make(order, advance)
    _print_figures(figures, console)
    console.print(f"The network and its card: {shown(order.weights)}", soft_wrap=True)


def _check(homes: int, proposal_homes: int, steps: int) -> None:
    if not 1 <= homes <= MOST_HOMES:
        raise InvalidInputError(f"--homes must be from 1 to {MOST_HOMES}, got {homes}")
    if not 0 <= proposal_homes <= MOST_HOMES:
        raise InvalidInputError(f"--proposal-homes must be from 0 to {MOST_HOMES}, got {proposal_homes}")
    if not 1 <= steps <= MOST_STEPS:
        raise InvalidInputError(f"--steps must be from 1 to {MOST_STEPS}, got {steps}")


def _pipeline() -> ModuleType:
    from importlib.util import find_spec

    lacking = [name for name in ("torch", "onnx") if find_spec(name) is None]
    if lacking:
        raise InvalidInputError(f"training needs {' and '.join(lacking)}: pip install 'uniteam[train]'")
    from uniteam.training import pipeline

    return pipeline


@contextmanager
def progress_of(console: Console) -> Iterator["Advance"]:
    """Show a bar for each thing that is done, one after the other."""
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console, speed_estimate_period=300.0) as progress:
        yield Advance(progress)


class Advance:
    """Moves the bars of a progress display."""

    def __init__(self, progress: Progress) -> None:
        """Take the display."""
        self._progress = progress
        self._bars: dict[str, int] = {}

    def __call__(self, what: str, done: int, total: int) -> None:
        """Say how much of something is done."""
        key = what.split(",")[0]
        if key not in self._bars:
            self._bars[key] = self._progress.add_task(what, total=total)
        self._progress.update(self._bars[key], completed=done, description=what)  # type: ignore[arg-type]


def _print_figures(figures: Mapping[str, float], console: Console) -> None:
    table = Table("held out", "value", box=None)
    for name, value in figures.items():
        table.add_row(name, f"{value:.3f}")
    console.print(table)
