"""`uniteam perception`: what perception `learned` finds and names in the homes of a split."""

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Literal

import tyro
from rich.console import Console
from rich.table import Table

from uniteam.cli.progress import counting
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.files import try_folder, try_output, write_whole

MOST_VIEWS = 10_000


def perception(
    model: Literal["learned"] = "learned",
    split: str = "val",
    homes: Annotated[int, tyro.conf.arg(metavar="N")] = 40,
    views: Annotated[int, tyro.conf.arg(metavar="N")] = 25,
    camera: Literal["half", "full"] = "half",
    weights: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None,
    out: Annotated[Path | None, tyro.conf.arg(metavar="FILE.md")] = None,
    pictures: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None,
) -> None:
    """Measure a perception on views of a split's homes, and print what it is worth.

    In each view it is asked for every category of object of the home, and for every receptacle. The homes of the
    test splits and of val hold models that no network has seen; `--split seen-instances` takes fresh training homes.

    Args:
        model: Which perception.
        split: A built-in split (val, ...), a file of episodes, or seen-instances.
        homes: In how many of its homes; the first.
        views: Of each home.
        camera: Images of 240x320 (half) or of 480x640 (full), from which things are named.
        weights: Folder of networks of your own, as "uniteam train" writes it; the package's where none is given.
        out: A file (.md) to write the tables into.
        pictures: A folder for the three views of which most, and the three of which least, was named rightly, each
            beside what it was taken for; behind a wrong name stands what it is.
    """
    if not 1 <= views <= MOST_VIEWS or homes < 1:
        raise InvalidInputError(f"--homes must be at least 1 and --views from 1 to {MOST_VIEWS}, got {homes}, {views}")
    if out is not None:
        try_output(out, (".md",))
    if pictures is not None:
        try_folder(pictures)
    from uniteam.evaluation.worker import camera_named
    from uniteam.mind.perception.learned.asking import Asking
    from uniteam.mind.perception.learned.networks import WEIGHTS, read_card
    from uniteam.mind.perception.words.meaning import load_words
    from uniteam.training.example_views import ExampleViews, ignore_look
    from uniteam.training.report import as_markdown, homes_with_seen_instances, tables, watch
    from uniteam.world.task.splits import load_split

    console = make_console()
    with console.status("making the homes"):
        chosen = (
            homes_with_seen_instances(homes) if split == "seen-instances" else list(load_split(split).homes.values())
        )
    chosen = chosen[:homes]
    folder = weights or WEIGHTS
    examples = None if pictures is None else ExampleViews(Asking(read_card(folder), load_words()))
    with counting(console, "homes", len(chosen)) as advance:
        watched = watch(chosen, folder, camera_named(camera), views, advance, examples or ignore_look)
    measured = tables(watched)
    _show(measured, console)
    if out is not None:
        title = f"Perception {model}, {len(chosen)} homes of {split}, {views} views of each, camera {camera}.\n\n"
        write_whole(out, (title + as_markdown(measured)).encode())
        console.print(f"Written: {shown(out)}", soft_wrap=True)
    if examples is not None and pictures is not None:
        written = examples.write(pictures)
        console.print(f"Written: {len(written)} pictures in {shown(pictures)}", soft_wrap=True)


def _show(measured: Mapping[str, list[tuple[str, ...]]], console: Console) -> None:
    for title, (head, *rows) in measured.items():
        table = Table(*head, title=title, title_justify="left")
        for row in rows:
            table.add_row(*(shown(cell) for cell in row))
        console.print(table)
