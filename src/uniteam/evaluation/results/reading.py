"""The files of a run's directory as values."""

import logging
from collections.abc import Collection, Sequence
from pathlib import Path
from typing import Any

from uniteam.errors import DamagedFileError
from uniteam.evaluation.results.result import EpisodeResult, result_from_line
from uniteam.strict_json import parse_json

Results = dict[str, dict[str, EpisodeResult]]
"""By agent, then by episode, in the order in which they ended."""

_log = logging.getLogger(__name__)

REMEDY = "choose another directory with --out, or remove this one"


def read_configuration(path: Path) -> dict[str, Any]:
    """Return what a `config.json` says, and nothing where there is none; raises DamagedFileError."""
    if not path.exists():
        return {}
    try:
        data = parse_json(path.read_bytes())
        if not isinstance(data, dict) or not isinstance(data.get("agents"), dict):
            raise ValueError("it is not the configuration of a run")
    except (OSError, ValueError, RecursionError) as error:
        raise DamagedFileError(f"{path} cannot be read ({error}); {REMEDY}") from error
    return data


def read_results(
    lines: Sequence[bytes], path: Path, agents: Collection[str], episodes: Collection[str] | None
) -> Results:
    """Return the results that lines of a file hold.

    Args:
        lines: of JSON.
        path: of their file, to name it where something is wrong.
        agents: labels of those that there may be results of.
        episodes: ids of those that there may be results of; None where any may be.

    Raises:
        DamagedFileError: a line is no result, of another agent or episode, or contradicts one before.
    """
    results: Results = {}
    for number, line in enumerate(lines, start=1):
        try:
            agent, result = result_from_line(line)
            if agent not in agents:
                raise DamagedFileError(f"of agent '{agent}', unknown to config.json")
            if episodes is not None and result.episode not in episodes:
                raise DamagedFileError(f"of episode '{result.episode}', unknown to the split")
            first = results.setdefault(agent, {}).setdefault(result.episode, result)
            if first.measures != result.measures:
                raise DamagedFileError(f"a second result of {agent}'s episode '{result.episode}', and another one")
        except DamagedFileError as error:
            raise DamagedFileError(
                f"the results {path} are damaged (line {number} is {error}); "
                "remove that line to play its episode again, or choose another --out"
            ) from error
        if first is not result:
            _log.warning("line %d of %s repeats a result and is not counted again", number, path)
    return results
