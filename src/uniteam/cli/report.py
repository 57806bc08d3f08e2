"""`uniteam report`: runs as one page."""

from pathlib import Path
from typing import Annotated
from urllib.parse import quote

import tyro

from uniteam.cli.progress import counting
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.evaluation.analysis.contestants import Contestant, contestants_named
from uniteam.evaluation.analysis.recordings_named import recording_of
from uniteam.evaluation.recording.recording import read_recording
from uniteam.files import file_name, try_folder, try_output, write_whole
from uniteam.visualization.replay_page.page import replay_page
from uniteam.visualization.report_page.page import report_page

SUFFIX = ".html"


def report(
    runs: Annotated[tuple[str, ...], tyro.conf.Positional, tyro.conf.arg(metavar="RUN[:AGENT]")] = (),
    out: Annotated[Path, tyro.conf.arg(metavar=f"FILE{SUFFIX}")] = Path("report.html"),
    replays: Annotated[bool, tyro.conf.FlagCreatePairsOff] = False,
) -> None:
    """Make one page of runs: tables with intervals, success by tag, and every episode with why it failed.

    It opens in any browser, offline. Where the folder of a run has a causes.json, the page shows the causes.

    Args:
        runs: Folders of runs, for all agents in them, or FOLDER:AGENT for one.
        out: The page to write.
        replays: Write a page for each recording too, into a folder beside the report, which links to them.
    """
    contestants = contestants_named(runs)
    if not contestants:
        raise InvalidInputError("name the folder of a run that has results, as 'uniteam evaluate' writes it")
    try_output(out, (SUFFIX, ".htm"))
    folder = out.with_name(f"{out.stem}-replays")
    pages = {
        (number, episode): folder / file_name(contestant.label) / f"{file_name(episode)}{SUFFIX}"
        for number, contestant in enumerate(contestants)
        for episode in contestant.results
    }
    console = make_console()
    if replays:
        wanted = [
            (recording, page)
            for (number, episode), page in pages.items()
            if (recording := recording_of(contestants[number], episode)).is_file()
        ]
        with counting(console, "drawing replays", len(wanted)) as advance:
            for recording, page in wanted:
                try_folder(page.parent)
                write_whole(page, replay_page([read_recording(recording)]).encode())
                advance()

    def link_of(contestant: Contestant, episode: str) -> str | None:
        page = pages[contestants.index(contestant), episode]
        return quote(page.relative_to(out.parent).as_posix()) if page.is_file() else None

    with console.status("reading the split and writing"):
        content = report_page(contestants, link_of).encode()
    write_whole(out, content)
    console.print(f"Report: {shown(out)} ({len(content) / 1e6:.1f} MB)", soft_wrap=True)
