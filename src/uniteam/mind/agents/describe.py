"""A configuration as plain JSON data: to be written beside every run."""

import inspect
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import partial
from typing import Any

from uniteam.errors import InvalidInputError


def describe(value: Any) -> Any:
    """Return a value as JSON data: dataclasses as dictionaries with their class's name, functions by their names.

    Raises:
        InvalidInputError: the value is of a kind that no configuration holds, or a function without a name of its own.
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
    if isinstance(value, partial):
        given = {str(key): describe(item) for key, item in value.keywords.items()}
        return {
            "kind": "partial",
            "function": describe(value.func),
            "arguments": [describe(a) for a in value.args],
            **given,
        }
    if inspect.isfunction(value):
        if "<" in value.__qualname__:  # two lambdas would be described alike
            raise InvalidInputError(
                f"a configuration holds {value.__qualname__} of {value.__module__}, which has no name of its own; "
                "define it with 'def' at the top of its module"
            )
        return f"{value.__module__.removeprefix('uniteam.')}.{value.__qualname__}"
    raise InvalidInputError(
        f"a configuration holds a {type(value).__name__}, which cannot be described ({value!r}); use a frozen dataclass"
    )
