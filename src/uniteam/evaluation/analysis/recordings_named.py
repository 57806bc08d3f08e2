"""The recordings that people name: by their files, or by a run and an episode."""

from collections.abc import Sequence
from pathlib import Path

from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.evaluation.analysis.contestants import Contestant, contestants_named
from uniteam.evaluation.recording.order import RECORDINGS, SUFFIX, recording_path

_USAGE = "give one FILE.zip or two, or RUN EPISODE and perhaps another RUN; RUN:AGENT is one agent of a run"


def recordings_named(words: Sequence[str]) -> list[Path]:
    """Return the files of one recording, or of two.

    Args:
        words: "FILE", "FILE FILE", "RUN EPISODE" or "RUN EPISODE RUN", where a RUN may be "RUN:AGENT".

    Raises:
        InvalidInputError: the words are none of these, or name no recording, or more than two.
        UniteamError: a folder is no run, or an agent or an episode is not in it.
    """
    if 1 <= len(words) <= 2 and all(word.endswith(SUFFIX) for word in words):
        return [Path(word) for word in words]
    if not 2 <= len(words) <= 3:
        raise InvalidInputError(f"{len(words)} words name no recording; {_USAGE}")
    run, episode, *others = words
    found = [path for name in (run, *others) for path in _of_run(name, episode)]
    if len(found) > 2:
        raise InvalidInputError(
            f"{len(found)} agents have a recording of '{episode}' there, and a page shows two at most; "
            "name them as RUN:AGENT"
        )
    return found


def all_recordings_named(words: Sequence[str]) -> list[Path]:
    """Return the files of recordings that are named one by one, and all recordings of runs, each once.

    Args:
        words: each a "FILE", a "RUN" for all its agents, or "RUN:AGENT".

    Raises:
        InvalidInputError: there is no word, or a run has no recording.
        UniteamError: a folder is no run, or an agent is not in it.
    """
    if not words:
        raise InvalidInputError("give recordings: FILE.zip, or the folder of a run, RUN or RUN:AGENT")
    found: dict[Path, None] = {}
    for word in words:
        files = [Path(word)] if word.endswith(SUFFIX) else _all_of_run(word)
        found |= dict.fromkeys(files)
    return list(found)


def _all_of_run(name: str) -> list[Path]:
    """Return all recordings of the agents that "RUN" or "RUN:AGENT" names; at least one."""
    paths = (recording_of(agent, episode) for agent in contestants_named([name]) for episode in agent.results)
    found = [path for path in paths if path.is_file()]
    if not found:
        raise InvalidInputError(
            f"'{name}' has no recording; play it with 'uniteam evaluate --record all' into a new folder"
        )
    return found


def _of_run(name: str, episode: str) -> list[Path]:
    """Return the recordings of an episode by the agents that "RUN" or "RUN:AGENT" names; at least one."""
    agents = contestants_named([name])
    if not any(episode in agent.results for agent in agents):
        raise UnknownNameError(f"episode of '{name}'", episode, {each for agent in agents for each in agent.results})
    found = [path for agent in agents if (path := recording_of(agent, episode)).is_file()]
    if not found:
        raise InvalidInputError(
            f"'{name}' has no recording of '{episode}'; play it with 'uniteam evaluate --record all' into a new "
            "folder, or with 'uniteam run --record FILE'"
        )
    return found


def recording_of(contestant: Contestant, episode: str) -> Path:
    """Return where the recording of an episode lies, if there is one."""
    folder = contestant.run.directory / RECORDINGS
    return recording_path(folder, contestant.agent, episode)
