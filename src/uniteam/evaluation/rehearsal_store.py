"""The episodes of a rehearsal, kept as they end: a folder that can be taken up again, with more dials or episodes.

`config.json` says how they were played; `rehearsed.jsonl` grows by a line as each ends.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import msgspec

from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.evaluation.rehearsal import Rehearsed
from uniteam.evaluation.results.differences import differences
from uniteam.evaluation.results.journal import Journal
from uniteam.evaluation.results.lock import FolderLock
from uniteam.evaluation.results.reading import REMEDY, read_configuration
from uniteam.files import try_folder, write_json
from uniteam.world.fake.dials import Dials


@dataclass(frozen=True)
class _Line:
    episode: str
    dials: Dials | None
    rehearsed: Rehearsed


class RehearsalStore:
    """What episodes came to, by the robot's dials; no other process can write into the folder until `close`.

    Attributes:
        known: by episode and dials, None for the simulator itself.
    """

    def __init__(self, folder: Path, configuration: Mapping[str, Any]) -> None:
        """Begin or take up a rehearsal.

        Args:
            folder: made where it does not exist.
            configuration: plain JSON data, of all that results depend on besides the dials.

        Raises:
            InvalidInputError: the folder holds a rehearsal of another configuration.
            DamagedFileError: its files cannot be read.
            UnwritableError: they cannot be written.
            FolderInUseError: another process writes into it.
        """
        try_folder(folder)
        self._lock = FolderLock(folder)
        try:
            recorded = read_configuration(folder / "config.json")
            found = differences(recorded, dict(configuration)) if recorded else []
            if found:
                what = "; ".join(found[:5])
                raise InvalidInputError(f"{folder} holds a rehearsal of another configuration ({what}); {REMEDY}")
            write_json(folder / "config.json", configuration)
            self._journal = Journal(folder / "rehearsed.jsonl")
            lines = [_read(line, self._journal.path) for line in self._journal.lines]
            self.known = {(line.episode, line.dials): line.rehearsed for line in lines}
        except BaseException:
            self.close()
            raise

    def append(self, episode: str, dials: Dials | None, rehearsed: Rehearsed) -> None:
        """Keep what an episode came to; it is on the disk when this returns, or raises UnwritableError."""
        line = msgspec.json.encode(_Line(episode, dials, rehearsed)).decode()
        self._journal.append(f"{line}\n")
        self.known[episode, dials] = rehearsed

    def close(self) -> None:
        """Let other processes have the folder."""
        self._lock.release()


def _read(line: bytes, path: Path) -> _Line:
    try:
        return msgspec.json.decode(line, type=_Line)
    except (msgspec.MsgspecError, InvalidInputError, RecursionError) as error:
        raise DamagedFileError(f"'{path}' has a line that is no episode of a rehearsal ({error}); {REMEDY}") from error
