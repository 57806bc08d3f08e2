"""The agents' figures: in all, and by what makes episodes differ."""

import logging
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from uniteam.errors import UniteamError
from uniteam.evaluation.analysis.breakdown import UNSEEN, Groups, grouped
from uniteam.evaluation.analysis.contestants import Contestant
from uniteam.evaluation.analysis.likeness import differences_of
from uniteam.evaluation.analysis.table import COLLISIONS, PERCENTAGES, STEPS
from uniteam.evaluation.results.result import EpisodeResult
from uniteam.evaluation.results.run_folder import RunFolder
from uniteam.evaluation.results.summary import Summary, summarize
from uniteam.world.task.episode import Episode
from uniteam.world.task.splits import load_split

TAGS = {
    UNSEEN: "Seen and unseen",
    "style": "Style of the home",
    "shortest_path": "Shortest path (m)",
    "least_clearance": "Least clearance on it (m)",
    "object_height": "Height of the object (m)",
    "object_pixels": "Pixels of the object in its best view",
}
"""By what success is broken down, and what it is called."""

_log = logging.getLogger(__name__)


def agents_data(contestants: Sequence[Contestant]) -> list[dict[str, Any]]:
    """Return each agent's row of the challenge's table: means with their 95 % intervals."""
    return [{"label": c.label, **_row(summarize(list(c.results.values())))} for c in contestants]


def shared_data(contestants: Sequence[Contestant]) -> list[dict[str, Any]]:
    """Return the rows over the episodes that all agents have played; none where those are all that any has, or none."""
    shared = set.intersection(*(set(c.results) for c in contestants))
    if not shared or all(len(c.results) == len(shared) for c in contestants):
        return []
    own = [replace(c, results={name: c.results[name] for name in sorted(shared)}) for c in contestants]
    return agents_data(own)


def _row(summary: Summary) -> dict[str, Any]:
    headings = {heading: (name, 100.0) for heading, name in PERCENTAGES.items()}
    headings |= {STEPS: ("num_steps", 1.0)} | {heading: (name, 1.0) for heading, name in COLLISIONS.items()}
    cells = {}
    for heading, (name, scale) in headings.items():
        estimate = summary.estimates[name]
        cells[heading] = [round(scale * value, 3) for value in (estimate.mean, estimate.low, estimate.high)]
    return {"episodes": summary.episode_count, "crashed": summary.crash_count, "cells": cells}


def tagged_episodes(contestants: Sequence[Contestant]) -> list[Episode]:
    """Return the episodes of the runs' split, which know what makes them differ.

    There are none where the runs are of several splits, or the split at hand is another: a warning says so.
    """
    names = {str(contestant.run.configuration.get("split")) for contestant in contestants}
    if len(names) > 1:
        _log.warning("success is not broken down: the runs are of the splits %s", ", ".join(sorted(names)))
        return []
    try:
        split = load_split(names.pop())
    except UniteamError as error:
        _log.warning("success is not broken down, since the split cannot be read: %s", error)
        return []
    known = {(episode.id, episode.home, str(episode.instruction)) for episode in split.episodes}
    if not all((r.episode, r.home, r.instruction) in known for c in contestants for r in c.results.values()):
        _log.warning("success is not broken down: the split '%s' at hand is not that which was played", split.name)
        return []
    return list(split.episodes)


def tags_data(contestants: Sequence[Contestant], episodes: Sequence[Episode]) -> list[dict[str, Any]]:
    """Return each agent's overall success by tag, in the groups that `uniteam evaluate --breakdown` makes."""
    played = {name for c in contestants for name in c.results}
    own = [episode for episode in episodes if episode.id in played]
    if not own or any(episode.tags is None for episode in own):
        return []
    return [{"title": title, "groups": _groups(contestants, grouped(own, tag), tag)} for tag, title in TAGS.items()]


def _groups(contestants: Sequence[Contestant], groups: Groups, tag: str) -> list[dict[str, Any]]:
    return [
        {
            "heading": heading.removeprefix(f"{tag.replace('_', ' ')} ").replace("_", " ")
            if tag != UNSEEN
            else heading,
            "agents": [_success([c.results[e.id] for e in episodes if e.id in c.results]) for c in contestants],
        }
        for heading, episodes in groups.items()
    ]


def _success(results: Sequence[EpisodeResult]) -> dict[str, Any] | None:
    if not results:
        return None
    estimate = summarize(results).estimates["overall_success"]
    return {
        "count": len(results),
        "success": [round(100.0 * value, 3) for value in (estimate.mean, estimate.low, estimate.high)],
    }


def told(runs: Sequence[RunFolder]) -> dict[str, Any]:
    """Return what the figures are from, and in what the runs differ though their agents are to be compared."""
    first = runs[0].configuration
    about = {
        "split": f"{Path(str(first.get('split'))).name} (version {first.get('split_version')})",
        "perception": str(first.get("perception")),
        "camera": str(first.get("camera")),
        "grasp": str(first.get("grasp")),
        "uniteam": f"{first.get('version')}, code {first.get('code')}",
    }
    return {"about": about, "unlike": differences_of(runs)}
