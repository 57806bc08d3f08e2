"""A library of models and textures, and how it is read from its folder.

A library is a folder with a `catalogue.json` (see `catalogue_file`), the models' glTF binaries in `models/`, and
perhaps floor and wall textures in `textures/` (see `textures`). The package comes with one, the pack.
"""

import hashlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from pathlib import Path

from uniteam.errors import UnknownNameError
from uniteam.world.assets.catalogue_file import read_catalogue_file
from uniteam.world.assets.model import Model, Pool
from uniteam.world.assets.reading import PACK_DIRECTORY, damaged, modified, read_bytes
from uniteam.world.assets.textures import Texture, TextureKind, read_textures


@dataclass(frozen=True)
class Catalogue:
    """What a library holds.

    Attributes:
        models: by id.
        unseen_categories: object classes that no training home holds.
        textures: of floors and walls, by name.
        folder: where it was read from; None where it was made in memory, as tests do.
    """

    models: Mapping[str, Model]
    unseen_categories: frozenset[str]
    textures: Mapping[str, Texture] = field(default_factory=dict)
    folder: Path | None = None

    def __getitem__(self, model_id: str) -> Model:
        try:
            return self.models[model_id]
        except KeyError:
            raise UnknownNameError("model", model_id, self.models) from None

    def texture(self, name: str) -> Texture:
        """Return the texture of a name; raises UnknownNameError."""
        try:
            return self.textures[name]
        except KeyError:
            raise UnknownNameError("texture", name, self.textures) from None

    def texture_names(self, kind: TextureKind) -> tuple[str, ...]:
        """Return the names of the textures for floors or for walls, sorted."""
        return tuple(sorted(name for name, texture in self.textures.items() if kind in texture.kinds))

    @cached_property
    def object_categories(self) -> tuple[str, ...]:
        """Every class of graspable object, sorted."""
        return tuple(sorted({m.category for m in self.models.values() if m.role == "object"}))

    def of_category(self, category: str, pool: Pool | None = None) -> tuple[Model, ...]:
        """Return the models of a category, of one pool or of both, sorted by id."""
        found = [m for m in self.models.values() if m.category == category and pool in (None, m.pool)]
        return tuple(sorted(found, key=lambda model: model.id))

    @cached_property
    def digest(self) -> str:
        """A SHA-256 of all that results depend on: models, textures, unseen classes, and what their files hold now.

        The meshes of the robot count where they lie in the library's folder, as they do in the pack.

        Raises:
            DamagedFileError: a file is missing or cannot be read.
        """
        content = hashlib.sha256(repr(sorted(self.unseen_categories)).encode())
        for model in sorted(self.models.values(), key=lambda m: m.id):
            facts = (model.id, model.role, model.category, model.name, model.size, model.mass, model.pool)
            content.update(repr((facts, model.shapes, model.surfaces)).encode())
            if model.file_to_model is not None:
                content.update(repr(model.file_to_model).encode())
        for name, texture in sorted(self.textures.items()):
            content.update(repr((name, texture.kinds, texture.size)).encode())
        for path in self._files():
            content.update(hashlib.sha256(read_bytes(path, "the file")).digest())
        return content.hexdigest()

    def _files(self) -> Iterator[Path]:
        yield from (self.models[name].path for name in sorted(self.models))
        yield from (self.textures[name].path for name in sorted(self.textures))
        if self.folder is not None:
            yield from sorted((self.folder / "robot").glob("*.glb"))


def load_catalogue() -> Catalogue:
    """Return the pack; raises DamagedFileError where it is damaged."""
    return load_library(PACK_DIRECTORY)


def load_library(folder: Path | str) -> Catalogue:
    """Return the library of a folder, read once as long as its catalogue does not change.

    Raises:
        DamagedFileError: the folder has no catalogue, or it or the list of textures is not what it should be.
    """
    root = Path(folder).resolve()
    return _read_library(root, modified(root / "catalogue.json"), modified(root / "textures" / "textures.json"))


@lru_cache(maxsize=8)
def _read_library(folder: Path, *_: object) -> Catalogue:
    models, content = read_catalogue_file(folder)
    own = Catalogue(models, frozenset(content.unseen_categories), read_textures(folder), folder)
    return _added_to(load_catalogue(), own) if content.adds_to_pack else own


def _added_to(pack: Catalogue, own: Catalogue) -> Catalogue:
    """Return the pack with the models and textures of another library besides, which keeps its folder."""
    assert own.folder is not None, "it was read from one"
    taken = sorted((pack.models.keys() & own.models) | (pack.textures.keys() & own.textures))
    if taken:
        reason = f"'{taken[0]}' is a name of the pack already, to which this library adds"
        raise damaged(own.folder / "catalogue.json", "the catalogue of models", reason)
    return Catalogue(
        {**pack.models, **own.models},
        pack.unseen_categories | own.unseen_categories,
        {**pack.textures, **own.textures},
        own.folder,
    )
