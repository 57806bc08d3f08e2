"""A configuration as plain JSON data: to be written beside every run."""

import inspect
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from typing import Any


def describe(value: Any) -> Any:
    """Return a value as JSON data: dataclasses as dictionaries with their class's name, functions by their names.

    Raises:
        TypeError: the value is of a kind that no configuration holds.
    """
    if is_dataclass(value) and not isinstance(value, type):
        return {"kind": type(value).__name__} | {f.name: describe(getattr(value, f.name)) for f in fields(value)}
    if isinstance(value, Enum):
        return value.name.lower()
    if value is None or isinstance(value, bool | int | float | str):
        return value
    if isinstance(value, Mapping):
        return {str(describe(key)): describe(item) for key, item in value.items()}
    if isinstance(value, tuple | list | set | frozenset):
        return [describe(item) for item in value]
    if inspect.isfunction(value):
        return f"{value.__module__.removeprefix('uniteam.')}.{value.__qualname__}"
    raise TypeError(f"a configuration holds a {type(value).__name__}, which cannot be described: {value!r}")
