"""Reading files that anybody may have written: as much as is sensible, and one sentence where that is not enough."""

from pathlib import Path
from typing import TypeVar

import msgspec

from uniteam.errors import DamagedFileError
from uniteam.strict_json import parse_json

PACK_DIRECTORY = Path(__file__).parent / "pack"
"""The library that comes with the package."""

MOST_BYTES = 64 * 1024 * 1024
MOST_JSON = 16 * 1024 * 1024
"""No larger file is read, no larger one of JSON: once read, it takes many times its size."""

_POINTER = b"version https://git-lfs.github.com/spec/"

Schema = TypeVar("Schema")
"""The type whose fields say what a file must hold."""


def read_bytes(path: Path, what: str, most: int = MOST_BYTES) -> bytes:
    """Return a file's content.

    Args:
        path: of the file.
        what: the file is, for the sentence ("the model").
        most: how many bytes it may have.

    Raises:
        DamagedFileError: there is no such file, it cannot be read, or it is too large.
    """
    try:
        if not path.is_file():
            raise damaged(path, what, "there is no such file")
        with path.open("rb") as file:
            content = file.read(most + 1)
    except (OSError, ValueError) as error:
        raise damaged(path, what, _reason(error)) from error
    if len(content) > most:
        raise damaged(path, what, f"it has more than {most} bytes")
    if content.startswith(_POINTER):
        raise damaged(path, what, "it is a pointer of Git LFS, whose file was not fetched; 'git lfs pull' does")
    return content


def read_json(path: Path, what: str, schema: type[Schema]) -> Schema:
    """Return the content of a JSON file that fits a schema; raises DamagedFileError that names the field at fault."""
    content = read_bytes(path, what, MOST_JSON)
    try:
        return decode_json(content, schema)
    except (msgspec.MsgspecError, RecursionError, ValueError) as error:
        raise damaged(path, what, str(error)) from error


def decode_json(content: bytes, schema: type[Schema]) -> Schema:
    """Return what JSON says that fits a schema.

    Raises:
        msgspec.MsgspecError: it is no JSON, or does not fit.
        RecursionError: it is nested too deeply.
        ValueError: a field stands twice in one object, so that readers differ in which they take.
    """
    value = msgspec.json.decode(content, type=schema)
    parse_json(content)
    return value


def modified(path: Path) -> tuple[int, int]:
    """Return what changes when a file does: its time of modification (ns) and its size; (0, 0) where there is none."""
    try:
        status = path.stat()
    except (OSError, ValueError):
        return (0, 0)
    return status.st_mtime_ns, status.st_size


def damaged(path: Path, what: str, reason: str) -> DamagedFileError:
    """Return the error that says which file is at fault, why, and what to do about it."""
    remedy = "reinstall uniteam" if path.is_relative_to(PACK_DIRECTORY) else "mend it or write it anew"
    return DamagedFileError(f"{what} {path} cannot be read ({reason}); {remedy}")


def _reason(error: OSError | ValueError) -> str:
    return error.strerror.lower() if isinstance(error, OSError) and error.strerror else str(error)
