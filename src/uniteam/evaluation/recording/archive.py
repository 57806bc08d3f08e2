"""The file of a recording: a zip archive of named members, written whole and read with limits."""

import io
import zipfile
import zlib
from collections.abc import Mapping
from pathlib import Path

from uniteam.errors import DamagedFileError
from uniteam.files import try_folder, write_whole

MOST_BYTES = 1 << 30
"""Of all members unpacked; a recording of 1,250 steps of the full-size camera has a tenth of it."""

_EPOCH = (1980, 1, 1, 0, 0, 0)
"""The date of every member: the same episode gives the same bytes."""

_STORED = (".mp4",)
"""Endings of members that are packed already."""

_ERRORS = (OSError, EOFError, ValueError, RuntimeError, zipfile.BadZipFile, zlib.error, NotImplementedError)
"""What reading a file that is no archive, or a damaged one, raises."""


def write_archive(path: Path, members: Mapping[str, bytes]) -> None:
    """Write the members, so that the file is whole or not there at all, into a folder that is made where it is missing.

    Raises:
        UnwritableError: as the system says; what was there before is still there.
    """
    try_folder(path.parent)
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for name, content in members.items():
            entry = zipfile.ZipInfo(name, _EPOCH)
            entry.compress_type = zipfile.ZIP_STORED if name.endswith(_STORED) else zipfile.ZIP_DEFLATED
            archive.writestr(entry, content)
    write_whole(path, buffer.getvalue())


def read_archive(path: Path) -> dict[str, bytes]:
    """Return every member of the file by its name; each is compared with its checksum.

    Raises:
        DamagedFileError: there is no such file, it cannot be read, or it is too large.
    """
    try:
        with zipfile.ZipFile(path) as archive:
            entries = archive.infolist()
            if sum(entry.file_size for entry in entries) > MOST_BYTES:
                raise damaged(path, f"unpacked it has more than {MOST_BYTES} bytes")
            return {entry.filename: archive.read(entry) for entry in entries}
    except _ERRORS as error:
        raise damaged(path, getattr(error, "strerror", None) or str(error) or type(error).__name__) from error


def read_member(path: Path, name: str) -> bytes:
    """Return one member of the file, without unpacking the others; raises DamagedFileError."""
    try:
        with zipfile.ZipFile(path) as archive:
            if archive.getinfo(name).file_size > MOST_BYTES:
                raise damaged(path, f"unpacked its {name} has more than {MOST_BYTES} bytes")
            return archive.read(name)
    except KeyError as error:
        raise damaged(path, f"{name} is missing") from error
    except _ERRORS as error:
        raise damaged(path, getattr(error, "strerror", None) or str(error) or type(error).__name__) from error


def damaged(path: Path, what: str) -> DamagedFileError:
    """Return the error of a file that is no recording, or no longer one."""
    return DamagedFileError(
        f"the recording '{path}' cannot be read ({what}); give another file, or record the episode again with "
        "'uniteam run --record FILE'"
    )
