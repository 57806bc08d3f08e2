"""Names of splits that stand for a folder of the challenge's files: "ovmm:DIR/val"."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from uniteam.world.homes.readers.habitat_frame import Heading, heading_as_coded, heading_as_written
from uniteam.world.task.episode import Split
from uniteam.world.task.ovmm.episode_file import FILES
from uniteam.world.task.ovmm.ovmm_split import load_ovmm_split

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

    def load(self) -> Split:
        """Return the split; raises DamagedFileError, also where there is no such folder."""
        return load_ovmm_split(self.folder, self.kind, HEADINGS[self.kind])

    def files(self) -> tuple[Path, ...]:
        """Return the files of the folder that are read."""
        return tuple(path for path in (self.folder / name for name in FILES) if path.is_file())


def parse_ovmm_name(name: str) -> OvmmName | None:
    """Return what a split's name says; None where it is the name of no such folder."""
    kind, colon, folder = name.partition(":")
    return OvmmName(kind, Path(folder)) if colon and folder and kind in HEADINGS else None
