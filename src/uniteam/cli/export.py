"""`uniteam export`: recordings as files of other programs."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Annotated, Literal

import tyro
from rich.console import Console

from uniteam.cli.progress import counting
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.evaluation.analysis.recordings_named import all_recordings_named, recordings_named
from uniteam.evaluation.recording.recording import Recording, read_recording
from uniteam.files import new_folder, try_output, write_whole

RERUN_SUFFIX = ".rrd"
USAGE = "RUN[:AGENT] | FILE.zip | RUN EPISODE"


def export(
    program: Annotated[Literal["lerobot", "rerun"], tyro.conf.Positional],
    what: Annotated[tuple[str, ...], tyro.conf.Positional, tyro.conf.arg(metavar=USAGE)] = (),
    out: Annotated[Path | None, tyro.conf.arg(metavar="DIR|FILE.rrd")] = None,
    depth: Annotated[bool, tyro.conf.FlagCreatePairsOff] = False,
    successes: Annotated[bool, tyro.conf.FlagCreatePairsOff] = False,
) -> None:
    """Write recordings for other programs.

    lerobot makes a dataset of version 3.0 of them (LeRobotDataset): what was seen and felt at each step, what was done,
    and the instruction as its task; for imitation learning and for its viewers.

    rerun writes one recording for the viewer of Rerun, which shows its pictures, its map and what was true in one
    scene, along its steps: rerun FILE.rrd

    Args:
        program: For which.
        what: For lerobot, folders of runs that 'uniteam evaluate --record' has recorded, for all their agents, or
            FOLDER:AGENT for one; or single recordings. For rerun, one recording, or the folder of a run and the id of
            an episode.
        out: What to make: for lerobot a folder, "demonstrations" by default; for rerun a file, which by default has the
            name of the recording.
        depth: For lerobot: depth too, which not every policy takes.
        successes: For lerobot: only episodes with overall success.
    """
    console = make_console()
    if program == "rerun":
        _export_rerun(what, out, console)
    else:
        _export_lerobot(all_recordings_named(what), out or Path("demonstrations"), depth, successes, console)


def _export_rerun(what: Sequence[str], out: Path | None, console: Console) -> None:
    from uniteam.visualization.rerun_file.content import rerun_file

    files = recordings_named(what)
    if len(files) > 1:
        raise InvalidInputError("a file for Rerun is of one recording; name one, or RUN:AGENT and the episode")
    path = out or Path(f"{files[0].stem}{RERUN_SUFFIX}")
    try_output(path, (RERUN_SUFFIX,))
    with console.status("reading"):
        recording = read_recording(files[0])
    with counting(console, "writing", len(recording.steps) + 1) as advance:
        content = rerun_file(recording, advance)
    write_whole(path, content)
    console.print(
        f"For Rerun: {shown(path)} ({len(content) / 1e6:.1f} MB); see it with: rerun {shown(path)}", soft_wrap=True
    )


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
