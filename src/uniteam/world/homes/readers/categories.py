"""What HSSD's models are called: tables of classes, in the two forms that there are.

`semantics/objects.csv` of the scenes has a line a model with its `id` and `main_category`; `hssd-receptacles.csv`,
which comes with the challenge's objects, has the class that the challenge gives a piece of furniture, with or without
a heading.
"""

import csv
import io
from collections.abc import Iterable, Mapping
from pathlib import Path

from uniteam.world.assets.reading import read_bytes

MOST_BYTES = 64 * 1024 * 1024

_KEYS = ("id", "name")
_CLASSES = ("clean_category", "main_category", "category")


def read_categories(path: Path) -> Mapping[str, str]:
    """Return the class of each model that a table names; empty where there is no such file.

    Raises:
        DamagedFileError: the file cannot be read.
    """
    if not path.exists():
        return {}
    text = read_bytes(path, "the table of classes", MOST_BYTES).decode("utf-8-sig", "replace")
    rows = [row for row in csv.reader(io.StringIO(text)) if len(row) > 1]
    if not rows:
        return {}
    heading = [cell.strip() for cell in rows[0]]
    kind = next((heading.index(name) for name in _CLASSES if name in heading), None)
    keys = [heading.index(name) for name in _KEYS if name in heading]
    if kind is None or not keys:
        return _table(rows, (0,), 1)
    return _table(rows[1:], keys, kind)


def clean(category: str) -> str:
    """Return a class as the challenge writes it: no spaces, nothing from a full stop on."""
    return category.strip().partition(".")[0].replace(" ", "_").lower()


def _table(rows: Iterable[list[str]], keys: Iterable[int], kind: int) -> dict[str, str]:
    return {
        row[key].strip(): clean(row[kind])
        for row in rows
        for key in keys
        if max(key, kind) < len(row) and row[key].strip() and clean(row[kind])
    }
