"""Files of houses: one a line (`val.jsonl.gz`, `val.jsonl`), or one by itself (`house.json`, `house.json.gz`)."""

import gzip
import zlib
from collections.abc import Generator
from contextlib import closing
from itertools import islice
from pathlib import Path
from typing import BinaryIO, cast

import msgspec

from uniteam.errors import InvalidInputError
from uniteam.world.assets.reading import MOST_JSON, damaged, decode_json
from uniteam.world.homes.readers.procthor.schema import House

SUFFIXES = (".jsonl.gz", ".jsonl", ".json.gz", ".json")

_WHAT = "the file of houses"
_POINTER = b"version https://git-lfs.github.com/spec/"


def check_houses_path(path: Path) -> None:
    """Raise InvalidInputError where a path cannot be a file of houses."""
    if not path.name.endswith(SUFFIXES):
        raise InvalidInputError(f"'{path}' is no file of houses: its name must end in {', '.join(SUFFIXES)}")
    if not path.is_file():
        raise InvalidInputError(
            f"there is no file '{path}'; give the file of houses, such as val.jsonl.gz of ProcTHOR-10k"
        )


def read_house(path: Path, number: int) -> House:
    """Return one house of a file.

    Args:
        path: of the file.
        number: which house, from 0.

    Raises:
        InvalidInputError: the file does not hold so many, or there is no such file.
        DamagedFileError: it cannot be read, or what stands there is no house; the sentence names the field.
    """
    check_houses_path(path)
    with closing(_houses(path)) as houses:
        text = next(islice(houses, number, None), None)
    if text is None:
        raise InvalidInputError(
            f"'{path}' holds {count_houses(path)} houses, counted from 0; there is no house {number}"
        )
    try:
        return decode_json(text, House)
    except (msgspec.MsgspecError, RecursionError, ValueError) as error:
        raise damaged(path, f"house {number} of", str(error).replace("`$.", "`")) from error


def count_houses(path: Path) -> int:
    """Return how many houses a file holds; raises DamagedFileError."""
    return sum(1 for _ in _houses(path))


def _houses(path: Path) -> Generator[bytes, None, None]:
    """Yield the text of each house."""
    try:
        with _opened(path) as file:
            if ".jsonl" not in path.name:
                yield _short(path, file.read(MOST_JSON + 1))
                return
            while line := _short(path, file.readline(MOST_JSON + 1)):
                if line.strip():
                    yield line
    except (OSError, EOFError, zlib.error) as error:
        raise damaged(path, _WHAT, str(error).lower() or type(error).__name__) from error


def _opened(path: Path) -> BinaryIO:
    with path.open("rb") as file:
        if file.read(len(_POINTER)) == _POINTER:
            raise damaged(path, _WHAT, "it is a pointer of Git LFS, whose file was not fetched; 'git lfs pull' does")
    return cast(BinaryIO, gzip.open(path, "rb") if path.name.endswith(".gz") else path.open("rb"))


def _short(path: Path, text: bytes) -> bytes:
    if len(text) > MOST_JSON:
        raise damaged(path, _WHAT, f"a house in it has more than {MOST_JSON} bytes")
    return text
