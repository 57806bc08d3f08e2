"""What differs between two trees of plain data, in words."""

import json
from typing import Any


def differences(recorded: Any, wanted: Any, path: str = "") -> list[str]:
    """Return a phrase for each leaf that differs between two trees of plain data."""
    if isinstance(recorded, dict) and isinstance(wanted, dict):
        keys = sorted({*recorded, *wanted})
        nested = (
            differences(recorded.get(key, "nothing"), wanted.get(key, "nothing"), f"{path}.{key}" if path else key)
            for key in keys
        )
        return [phrase for phrases in nested for phrase in phrases]
    if type(recorded) is type(wanted) and recorded == wanted:
        return []
    return [f"{path} was {_shown(recorded)} and is now {_shown(wanted)}"]


def _shown(value: Any) -> str:
    text = value if isinstance(value, str) else json.dumps(value)
    return text if len(text) <= 60 else text[:57] + "..."
