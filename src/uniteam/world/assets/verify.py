"""Is a library whole? Every file that its catalogue and its list of textures name, unchanged since it was built."""

import hashlib
from collections.abc import Iterator
from pathlib import Path

from uniteam.errors import DamagedFileError
from uniteam.world.assets.catalogue import Catalogue, load_catalogue
from uniteam.world.assets.reading import PACK_DIRECTORY, read_bytes


def verify_pack() -> tuple[str, ...]:
    """Return what is wrong with the pack, a sentence a file; nothing where it is intact.

    Raises:
        DamagedFileError: the catalogue or the list of textures cannot be read.
    """
    attribution = PACK_DIRECTORY / "ATTRIBUTION.md"
    missing = () if attribution.is_file() else ("ATTRIBUTION.md is missing",)
    return (*library_problems(load_catalogue()), *missing)


def library_problems(library: Catalogue) -> Iterator[str]:
    """Yield what is wrong with a library's files, a sentence a file."""
    for model in library.models.values():
        yield from _file_problems(model.path, model.checksum)
    for texture in library.textures.values():
        yield from _file_problems(texture.path, texture.checksum)


def _file_problems(path: Path, checksum: str) -> Iterator[str]:
    name = f"{path.parent.name}/{path.name}"
    if not path.exists():
        yield f"{name} is missing"
        return
    try:
        content = read_bytes(path, "the file")
    except DamagedFileError as error:
        yield str(error)
        return
    if checksum and hashlib.sha256(content).hexdigest() != checksum:
        yield f"{name} has changed since it was built"
