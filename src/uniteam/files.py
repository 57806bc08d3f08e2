"""Files that last: tried before the work, replaced whole, on the disk when the call returns."""

import json
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from hashlib import sha256
from pathlib import Path
from typing import Any
from urllib.parse import quote

from uniteam.errors import InvalidInputError, UniteamError

LONGEST_NAME = 150
"""Of the characters that a label may have as the name of a file; every system takes some more."""


class UnwritableError(UniteamError):
    """A file or folder that cannot be written; the message says which and why."""

    def __init__(self, path: Path, error: Exception) -> None:
        """Build the message from the path as the user gave it and what the system answered."""
        why = getattr(error, "strerror", None) or str(error) or type(error).__name__
        super().__init__(f"'{path}' cannot be written ({why}); make room or the rights for it, or choose another place")


def try_output(path: Path, suffixes: tuple[str, ...] = ()) -> None:
    """Find out before the work whether a file can be written at its end; its folder is made where it is missing.

    Args:
        path: of the file to be written later; whatever it holds stays as it is.
        suffixes: endings that its name may have; any where none is given.

    Raises:
        InvalidInputError: the path is empty, a folder, or has another ending.
        UnwritableError: the folder cannot be made or written into.
    """
    try:
        if not path.name or path.is_dir():
            raise InvalidInputError(f"'{path}' is a folder; give the name of a file to write")
        if suffixes and not path.name.endswith(suffixes):
            raise InvalidInputError(f"'{path}' must end in {' or '.join(suffixes)}")
        try_folder(path.parent)
        if path.is_file():
            with path.open("ab"):
                pass
    except (OSError, ValueError) as error:
        raise UnwritableError(path, error) from error


def try_folder(folder: Path) -> None:
    """Make a folder where it is missing, and find out whether files can be written into it; raises UnwritableError."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
    except (OSError, ValueError) as error:
        raise UnwritableError(folder, error) from error


def write_whole(path: Path, content: bytes) -> None:
    """Write a file so that it holds either what it held before or the whole content, and lasts.

    Raises:
        UnwritableError: as the system says; what was there before is still there.
    """
    try:
        target = path.resolve()
        if target.exists() and not target.is_file():  # a device or a pipe is written to, never replaced
            target.write_bytes(content)
        else:
            _replace(target, content)
    except (OSError, ValueError) as error:
        raise UnwritableError(path, error) from error


def write_json(path: Path, data: Any) -> None:
    """Write plain data as JSON, as `write_whole` does; raises UnwritableError."""
    write_whole(path, (json.dumps(data, indent=2) + "\n").encode())


def _replace(path: Path, content: bytes) -> None:
    partial = path.with_name(f"{path.name[:200]}.{os.getpid()}.partial")
    try:
        with partial.open("wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        partial.replace(path)
    finally:
        partial.unlink(missing_ok=True)
    sync_folder(path.parent)


@contextmanager
def new_folder(path: Path) -> Iterator[Path]:
    """Give a folder to fill, which is there under its name only once that has been done without an error.

    Raises:
        InvalidInputError: there is something of that name already.
        UnwritableError: as the system says.
    """
    if path.exists():
        raise InvalidInputError(f"'{path}' is there already; remove it, or choose another name")
    partial = path.with_name(f"{path.name[:200]}.{os.getpid()}.partial")
    try:
        try_folder(path.parent)
        partial.mkdir()
        yield partial
        partial.rename(path)
        sync_folder(path.parent)
    except OSError as error:
        raise UnwritableError(path, error) from error
    finally:
        shutil.rmtree(partial, ignore_errors=True)


def file_name(label: str) -> str:
    """Return the name of a file or folder for a label: the label itself where that can be, and another one for each."""
    name = quote(label, safe=" ,()+@=", errors="backslashreplace")
    if name.startswith("."):
        name = f"%2E{name[1:]}"
    if len(name) <= LONGEST_NAME:
        return name
    return f"{name[: LONGEST_NAME - 13]}-{sha256(name.encode()).hexdigest()[:12]}"


def sync_folder(folder: Path) -> None:
    """Have the names in a folder last as its files do; Windows cannot open folders, and does so by itself."""
    if os.name == "nt":
        return
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
