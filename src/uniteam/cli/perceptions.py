"""A perception as the options of a command name it."""

import re

from uniteam.errors import InvalidInputError


def perception_name(perception: str, model: str | None, revision: str | None) -> str:
    """Return the name of a perception with the model that `--model` and `--revision` choose, "NAME:MODEL@REVISION".

    Raises:
        InvalidInputError: a model is given twice, or a revision without a model.
    """
    if model is None and revision is None:
        return perception
    if model is None or not model:
        raise InvalidInputError(f"--revision {revision} needs the model that it is of; give --model ORG/NAME too")
    if ":" in perception:
        raise InvalidInputError(f"'{perception}' names a model after the colon, and --model {model} another; give one")
    return f"{perception}:{model}" + (f"@{revision}" if revision else "")


def as_folder(perception: str) -> str:
    """Return a perception's name as it may stand in the name of a folder."""
    return re.sub(r"[^\w.@+-]+", ".", perception).strip(".")[:120]
