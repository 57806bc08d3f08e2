"""`uniteam export`: recordings as files of other programs."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Annotated, Literal

import tyro
from rich.console import Console

from uniteam.cli.progress import counting
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.evaluation.analysis.recordings_named import all_recordings_named
from uniteam.evaluation.recording.recording import Recording, read_recording
from uniteam.files import new_folder


def export(
    program: Annotated[Literal["lerobot"], tyro.conf.Positional],
    what: Annotated[tuple[str, ...], tyro.conf.Positional, tyro.conf.arg(metavar="RUN[:AGENT]|FILE.zip")] = (),
    out: Annotated[Path, tyro.conf.arg(metavar="DIR")] = Path("demonstrations"),
    depth: Annotated[bool, tyro.conf.FlagCreatePairsOff] = False,
    successes: Annotated[bool, tyro.conf.FlagCreatePairsOff] = False,
) -> None:
    """Write recordings for other programs.

    lerobot makes a dataset of version 3.0 of them (LeRobotDataset): what was seen and felt at each step, what was done,
    and the instruction as its task; for imitation learning and for its viewers.

    Args:
        program: For which.
        what: Folders of runs that 'uniteam evaluate --record' has recorded, for all their agents, or FOLDER:AGENT for
            one; or single recordings.
        out: The folder to make.
        depth: Depth too, which not every policy takes.
        successes: Only episodes with overall success.
    """
    files = all_recordings_named(what)
    console = make_console()
    _export_lerobot(files, out, depth, successes, console)


def _export_lerobot(files: Sequence[Path], out: Path, depth: bool, successes: bool, console: Console) -> None:
    from uniteam.adapters.lerobot.dataset import DatasetWriter

    with console.status("reading"):
        lengths = {file: _wanted_length(read_recording(file), successes) for file in files}
    wanted = [file for file, length in lengths.items() if length]
    if not wanted:
        raise InvalidInputError(
            f"of {len(files)} recordings none {'is an overall success' if successes else 'has a step'}; give others"
        )
    with new_folder(out) as folder, counting(console, "drawing", sum(lengths.values())) as advance:
        writer: DatasetWriter | None = None
        for recording in _read(wanted):
            writer = writer or DatasetWriter(folder, recording.header.camera, depth)
            writer.add(recording, advance)
        assert writer is not None, "there are files"
        writer.finish()
    size = sum(file.stat().st_size for file in out.rglob("*") if file.is_file())
    console.print(
        f"Dataset: {shown(out)} ({len(wanted)} episodes, {sum(lengths.values())} steps, {size / 1e6:.1f} MB)",
        soft_wrap=True,
    )


def _read(files: Sequence[Path]) -> Iterator[Recording]:
    return map(read_recording, files)


def _wanted_length(recording: Recording, successes: bool) -> int:
    """Return how many steps of a recording are wanted."""
    if successes and not recording.result.measures.overall_success:
        return 0
    return len(recording.steps)
