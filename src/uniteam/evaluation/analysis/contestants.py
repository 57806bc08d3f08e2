"""The agents of runs that are compared, as they are named on the command line, and the episodes that all played."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.evaluation.results.run_folder import RunFolder, read_run


@dataclass(frozen=True)
class Contestant:
    """One agent of one run.

    Attributes:
        label: by which tables call it, unlike all others'.
        agent: its label in the run.
        run: in which it played.
        results: by episode.
    """

    label: str
    agent: str
    run: RunFolder
    results: Mapping[str, EpisodeResult]


def contestants_named(names: Iterable[str]) -> list[Contestant]:
    """Return the agents that "RUN" (all of them) or "RUN:AGENT" name, each once, in their order.

    Raises:
        UniteamError: a folder that is no run, or an agent that it has no results of.
    """
    runs: dict[Path, RunFolder] = {}
    chosen: dict[tuple[Path, str], None] = {}
    for name in names:
        directory, agent = _parted(name)
        run = runs[directory] = runs.get(directory) or read_run(directory)
        if agent and agent not in run.results:
            raise UnknownNameError(f"agent with results in '{directory}'", agent, run.results)
        chosen |= {(directory, one): None for one in ([agent] if agent else run.results)}
    agents = [agent for _, agent in chosen]
    return [
        Contestant(agent if agents.count(agent) == 1 else f"{at}: {agent}", agent, runs[at], runs[at].results[agent])
        for at, agent in chosen
    ]


def _parted(name: str) -> tuple[Path, str]:
    """Return the folder and the agent's label, which may itself hold colons."""
    ends = [k for k, character in enumerate(name) if character == ":"]
    for end in (len(name), *reversed(ends)):
        if name[:end] and Path(name[:end]).is_dir():
            return Path(name[:end]), name[end + 1 :]
    raise InvalidInputError(
        f"'{name}' names no folder; give the folder of a run, or FOLDER:AGENT for one of its agents"
    )


def shared_episodes(contestants: Sequence[Contestant]) -> list[str]:
    """Return the ids of the episodes that all have played, in the order of their names.

    What has one id but another home or another request is not the same episode.

    Raises:
        InvalidInputError: they share none.
    """
    first, *others = contestants
    shared = [
        name
        for name, result in first.results.items()
        if all(name in other.results and _same(result, other.results[name]) for other in others)
    ]
    if not shared:
        raise InvalidInputError(
            f"{', '.join(c.label for c in contestants)} have played no episode in common; "
            "agents are compared on the same episodes only"
        )
    return sorted(shared)


def _same(one: EpisodeResult, other: EpisodeResult) -> bool:
    return (one.home, one.instruction) == (other.home, other.instruction)
