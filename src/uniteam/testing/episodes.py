"""The world in which agents and perceptions are checked: a small home of the package, and two episodes there."""

from dataclasses import replace
from functools import cache

from uniteam.world.homes.home import Home
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Episode
from uniteam.world.task.splits import load_split

_SPLIT = "minival"


@cache
def checked_episodes() -> tuple[Home, Episode, Episode]:
    """Return the home of `minival` with the fewest things in it, its episode, and the same from another start."""
    split = load_split(_SPLIT)
    home = min(split.homes.values(), key=lambda home: len(home.instances))
    first = next(episode for episode in split.episodes if episode.home == home.name)
    assert first.certificate is not None
    second = replace(first, id=f"{first.id} again", start=first.certificate.release, seed=first.seed + 1)
    return home, first, second


def new_environment() -> Environment:
    """Return that home, compiled for the first of the episodes; its observations carry the truth."""
    home, first, _ = checked_episodes()
    return Environment(home, first, give_truth=True)


@cache
def shared_environment() -> Environment:
    """Return one such environment for all who cannot reach into it: it takes a second to compile."""
    return new_environment()
