"""A run's directory as it is read to say something about it: nothing in it changes, and it may still be growing."""

import logging
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.evaluation.results.reading import Results, read_configuration, read_results

_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class RunFolder:
    """What a run's directory holds.

    Attributes:
        directory: where it is.
        configuration: all that the results depend on, as plain JSON data.
        results: by agent, in the order of the configuration, then by episode; only agents that have any.
    """

    directory: Path
    configuration: Mapping[str, Any]
    results: Results


def read_run(directory: Path) -> RunFolder:
    """Return what a run's directory holds.

    Raises:
        InvalidInputError: it is not the directory of a run.
        DamagedFileError: a file of it cannot be read.
    """
    configuration = read_configuration(directory / "config.json")
    path = directory / "results.jsonl"
    if not configuration or not path.is_file():
        raise InvalidInputError(
            f"'{directory}' is not the folder of a run, which holds config.json and results.jsonl; give one that "
            "'uniteam evaluate' wrote"
        )
    results = read_results(_whole_lines(path), path, configuration["agents"], None)
    in_order = {agent: results[agent] for agent in configuration["agents"] if agent in results}
    return RunFolder(directory, configuration, in_order)


def _whole_lines(path: Path) -> list[bytes]:
    """Return the lines but for a last one without its end, which is still being written or was torn."""
    try:
        *lines, last = path.read_bytes().split(b"\n")
    except OSError as error:
        raise DamagedFileError(f"'{path}' cannot be read ({error.strerror})") from error
    if last:
        _log.warning("the last line of %s was not written to its end and is not counted", path)
    return lines
