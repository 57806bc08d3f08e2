"""`uniteam episodes`: certified episodes of a user's own, in a file that `--split` plays."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Literal

import tyro
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from uniteam.errors import InvalidInputError
from uniteam.world.homes.home import Home


def episodes(
    homes: str,
    out: Path,
    per_home: Annotated[int, tyro.conf.arg(metavar="N")] = 5,
    pool: Literal["test", "train"] = "test",
) -> None:
    """Generate homes and certified episodes in them, and write both as a split.

    Args:
        homes: seeds of the homes, as "9000:9010" (the last excluded) or "9000".
        out: the file to write; by its name ending in .jsonl.gz.
        per_home: episodes wanted in each home.
        pool: models of the homes: those of training homes, or the others.
    """
    from uniteam.world.certification.generate_episodes import generate_split
    from uniteam.world.task.splits import SUFFIX, write_split

    seeds = _seeds(homes)
    if per_home < 1:
        raise InvalidInputError(f"--per-home must be at least 1, got {per_home}")
    if not out.parent.is_dir():
        raise InvalidInputError(f"the directory of --out {out} does not exist; make it first")
    console = Console()
    short: list[str] = []
    with _progress(console, len(seeds)) as advance:

        def on_home(home: Home, count: int) -> None:
            if count < per_home:
                short.append(f"{home.name} offers {count}")
            advance()

        split = generate_split(out.name.removesuffix(SUFFIX), seeds, per_home, pool, on_home)
    if not split.episodes:
        raise InvalidInputError(f"no episode could be certified in the homes {homes}; try other seeds")
    write_split(split, out)
    unseen = sum(episode.unseen for episode in split.episodes)
    console.print(f"{len(split.episodes)} episodes in {len(split.homes)} homes, {unseen} of unseen categories: {out}")
    if short:
        console.print(f"Fewer than {per_home} were found in some homes: {', '.join(short)}.")
    console.print(f"Play them with: uniteam evaluate --split {out}", highlight=False)


def _seeds(homes: str) -> range:
    first, _, last = homes.partition(":")
    try:
        seeds = range(int(first), int(last) if last else int(first) + 1)
    except ValueError:
        seeds = range(0)
    if not seeds or seeds[0] < 0:
        raise InvalidInputError(f"--homes must be seeds such as 9000:9010 or 9000, got '{homes}'")
    return seeds


@contextmanager
def _progress(console: Console, total: int) -> Iterator[Callable[[], None]]:
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console) as progress:
        bar = progress.add_task("homes", total=total)
        yield lambda: progress.advance(bar)
