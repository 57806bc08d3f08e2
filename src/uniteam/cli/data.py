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

    The data are HomeRobot's episodes, HSSD's scenes and the objects, in HomeRobot's layout, or a file of ProcTHOR's
    houses, which you bring yourself; docs/official-data.md says from where.

    Args:
        action: What to do.
        folder: A folder with episodes.json.gz, or one above such folders; or a file of houses, such as val.jsonl.gz.
    """
    if folder.is_file():
        _check_houses(folder)
        return
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


def _check_houses(path: Path) -> None:
    """Say what of a file of ProcTHOR's houses can be read."""
    from uniteam.world.generation.procthor_homes import counted
    from uniteam.world.homes.readers.procthor.survey import survey_houses

    console = make_console()
    with console.status("reading the houses"):
        found = survey_houses(path)

    def say(kind: str, sentence: str) -> None:
        console.print(f"  {_WORDS[kind]}{' ' * (_COLUMN - len(kind))}{shown(sentence)}", soft_wrap=True)

    console.print(f"[bold]{shown(path)}[/]", soft_wrap=True)
    say("there", f"{found.houses} houses; the first {found.looked_at} were read.")
    if not found.has_sizes:
        say("missing", "asset-database.json beside it: stand-ins are chosen by their heights alone.")
    say("there", f"{found.stood} things stand in them, models of the package in the places of theirs.")
    for reason, counts in (("have no like here", found.unknown), ("found no place", found.no_place)):
        if counts:
            say("odd", f"{reason}, and are left out: {counted(counts)}.")
    if found.faults:
        say("odd", f"{len(found.faults)} houses cannot be read; the first: {next(iter(found.faults.values()))}")
    if len(found.faults) == found.looked_at:
        raise UniteamError(f"no house of {path} can be read: {next(iter(found.faults.values()), 'it holds none')}")
    console.print(f"Draw one with: uniteam home 0 --source procthor:{shown(path)}", soft_wrap=True)
