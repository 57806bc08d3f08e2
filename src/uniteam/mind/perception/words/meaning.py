"""What a word or phrase means to perception: which name it is another word for, and a vector of meaning.

An exact name wins over everything. Then come other words for it, the phrase without what stands before its last words
("red coffee mug"), and a word that is spelled nearly so; then, where it is installed, a text encoder. The vectors are
CLIP's text vectors (Radford et al., arXiv 2103.00020) as Detic carries them (Zhou et al., arXiv 2201.02605;
Apache-2.0), reduced to fewer dimensions.
"""

import json
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import lru_cache
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from uniteam.errors import DamagedFileError, UnknownNameError
from uniteam.mind.perception.words.encoder import encode

NAME_FILE = Path(__file__).with_name("names.npz")
"""Names and their unit vectors in half precision; `tools/words_build/build_names.py` makes it."""
WORD_FILE = Path(__file__).with_name("words.json")
"""Other words for names, and descriptions of names that the table lacks by names that it has; ours."""

DIMENSIONS = 128
_ALIKE = 0.84
"""How alike two words are spelled that are taken for one."""
_HEAD_ENDS = re.compile(r"\b(?:of|with|for|on|in|from|without|that|which|to|by)\b")
_MEASURES = re.compile(r"^(?:pair|bunch|piece|set|stack|pile|couple|slice|kind|sort) of ")

Vector = NDArray[np.float32]
Encoder = Callable[[str], Vector | None]
"""From a phrase that the table does not know to a vector, or None where there is none."""


@dataclass(frozen=True)
class Meaning:
    """What a phrase means.

    Attributes:
        name: the name it was taken for, its words apart; the phrase itself where an encoder read it.
        vector: (DIMENSIONS,) of unit length.
    """

    name: str
    vector: Vector


class Words:
    """The table of names, and the ways to it."""

    def __init__(
        self,
        vectors: Mapping[str, Vector],
        aliases: Mapping[str, str],
        encoder: Encoder = lambda phrase: None,
    ) -> None:
        """Take the names and their unit vectors, other words for names, and what reads everything else."""
        self._vectors, self._aliases, self._encoder = dict(vectors), dict(aliases), encoder
        self._canonical = frozenset(aliases.values())

    def meaning(self, phrase: str) -> Meaning:
        """Return what a phrase means.

        Raises:
            UnknownNameError: none of its words is known.
        """
        plain = plain_words(phrase)
        name = self._reading(plain)
        if name is not None:
            return Meaning(name, self._vectors[name])
        read = self._encoder(plain)
        if read is not None:
            return Meaning(plain, read)
        hint = "or install the text encoder that reads any: pip install 'uniteam[words]'"
        raise UnknownNameError("word for a thing", phrase, self._vectors, hint)

    def _reading(self, plain: str) -> str | None:
        """Return what a phrase is known as: itself, its last words, and what is spelled nearly so."""
        head = _HEAD_ENDS.split(_MEASURES.sub("", plain))[0].split()
        for words in (plain, *(" ".join(head[first:]) for first in range(len(head)))):
            for form in _singulars(words):
                found = self._known(form)
                if found is not None:
                    return found
        for word in (plain, plain.split()[-1] if plain else ""):
            near = get_close_matches(word, [*self._vectors, *self._aliases], n=1, cutoff=_ALIKE)
            if word and near:
                return self._aliases.get(near[0], near[0])
        return None

    def _known(self, form: str) -> str | None:
        if form in self._canonical:
            return form
        if form in self._aliases:
            return self._aliases[form]
        return form if form in self._vectors else None


def plain_words(name: str) -> str:
    """Return a name or phrase in small letters, its words apart, without articles: "chest_of_drawers" is three."""
    words = re.sub(r"[^a-z0-9]+", " ", name.lower()).split()
    return " ".join(word for word in words if word not in ("a", "an", "the", "some", "my"))


def _singulars(form: str) -> tuple[str, ...]:
    if form.endswith("ies"):
        return form, form[:-3] + "y"
    if form.endswith(("ses", "shes", "ches", "xes", "oes")):
        return form, form[:-2], form[:-1]
    return (form, form[:-1]) if form.endswith("s") and not form.endswith("ss") else (form,)


@lru_cache(maxsize=1)
def load_words() -> Words:
    """Return the package's words.

    Raises:
        DamagedFileError: a file of theirs cannot be read.
    """
    try:
        with np.load(NAME_FILE) as table:
            vectors = dict(zip(map(str, table["names"]), table["vectors"].astype(np.float32), strict=True))
        data = json.loads(WORD_FILE.read_text(encoding="utf-8"))
        described = {name: _mean([vectors[part] for part in parts]) for name, parts in data["descriptions"].items()}
        aliases = {other: name for name, others in data["aliases"].items() for other in (name, *others)}
    except (OSError, ValueError, KeyError) as error:
        raise DamagedFileError(
            f"the words of perception in '{WORD_FILE.parent}' cannot be read: {error!r}; reinstall uniteam"
        ) from error
    return Words(vectors | described, aliases, encode)


def _mean(vectors: list[Vector]) -> Vector:
    total = np.sum(vectors, axis=0)
    return np.asarray(total / np.linalg.norm(total), dtype=np.float32)
