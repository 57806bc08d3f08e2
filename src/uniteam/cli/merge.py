"""`uniteam merge`: one run of the shards of a run."""

from pathlib import Path
from typing import Annotated

import tyro

from uniteam.cli.terminal import make_console, shown
from uniteam.errors import UniteamError
from uniteam.evaluation.recording.bring_recordings import bring_recordings
from uniteam.evaluation.results.merge import merge_shards


class IncompleteRunError(UniteamError):
    """A run of which something has not been played."""


def merge(
    shards: Annotated[tuple[Path, ...], tyro.conf.Positional, tyro.conf.arg(metavar="DIR")],
    out: Annotated[Path, tyro.conf.arg(metavar="DIR")],
) -> None:
    """Make one run of the shards of a run, equal to the one that would have been played without --shard.

    The shards must have one configuration and no episode in common. What is missing is told, and the command then ends
    with exit code 2; the folder holds what there is, and 'uniteam evaluate --out DIR' with the run's other options
    plays the rest in it. Recordings come along, as hard links where the disk is the same.

    Args:
        shards: Folders that 'uniteam evaluate --shard' or 'uniteam ablate --shard' wrote.
        out: Folder for the whole run; it must not exist, or be empty.
    """
    merged = merge_shards(shards, out, bring_recordings)
    console = make_console()
    console.print(f"{merged.attempts} results of {len(shards)} shards are in {shown(out)}.", soft_wrap=True)
    if merged.missing:
        raise IncompleteRunError(f"'{out}' is not complete, since these are missing: {'; '.join(merged.missing)}")
