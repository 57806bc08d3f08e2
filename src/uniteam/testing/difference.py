"""Where two values differ: to the bit, arrays too."""

from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np


def first_difference(one: Any, other: Any, path: str) -> str:
    """Return the path to the first thing in which two values differ ("decision.action.x"); empty where they are equal.

    Args:
        one: a dataclass, a sequence, an array or a plain value; whatever these hold may be one of them too.
        other: what it is compared with.
        path: what to call the two.
    """
    if one is other:
        return ""
    if type(one) is not type(other):
        return path
    if isinstance(one, np.ndarray):
        is_equal = one.dtype == other.dtype and one.shape == other.shape and one.tobytes() == other.tobytes()
        return "" if is_equal else path
    if is_dataclass(one):
        pairs = [(getattr(one, f.name), getattr(other, f.name), f"{path}.{f.name}") for f in fields(one)]
    elif isinstance(one, tuple | list):
        if len(one) != len(other):
            return path
        pairs = [(a, b, f"{path}[{i}]") for i, (a, b) in enumerate(zip(one, other, strict=True))]
    else:
        return "" if _is_same(one, other) else path
    return next((found for a, b, name in pairs if (found := first_difference(a, b, name))), "")


def _is_same(one: object, other: object) -> bool:
    """Compare plain values; not a number is itself, and 0.0 is not -0.0."""
    return repr(one) == repr(other) if isinstance(one, float | np.floating) else bool(one == other)
