"""`uniteam replay`: a recording, or two of the same episode, as one page."""

from pathlib import Path
from typing import Annotated

import tyro

from uniteam.cli.progress import counting
from uniteam.cli.terminal import make_console, shown
from uniteam.evaluation.analysis.recordings_named import recordings_named
from uniteam.evaluation.recording.recording import read_recording
from uniteam.files import try_output, write_whole
from uniteam.visualization.replay_page.page import replay_page

SUFFIX = ".html"
USAGE = "FILE [FILE] | RUN EPISODE [RUN]"


def replay(
    what: Annotated[tuple[str, ...], tyro.conf.Positional, tyro.conf.arg(metavar=USAGE)] = (),
    out: Annotated[Path | None, tyro.conf.arg(metavar=f"FILE{SUFFIX}")] = None,
) -> None:
    """Make one page of a recording, or of two of the same episode beside each other: it opens in any browser, offline.

    Args:
        what: One recording or two, as `uniteam evaluate --record` and `uniteam run --record` write them; or the folder
            of a run, the id of an episode, and where it is to be compared with another run, that one's folder.
            RUN:AGENT names one agent of a run; of two agents both are shown.
        out: The page to write; by default it has the name of the first recording, and lies in this folder.
    """
    files = recordings_named(what)
    page = out or Path(f"{files[0].stem}{SUFFIX}")
    try_output(page, (SUFFIX, ".htm"))
    console = make_console()
    with console.status("reading"):
        recordings = [read_recording(file) for file in files]
    moments = sum(len(recording.steps) + 1 for recording in recordings)
    with counting(console, "drawing", moments) as advance:
        content = replay_page(recordings, advance).encode()
    write_whole(page, content)
    console.print(f"Replay: {shown(page)} ({len(content) / 1e6:.1f} MB)", soft_wrap=True)
