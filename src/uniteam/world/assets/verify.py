"""Is the pack whole? Every file that the catalogue and the list of textures name, unchanged since it was built."""

import hashlib
from collections.abc import Iterator
from pathlib import Path

from uniteam.world.assets.catalogue import PACK_DIRECTORY, load_catalogue
from uniteam.world.assets.textures import TEXTURE_DIRECTORY, load_textures


def verify_pack() -> tuple[str, ...]:
    """Return what is wrong with the pack, a sentence a file; nothing where it is intact.

    Raises:
        DamagedFileError: the catalogue or the list of textures cannot be read.
    """
    return tuple(_problems())


def _problems() -> Iterator[str]:
    for model in load_catalogue().models.values():
        yield from _file_problems(model.path, model.checksum)
    for name, texture in load_textures().items():
        yield from _file_problems(TEXTURE_DIRECTORY / f"{name}.jpg", texture.checksum)
    if not (PACK_DIRECTORY / "ATTRIBUTION.md").exists():
        yield "ATTRIBUTION.md is missing from the pack"


def _file_problems(path: Path, checksum: str) -> Iterator[str]:
    name = path.relative_to(PACK_DIRECTORY).as_posix()
    if not path.exists():
        yield f"{name} is missing from the pack"
    elif hashlib.sha256(path.read_bytes()).hexdigest() != checksum:
        yield f"{name} of the pack has changed since it was built"
