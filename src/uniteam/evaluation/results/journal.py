"""A file that grows by whole lines: a line is on the disk when `append` returns, and a torn one is mended."""

import json
import logging
import os
from contextlib import suppress
from pathlib import Path

from uniteam.errors import DamagedFileError
from uniteam.files import UnwritableError, sync_folder

_log = logging.getLogger(__name__)


class Journal:
    """Lines of JSON in a file that is only ever appended to."""

    def __init__(self, path: Path) -> None:
        """Open the file, made where it is missing, and mend its end.

        A last line that was written to its end but for the line feed stays and gets it; one that broke off in the
        middle is cut off.

        Raises:
            DamagedFileError: the file cannot be read.
            UnwritableError: it cannot be made or mended.
        """
        self.path = path
        try:
            content = path.read_bytes() if path.exists() else b""
        except OSError as error:
            raise DamagedFileError(f"'{path}' cannot be read ({error.strerror}); choose another --out") from error
        whole, _, last = content.rpartition(b"\n")
        self.lines = whole.split(b"\n") if whole else []
        if not last:
            self._write(b"")
        elif _is_json(last):
            self.lines.append(last)
            self._write(b"\n")
        else:
            _log.warning("the last line of %s was not written to its end and is dropped", path)
            self._cut(len(content) - len(last))
        sync_folder(path.parent)

    def append(self, line: str) -> None:
        """Write a line, given with its line feed.

        Raises:
            UnwritableError: as the system says; nothing of the line stays in the file.
        """
        self._write(line.encode())

    def _write(self, content: bytes) -> None:
        try:
            descriptor = os.open(self.path, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o666)
        except OSError as error:
            raise UnwritableError(self.path, error) from error
        before = os.fstat(descriptor).st_size
        try:
            left = content
            while left:
                left = left[os.write(descriptor, left) :]
            os.fsync(descriptor)
        except OSError as error:
            with suppress(OSError):
                os.ftruncate(descriptor, before)
            raise UnwritableError(self.path, error) from error
        finally:
            os.close(descriptor)

    def _cut(self, size: int) -> None:
        try:
            os.truncate(self.path, size)
        except OSError as error:
            raise UnwritableError(self.path, error) from error


def _is_json(line: bytes) -> bool:
    try:
        json.loads(line)
    except (ValueError, RecursionError):
        return False
    return True
