"""One run at a time in a folder."""

import logging
import os
import socket
from contextlib import suppress
from pathlib import Path
from typing import BinaryIO

from uniteam.errors import UniteamError
from uniteam.files import UnwritableError

_log = logging.getLogger(__name__)


class FolderInUseError(UniteamError):
    """Another process writes into the folder."""


class FolderLock:
    """Held until `release`, or until this process ends in whatever way."""

    def __init__(self, folder: Path) -> None:
        """Take the lock of a folder that exists.

        Raises:
            FolderInUseError: another run holds it; the message names its process.
            UnwritableError: the lock's file cannot be made.
        """
        self._path = folder / ".lock"
        try:
            self._file = self._path.open("a+b")
        except OSError as error:
            raise UnwritableError(self._path, error) from error
        if not _lock(self._file):
            holder = _read(self._file)
            self._file.close()
            raise FolderInUseError(
                f"another run writes into '{folder}' ({holder}); wait until it has ended, or choose another --out"
            )
        with suppress(OSError):  # the name only serves the message
            self._file.truncate(0)
            self._file.write(f"process {os.getpid()} on {socket.gethostname()}".encode())
            self._file.flush()

    def release(self) -> None:
        """Let others have the folder."""
        self._file.close()


def _lock(file: BinaryIO) -> bool:
    """Return False where another process holds the lock."""
    try:
        import fcntl
    except ImportError:  # Windows
        _log.warning("this system has no file locks: start no second run in the same folder")
        return True
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    except OSError as error:  # some network file systems have none
        _log.warning("the folder cannot be locked (%s): start no second run in it", error)
    return True


def _read(file: BinaryIO) -> str:
    file.seek(0)
    return "".join(c for c in file.read(200).decode(errors="replace") if c.isprintable()) or "its process is unknown"
