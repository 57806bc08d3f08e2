"""The standings of a run's agents, scored anew from the line of each episode."""

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

from uniteam.evaluation.results.result import EpisodeResult
from uniteam.evaluation.results.run_folder import RunFolder
from uniteam.evaluation.results.summary import Summary, summarize

LIVED_IN = "lived_in"
"""Stands in the names of homes of that style."""

PARTS: Mapping[str, Callable[[EpisodeResult], bool]] = {
    "tidy": lambda result: LIVED_IN not in result.home,
    "lived in": lambda result: LIVED_IN in result.home,
    "seen": lambda result: not result.unseen,
    "unseen": lambda result: result.unseen,
}
"""Parts of the episodes: by the style of the home, and by whether the object's category is in a training home."""


@dataclass(frozen=True)
class Standing:
    """One agent's figures.

    Attributes:
        agent: its label.
        summary: over all its episodes.
        parts: over those of each of `PARTS` that it has played any of.
    """

    agent: str
    summary: Summary
    parts: Mapping[str, Summary]


@dataclass(frozen=True)
class Standings:
    """The agents of one run.

    Attributes:
        told: what the figures are from.
        own: each agent over all that it has played, the best first.
        shared: the agents over the episodes that all have played; empty where those are all, or none.
    """

    told: str
    own: Sequence[Standing]
    shared: Sequence[Standing]


def standings_of(run: RunFolder, but_homes: Collection[str] = ()) -> Standings:
    """Return a run's standings; `but_homes` are left out, as those that an agent was watched in while it was made."""
    played = {
        agent: {name: result for name, result in own.items() if result.home not in but_homes}
        for agent, own in run.results.items()
    }
    played = {agent: own for agent, own in played.items() if own}
    shared = set.intersection(*(set(own) for own in played.values())) if played else set()
    has_all_shared = all(len(own) == len(shared) for own in played.values())
    in_common = {agent: [own[name] for name in sorted(shared)] for agent, own in played.items()}
    return Standings(
        _told(run),
        _ranked({agent: list(own.values()) for agent, own in played.items()}),
        [] if has_all_shared or not shared else _ranked(in_common),
    )


def _ranked(played: Mapping[str, Sequence[EpisodeResult]]) -> list[Standing]:
    found = [Standing(agent, summarize(own), _by_part(own)) for agent, own in played.items()]
    return sorted(
        found, key=lambda standing: (-_mean(standing, "overall_success"), -_mean(standing, "partial_success"))
    )


def _mean(standing: Standing, measure: str) -> float:
    return standing.summary.estimates[measure].mean


def _by_part(results: Iterable[EpisodeResult]) -> dict[str, Summary]:
    every = list(results)
    parts = {part: [result for result in every if belongs(result)] for part, belongs in PARTS.items()}
    return {part: summarize(own) for part, own in parts.items() if own}


def _told(run: RunFolder) -> str:
    told = run.configuration
    return (
        f"Split `{told.get('split')}` version {told.get('split_version')}, perception `{told.get('perception')}`, "
        f"{told.get('camera')}-size camera, grasp {told.get('grasp')}, uniteam {told.get('version')}, "
        f"code {told.get('code')}"
    )
