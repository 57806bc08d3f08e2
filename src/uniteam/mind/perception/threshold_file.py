"""The thresholds of `class_thresholds`, from a file: by what a class is to the instruction, and by its name.

A missed object ends the episode, so little evidence is enough to go and look; a wrong goal receptacle costs it.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Literal

import msgspec

from uniteam.errors import DamagedFileError
from uniteam.mind.perception.filters import Fall, Thresholds
from uniteam.mind.perception.vocabulary import ClassRole
from uniteam.strict_json import parse_json

THRESHOLD_FILE = Path(__file__).with_name("thresholds.json")
"""The package's own; `by_class` holds the classes for which a perception has been measured."""


RoleName = Literal["object", "start_receptacle", "goal_receptacle"]


class FallData(msgspec.Struct, forbid_unknown_fields=True):
    """A `Fall`, as the file has it."""

    first_step: Annotated[int, msgspec.Meta(ge=0)]
    last_step: Annotated[int, msgspec.Meta(ge=1)]
    to: Annotated[float, msgspec.Meta(ge=0.0, le=1.0)]


def read_thresholds(path: Path = THRESHOLD_FILE) -> Thresholds:
    """Return the thresholds of a JSON file with "by_role", "other" and "by_class", each a score in [0, 1].

    It may say how a role's fall with the steps: "falls", of each role "first_step", "last_step" and the share "to" that
    is left.

    Raises:
        DamagedFileError: the file cannot be read as that; the message names the file and the field.
    """
    try:
        data = parse_json(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise DamagedFileError(
            f"'{path}' must be a JSON file of thresholds, but cannot be read: {error}; mend or replace it"
        ) from error
    fields = data if isinstance(data, dict) else {}
    names = {role.name.lower() for role in ClassRole}
    by_role = _scores(path, fields, "by_role")
    if set(by_role) != names:
        raise DamagedFileError(
            f"'{path}' must give 'by_role' for {', '.join(sorted(names))}, got {', '.join(sorted(by_role)) or 'none'}; "
            "give each of them once"
        )
    other = _scores(path, {"other": {"other": fields.get("other")}}, "other")["other"]
    return Thresholds(
        {role: by_role[role.name.lower()] for role in ClassRole},
        other,
        _scores(path, fields, "by_class"),
        _falls(path, fields.get("falls", {})),
    )


def _falls(path: Path, given: object) -> dict[ClassRole, Fall]:
    try:
        falls = msgspec.convert(given, dict[RoleName, FallData])
    except msgspec.ValidationError as error:
        raise DamagedFileError(f"'{path}' must say in 'falls' how thresholds fall: {error}; correct it") from error
    for name, fall in falls.items():
        if fall.first_step >= fall.last_step:
            raise DamagedFileError(
                f"'{path}' must have a 'last_step' after the 'first_step' in the fall of '{name}', got "
                f"{fall.first_step} to {fall.last_step}; correct it"
            )
    return {ClassRole[name.upper()]: Fall(fall.first_step, fall.last_step, fall.to) for name, fall in falls.items()}


def _scores(path: Path, fields: Mapping[str, object], name: str) -> dict[str, float]:
    values = fields.get(name)
    if not isinstance(values, dict):
        raise DamagedFileError(f"'{path}' must have an object '{name}' of scores, got {values!r}; add one")
    for key, score in values.items():
        if isinstance(score, bool) or not isinstance(score, int | float) or not 0.0 <= score <= 1.0:
            raise DamagedFileError(f"'{path}' must give {name} '{key}' a score in [0, 1], got {score!r}; correct it")
    return {key: float(score) for key, score in values.items()}
