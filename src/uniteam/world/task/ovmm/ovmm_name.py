"""Names of splits that stand for a folder of the challenge's files: "ovmm:DIR/val"."""

import logging
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from uniteam.world.homes.readers.habitat_frame import Heading, heading_as_coded, heading_as_written
from uniteam.world.task.episode import Split
from uniteam.world.task.ovmm.episode_file import FILES
from uniteam.world.task.ovmm.ovmm_split import OvmmSplit, read_ovmm_split

_log = logging.getLogger(__name__)

HEADINGS: Mapping[str, Heading] = {"ovmm": heading_as_coded, "ovmm-as-written": heading_as_written}
"""How the rotation of a start is read, by what stands before the colon."""


@dataclass(frozen=True)
class OvmmName:
    """A folder, and how the starts in it are read.

    Attributes:
        kind: "ovmm", or another of `HEADINGS`.
        folder: that holds `episodes.json.gz`.
    """

    kind: str
    folder: Path

    @property
    def label(self) -> str:
        """What the split is called: "ovmm-val"."""
        return f"{self.kind}-{self.folder.resolve().name}"

    def load(self) -> Split:
        """Return the split, and warn of episodes that are left out; raises what `read` does."""
        read = self.read()
        if read.left_out:
            name, reason = next(iter(read.left_out.items()))
            count = f"{len(read.left_out)} of {len(read.left_out) + len(read.split.episodes)} episodes"
            _log.warning("%s in %s are left out; the first, %s: %s", count, self.folder, name, reason)
        return read.split

    def read(self) -> OvmmSplit:
        """Return the split, and what is left out of it.

        Raises:
            DamagedFileError: a file is missing or damaged, or no episode can be played; also where there is no folder.
        """
        return read_ovmm_split(self.folder, self.label, HEADINGS[self.kind])

    def files(self) -> tuple[Path, ...]:
        """Return the files of the folder that are read."""
        return tuple(path for path in (self.folder / name for name in FILES) if path.is_file())


def parse_ovmm_name(name: str) -> OvmmName | None:
    """Return what a split's name says; None where it is the name of no such folder."""
    kind, colon, folder = name.partition(":")
    return OvmmName(kind, Path(folder)) if colon and folder and kind in HEADINGS else None
