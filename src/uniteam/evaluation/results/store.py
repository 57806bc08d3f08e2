"""A run's directory: the resolved configuration, one line of results an episode, and the summary.

`config.json` says what was run, `results.jsonl` grows by a line as each episode ends, `lost.jsonl` by one for each
episode that came to nothing by no fault of the agent (it counts for nothing and is played again), and `summary.json` is
written at the end. A directory can be taken up again by the same configuration, and further agents may join it;
anything else that differs is refused, so that figures of different runs never mix. A row that occurs twice counts once,
with a word in the log; rows that contradict each other, or belong to no episode or agent of the run, are refused.
"""

import json
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Any

from uniteam.errors import DamagedFileError, InvalidInputError
from uniteam.evaluation.results.differences import differences
from uniteam.evaluation.results.journal import Journal
from uniteam.evaluation.results.lock import FolderLock
from uniteam.evaluation.results.reading import REMEDY, Results, read_configuration, read_results
from uniteam.evaluation.results.result import EpisodeResult, result_to_line
from uniteam.files import try_folder, write_json


class ResultStore:
    """The results in one directory, which no other process can write into until `close`."""

    def __init__(self, directory: Path, configuration: Mapping[str, Any], episodes: Collection[str]) -> None:
        """Begin or take up a run.

        Args:
            directory: made where it does not exist.
            configuration: plain JSON data; `agents` maps each agent's label to its own resolved configuration.
            episodes: ids of every episode that there can be results of.

        Raises:
            InvalidInputError: the directory holds results of another configuration.
            DamagedFileError: the directory's files cannot be read.
            UnwritableError: they cannot be written.
            FolderInUseError: another run writes into it.
        """
        self.directory = directory
        try_folder(directory)
        self._lock = FolderLock(directory)
        try:
            self._open(configuration, episodes)
        except BaseException:
            self.close()
            raise

    def _open(self, configuration: Mapping[str, Any], episodes: Collection[str]) -> None:
        path = self.directory / "config.json"
        recorded = read_configuration(path)
        _check_same(self.directory, recorded, configuration)
        agents = {**recorded.get("agents", {}), **configuration["agents"]}
        self.agents = tuple(agents)
        self._journal = Journal(self.directory / "results.jsonl")
        if self._journal.lines and not recorded:
            raise DamagedFileError(f"{path} is missing beside results, so nobody knows what they are of; {REMEDY}")
        self.results: Results = read_results(self._journal.lines, self._journal.path, agents, episodes)
        self._lost = Journal(self.directory / "lost.jsonl")
        if recorded != {**configuration, "agents": agents}:
            write_json(self.directory / "config.json", {**configuration, "agents": agents})

    def append(self, agent: str, result: EpisodeResult) -> None:
        """Record an episode's result; it is on the disk when this returns, or raises UnwritableError."""
        self._journal.append(result_to_line(agent, result))
        self.results.setdefault(agent, {})[result.episode] = result

    def record_lost(self, agent: str, episode: str, reason: str, traceback: str) -> None:
        """Keep why an episode came to nothing; it has no result."""
        entry = {"agent": agent, "episode": episode, "reason": reason, "traceback": traceback}
        self._lost.append(json.dumps(entry) + "\n")

    def write_summary(self, summary: Mapping[str, Any]) -> None:
        """Write `summary.json`; raises UnwritableError."""
        write_json(self.directory / "summary.json", summary)

    def close(self) -> None:
        """Let other processes have the directory."""
        self._lock.release()


def _check_same(directory: Path, recorded: Mapping[str, Any], wanted: Mapping[str, Any]) -> None:
    if not recorded:
        return
    shared = {agent: own for agent, own in wanted["agents"].items() if agent in recorded["agents"]}
    try:
        found = differences(recorded, {**wanted, "agents": {**recorded["agents"], **shared}})
    except RecursionError:
        found = ["config.json is nested too deeply"]
    if found:
        raise InvalidInputError(
            f"{directory} holds results of another configuration ({'; '.join(found[:5])}); {REMEDY}"
        )
