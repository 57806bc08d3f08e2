"""`uniteam episodes`: certified episodes of a user's own, in a file that `--split` plays."""

from pathlib import Path
from typing import Annotated

import tyro

from uniteam.cli.home import Style
from uniteam.cli.progress import counting
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.files import try_output

MOST_HOMES, MOST_EPISODES = 100_000, 1_000


def episodes(
    homes: str,
    out: Path,
    per_home: Annotated[int, tyro.conf.arg(metavar="N")] = 5,
    source: str = "test",
    style: Style = "tidy",
) -> None:
    """Generate homes and certified episodes in them, and write both as a split.

    Every episode is kept as it is made: where the command is interrupted, the same command goes on from there.

    Args:
        homes: seeds of the homes, as "9000:9010" (the last excluded) or "9000".
        out: the file to write; its name ends in .jsonl.gz.
        per_home: episodes wanted in each home.
        source: what makes the homes: "test" for models kept from training, "train" for the others, a function of
            your own, "my_homes:lofts", or the houses of a file of ProcTHOR, "procthor:val.jsonl.gz", of which the
            seeds are the numbers.
        style: "tidy" homes as a robot would like them, or "lived_in" ones as people leave them; not for a function of
            your own.
    """
    from uniteam.world.certification.growing_split import GrowingSplit, grow
    from uniteam.world.generation.registry import HOMES, home_of_seed, source_name, style_name
    from uniteam.world.homes.home import Home
    from uniteam.world.task.splits import SUFFIX

    seeds = _seeds(homes)
    if not 1 <= per_home <= MOST_EPISODES:
        raise InvalidInputError(f"--per-home must be from 1 to {MOST_EPISODES}, got {per_home}")
    make = source_name(source, style)
    HOMES.get(make)
    try_output(out, (SUFFIX,))
    console = make_console()
    growing = GrowingSplit(out, (make, seeds, per_home), style_name(make))
    short: list[str] = []
    with counting(console, "homes", len(seeds)) as advance:

        def on_home(home: Home, count: int) -> None:
            if count < per_home:
                short.append(f"{home.name} offers {count}")
            advance()

        try:
            grow(growing, (home_of_seed(make, seed) for seed in seeds), per_home, on_home)
        except BaseException:
            if growing.split.episodes:
                kept = f"{len(growing.split.episodes)} episodes so far are kept in {shown(growing.partial)}"
                console.print(f"{kept}, which --split plays; the same command goes on from there.", soft_wrap=True)
            raise
    split = growing.split
    if not split.episodes:
        raise InvalidInputError(f"no episode could be certified in the homes {homes}; try other seeds")
    growing.finish()
    unseen = sum(episode.unseen for episode in split.episodes)
    counts = f"{len(split.episodes)} episodes in {len(split.homes)} homes, {unseen} of unseen categories"
    console.print(f"{counts}: {shown(out)}", soft_wrap=True)
    if growing.proposals.total:
        console.print(". ".join(growing.proposals.lines()) + ".", soft_wrap=True)
    if short:
        console.print(f"Fewer than {per_home} were found in some homes: {shown(', '.join(short))}.")
    console.print(f"Play them with: uniteam evaluate --split {shown(out)}", soft_wrap=True)


def _seeds(homes: str) -> range:
    first, _, last = homes.partition(":")
    try:
        seeds = range(int(first), int(last) if last else int(first) + 1)
        count = len(seeds)
    except (ValueError, OverflowError):
        count = 0
    if count == 0 or seeds[0] < 0 or count > MOST_HOMES:
        raise InvalidInputError(
            f"--homes must be seeds such as 9000:9010 or 9000, {MOST_HOMES} at most, got '{homes[:100]}'"
        )
    return seeds
