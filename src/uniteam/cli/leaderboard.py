"""`uniteam leaderboard`: results scored anew, and the pages that show them."""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Annotated

import tyro
from rich.table import Table

from uniteam.cli.terminal import make_console, shown
from uniteam.errors import DamagedFileError, InvalidInputError, UniteamError, UnknownNameError
from uniteam.evaluation.analysis.leaderboard import PARTS, Standing, Standings, standings_of
from uniteam.evaluation.analysis.leaderboard_markdown import published_markdown, standings_markdown
from uniteam.evaluation.analysis.page_block import block_of, with_block
from uniteam.evaluation.analysis.published import PUBLISHED, UNLIKE
from uniteam.evaluation.analysis.table import Row, challenge_table
from uniteam.evaluation.results.run_folder import RunFolder, read_run
from uniteam.files import write_whole

RESULTS = Path("results")


class PageDiffersError(UniteamError):
    """A page shows other figures than the results come to."""


def leaderboard(
    folders: Annotated[tuple[Path, ...], tyro.conf.Positional, tyro.conf.arg(metavar="DIR")] = (),
    but_homes: Annotated[tuple[str, ...], tyro.conf.arg(metavar="NAME")] = (),
    write: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE")] = (),
    check: Annotated[tuple[Path, ...], tyro.conf.arg(metavar="FILE")] = (),
) -> None:
    """Score results anew from the line of each episode, and print them by style of the home and by seen and unseen.

    Published figures stand below, marked as unlike: other homes, another simulator.

    Args:
        folders: Folders of runs; by default those in results/.
        but_homes: Leave these homes out, such as those that an agent was watched in while it was made.
        write: Pages (.md) to write the tables into, between the marks <!-- leaderboard --> and <!-- end -->, and the
            published figures between <!-- published --> and <!-- end -->.
        check: Pages to compare with the results; where one differs, the command ends with exit code 2.
    """
    runs = [read_run(folder) for folder in folders or _folders_of(RESULTS)]
    _check_homes(but_homes, runs)
    standings = [standings_of(run, but_homes) for run in runs]
    blocks = {"leaderboard": standings_markdown(standings), "published": published_markdown()}
    for page in check:
        _check(page, blocks)
    for page in write:
        _write(page, blocks)
    console = make_console()
    for each in standings:
        for table in _tables(each, console.width):
            console.print(table)
            console.print()
    console.print(_published())


def _check_homes(names: Sequence[str], runs: Sequence[RunFolder]) -> None:
    homes = {result.home for run in runs for own in run.results.values() for result in own.values()}
    for name in names:
        if name not in homes:
            raise UnknownNameError("home in these results", name, homes)


def _folders_of(results: Path) -> list[Path]:
    folders = sorted(path.parent for path in results.glob("*/config.json"))
    if not folders:
        raise InvalidInputError(f"there are no folders of runs in '{results}' here; name some")
    return folders


def _tables(standings: Standings, width: int) -> Iterator[Table]:
    told = shown(f"Percent, steps: mean over 95 % interval. {standings.told.replace('`', '')}.")
    yield challenge_table(_rows(standings.own), told, width, shown)
    if standings.shared:
        yield challenge_table(_rows(standings.shared), "On the episodes that all of them have played.", width, shown)
    yield _parts(standings.own)


def _rows(standings: Sequence[Standing]) -> dict[str, Row]:
    return {each.agent: Row(each.summary, each.summary.episode_count) for each in standings}


def _parts(standings: Sequence[Standing]) -> Table:
    table = Table(caption="Overall success, percent, by part of the episodes.", caption_justify="left", pad_edge=False)
    table.add_column("agent", overflow="fold")
    for part in PARTS:
        table.add_column(part, justify="right", no_wrap=True)
    for standing in standings:
        table.add_row(f"[bold]{shown(standing.agent)}[/]", *(_part(standing, part) for part in PARTS))
    return table


def _part(standing: Standing, part: str) -> str:
    if part not in standing.parts:
        return "none"
    summary = standing.parts[part]
    estimate = summary.estimates["overall_success"]
    mean, low, high = (100.0 * value for value in (estimate.mean, estimate.low, estimate.high))
    return f"[bold]{mean:.1f}[/] of {summary.episode_count}\n[dim]{low:.0f}–{high:.0f}[/]"


def _published() -> Table:
    table = Table(caption=UNLIKE, caption_justify="left", pad_edge=False)
    table.add_column("published", overflow="fold")
    for heading in ("FindObj", "Pick", "FindRec", "Overall", "Partial", "Steps"):
        table.add_column(heading, justify="right", no_wrap=True)
    for row in PUBLISHED:
        figures = (row.find_object, row.pick, row.find_receptacle, row.overall, row.partial, row.steps)
        cells = ("" if value is None else f"{value:,.1f}" for value in figures)
        table.add_row(f"{row.system}\n[dim]{row.setting}[/]", *cells)
    return table


def _check(page: Path, blocks: Mapping[str, str]) -> None:
    text = _text(page)
    for name in _marked(page, text, blocks):
        if block_of(text, name) != blocks[name]:
            raise PageDiffersError(
                f"what '{page}' shows between its marks '{name}' is not what the results come to; "
                f"'uniteam leaderboard --write {page}' writes it anew"
            )


def _write(page: Path, blocks: Mapping[str, str]) -> None:
    text = _text(page)
    for name in _marked(page, text, blocks):
        text = with_block(text, name, blocks[name])
    write_whole(page, text.encode())


def _text(page: Path) -> str:
    try:
        return page.read_text(encoding="utf-8")
    except (OSError, ValueError) as error:
        raise DamagedFileError(f"'{page}' cannot be read ({error}); name a page in Markdown") from error


def _marked(page: Path, text: str, blocks: Mapping[str, str]) -> Sequence[str]:
    marked = [name for name in blocks if block_of(text, name) is not None]
    if not marked:
        raise InvalidInputError(f"'{page}' has no marks '<!-- leaderboard -->' and '<!-- end -->' to write between")
    return marked
