"""`uniteam data`: whether a folder of the challenge's own data can be played."""

from pathlib import Path
from typing import Annotated, Literal

import tyro

from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError, UniteamError

_WORDS = {"there": "[green]there[/]", "missing": "[red]missing[/]", "cost": "[cyan]costs[/]", "odd": "[yellow]odd[/]"}
_COLUMN = 9


def data(
    action: Annotated[Literal["check"], tyro.conf.Positional],
    folder: Annotated[Path, tyro.conf.Positional, tyro.conf.arg(metavar="DIR")],
) -> None:
    """Say what of the challenge's data is in a folder, what is missing, what it costs in memory, and what does not fit.

    The data are HomeRobot's episodes, HSSD's scenes and the objects, in HomeRobot's layout, which you bring yourself;
    docs/official-data.md says from where.

    Args:
        action: What to do.
        folder: A folder with episodes.json.gz, or one above such folders.
    """
    from uniteam.world.task.ovmm.data_check import check_episodes, episode_folders

    console = make_console()
    folders = episode_folders(folder)
    if not folders:
        raise InvalidInputError(
            f"there is no episodes.json.gz in or below {folder}; give the folder of a split, such as "
            "data/datasets/ovmm/val, and see docs/official-data.md for what belongs there"
        )
    first = None
    for found in folders:
        console.print(f"[bold]{shown(found)}[/]", soft_wrap=True)
        is_whole = True
        with console.status("reading the data"):
            for finding in check_episodes(found):
                word = _WORDS[finding.kind] + " " * (_COLUMN - len(finding.kind))
                console.print(f"  {word}{shown(finding.sentence)}", soft_wrap=True)
                if finding.is_fatal:
                    is_whole, first = False, first or finding.sentence
        if is_whole:
            console.print(f"Play it with: uniteam evaluate --split ovmm:{shown(found)}\n", soft_wrap=True)
    if first is not None:
        raise UniteamError(f"the data cannot be played as they are: {first}")
