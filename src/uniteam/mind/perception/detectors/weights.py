"""Where a detector's libraries and weights are from, and what to do where they are missing."""

import os
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any, TypeVar

from uniteam.errors import InvalidInputError, UnavailableError

Loaded = TypeVar("Loaded")


@dataclass(frozen=True)
class Weights:
    """A model on the Hugging Face hub, or in a folder.

    Attributes:
        model: "org/name", or the path of a folder that `save_pretrained` wrote.
        revision: a commit, tag or branch; None for the newest.
    """

    model: str
    revision: str | None = None

    @staticmethod
    def of(argument: str) -> "Weights":
        """Return what "org/name", "org/name@revision" or the path of a folder names; raises InvalidInputError."""
        if Path(argument).is_dir():
            return Weights(argument)
        model, at, revision = argument.partition("@")
        parts = model.split("/")
        if len(parts) != 2 or not all(parts) or (at and not revision) or any(c.isspace() for c in argument):
            raise InvalidInputError(
                f"'{argument}' is no model: give ORG/NAME, ORG/NAME@REVISION, or the path of a folder that is there"
            )
        return Weights(model, revision or None)

    def __str__(self) -> str:
        return self.model + (f"@{self.revision}" if self.revision else "")


def import_library(name: str, extra: str) -> Any:
    """Return a library that an extra of the package brings; raises UnavailableError with the command that does."""
    try:
        return import_module(name)
    except ImportError as error:
        raise UnavailableError(
            f"perception '{extra}' needs the package {name}, which cannot be imported ({error}); "
            f"install it with: pip install 'uniteam[{extra}]'"
        ) from error


def from_hub(load: Callable[..., Loaded], weights: Weights) -> Loaded:
    """Return what a `from_pretrained` of transformers loads; no code of a model's repository is run.

    Raises:
        UnavailableError: the model is neither at hand nor to be had.
    """
    try:
        return load(weights.model, revision=weights.revision, local_files_only=is_offline(), trust_remote_code=False)
    except ImportError as error:
        raise UnavailableError(f"model '{weights}' needs a library that is missing: {_first_line(error)}") from error
    except (OSError, ValueError) as error:
        if is_offline():
            remedy = "HF_HUB_OFFLINE is set: fetch it once on a machine with a network, or unset the variable"
        else:
            remedy = "see that name and revision are right and the network is there, or give the path of a folder"
        raise UnavailableError(f"model '{weights}' cannot be loaded ({_first_line(error)}); {remedy}") from error


def is_offline() -> bool:
    """Return whether the environment forbids to fetch anything, in the words of the Hugging Face libraries."""
    names = ("HF_HUB_OFFLINE", "TRANSFORMERS_OFFLINE")
    return any(os.environ.get(name, "").upper() in ("1", "ON", "YES", "TRUE") for name in names)


def device_of(torch: Any) -> str:
    """Return where networks run: on the GPU where PyTorch finds one."""
    return "cuda" if torch.cuda.is_available() else "cpu"


def _first_line(error: Exception) -> str:
    return str(error).strip().partition("\n")[0].rstrip(".")
