"""JSON of which every reader makes the same: no field may come twice in one object."""

import json
from typing import Any


def parse_json(text: str | bytes) -> Any:
    """Return what JSON says.

    Raises:
        ValueError: it is no JSON, or a field comes twice in one object, so that readers differ in which they take.
        RecursionError: it is nested too deeply.
    """
    return json.loads(text, object_pairs_hook=_once_each)


def _once_each(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    fields = [field for field, _ in pairs]
    if len(set(fields)) < len(fields):
        doubled = next(field for field in fields if fields.count(field) > 1)
        raise ValueError(f"the field {doubled[:100]!r} comes twice")
    return dict(pairs)
