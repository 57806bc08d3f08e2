"""A run's directory: the resolved configuration, one line of results an episode, and the summary.

`config.json` says what was run, `results.jsonl` grows by a line as each episode ends, `summary.json` is written at the
end. A directory can be taken up again by the same configuration, and further agents may join it; anything else that
differs is refused, so that figures of different runs never mix.
"""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.evaluation.results.result import EpisodeResult, result_from_line, result_to_line

Results = dict[str, dict[str, EpisodeResult]]
"""By agent, then by episode, in the order in which they ended."""


class ResultStore:
    """The results in one directory."""

    def __init__(self, directory: Path, configuration: Mapping[str, Any]) -> None:
        """Begin or take up a run.

        Args:
            directory: made where it does not exist.
            configuration: plain JSON data; `agents` maps each agent's label to its own resolved configuration.

        Raises:
            InvalidInputError: the directory holds results of another configuration.
            DamagedFileError: the directory's files cannot be read.
        """
        self.directory = directory
        self._lines = directory / "results.jsonl"
        recorded = _read_configuration(directory / "config.json")
        _check_same(directory, recorded, _plain(configuration))
        agents = {**recorded.get("agents", {}), **configuration["agents"]}
        self.results = _read_results(self._lines, agents)
        directory.mkdir(parents=True, exist_ok=True)
        _write(directory / "config.json", {**configuration, "agents": agents})

    def append(self, agent: str, result: EpisodeResult) -> None:
        """Record an episode's result; it is on disk when this returns."""
        self.results.setdefault(agent, {})[result.episode] = result
        with self._lines.open("a", encoding="utf-8") as file:
            file.write(result_to_line(agent, result))

    def write_summary(self, summary: Mapping[str, Any]) -> None:
        """Write `summary.json`."""
        _write(self.directory / "summary.json", summary)


def _plain(data: Mapping[str, Any]) -> dict[str, Any]:
    """Return the data as it comes back from JSON (tuples as lists)."""
    plain: dict[str, Any] = json.loads(json.dumps(data))
    return plain


def _write(path: Path, data: Mapping[str, Any]) -> None:
    partial = path.with_name(path.name + ".partial")
    partial.write_text(json.dumps(data, indent=2) + "\n", encoding="utf-8")
    partial.replace(path)


def _read_configuration(path: Path) -> dict[str, Any]:
    if not path.exists():
        return {}
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        if not isinstance(data, dict) or not isinstance(data.get("agents"), dict):
            raise ValueError("it is not the configuration of a run")
    except (OSError, ValueError) as error:
        raise DamagedFileError(
            f"{path} cannot be read ({error}); remove the directory {path.parent} or choose another with --out"
        ) from error
    return data


def _read_results(path: Path, agents: Mapping[str, Any]) -> Results:
    """Read the results and cut off a last line that was not written to its end."""
    results: Results = {}
    if not path.exists():
        return results
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, ValueError) as error:
        raise DamagedFileError(_damaged_message(path, str(error))) from error
    whole = text[: text.rfind("\n") + 1]
    for number, line in enumerate(whole.splitlines(), start=1):
        try:
            agent, result = result_from_line(line)
        except DamagedFileError as error:
            raise DamagedFileError(_damaged_message(path, f"line {number} is {error}")) from error
        if agent not in agents:
            raise DamagedFileError(
                _damaged_message(path, f"line {number} is of agent '{agent}', unknown to config.json")
            )
        results.setdefault(agent, {})[result.episode] = result
    if whole != text:
        path.write_text(whole, encoding="utf-8")
    return results


def _damaged_message(path: Path, what: str) -> str:
    return (
        f"the results {path} are damaged ({what}); remove that line to play its episode again, or choose another --out"
    )


def _check_same(directory: Path, recorded: Mapping[str, Any], wanted: Mapping[str, Any]) -> None:
    if not recorded:
        return
    shared = {agent: own for agent, own in wanted["agents"].items() if agent in recorded["agents"]}
    differences = _differences(recorded, {**wanted, "agents": {**recorded["agents"], **shared}})
    if differences:
        raise InvalidInputError(
            f"{directory} holds results of another configuration ({'; '.join(differences[:5])}); "
            f"choose another directory with --out, or remove this one"
        )


def _differences(recorded: Any, wanted: Any, path: str = "") -> list[str]:
    """Return a phrase for each leaf that differs between two trees of plain data."""
    if isinstance(recorded, dict) and isinstance(wanted, dict):
        keys = sorted({*recorded, *wanted})
        nested = (
            _differences(recorded.get(key, "nothing"), wanted.get(key, "nothing"), f"{path}.{key}" if path else key)
            for key in keys
        )
        return [phrase for phrases in nested for phrase in phrases]
    return [] if recorded == wanted else [f"{path} was {_shown(recorded)} and is now {_shown(wanted)}"]


def _shown(value: Any) -> str:
    text = value if isinstance(value, str) else json.dumps(value)
    return text if len(text) <= 60 else text[:57] + "..."
