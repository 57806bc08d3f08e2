"""Groups of episodes by one of their facts, so that a table can have a row for each."""

from collections.abc import Callable, Sequence
from dataclasses import fields

import numpy as np

from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.world.task.episode import Episode
from uniteam.world.task.tags import Tags

UNSEEN = "unseen"
FACTS = (UNSEEN, *(field.name for field in fields(Tags)))
"""By what episodes can be grouped: whether the object's category is in no training home, or a tag."""

FEW = 4
"""A number that has no more values than this in all episodes makes a group of each; others are cut into thirds."""

Groups = dict[str, list[Episode]]


def grouped(episodes: Sequence[Episode], fact: str) -> Groups:
    """Return the episodes by group, the groups in their order, each under a heading for people.

    Raises:
        UnknownNameError: there is no such fact.
        InvalidInputError: an episode has no tags.
    """
    if fact not in FACTS:
        raise UnknownNameError("tag", fact, FACTS)
    if fact == UNSEEN:
        return _by_value(episodes, lambda e: e.unseen, lambda unseen: f"{'un' if unseen else ''}seen categories")
    untagged = next((episode.id for episode in episodes if episode.tags is None), None)
    if untagged is not None:
        raise InvalidInputError(
            f"episode '{untagged}' has no tags to break down by; make its split anew with this version of uniteam"
        )
    values = {episode.id: getattr(episode.tags, fact) for episode in episodes}
    words = fact.replace("_", " ")
    if isinstance(next(iter(values.values()), ""), str) or len(set(values.values())) <= FEW:
        return _by_value(episodes, lambda e: values[e.id], lambda value: f"{words} {value}")
    return _by_thirds(episodes, values, words)


def _by_value(
    episodes: Sequence[Episode], value_of: Callable[[Episode], object], heading: Callable[[object], str]
) -> Groups:
    groups: Groups = {}
    for value in sorted({value_of(episode) for episode in episodes}):  # type: ignore[type-var]
        groups[heading(value)] = [episode for episode in episodes if value_of(episode) == value]
    return groups


def _by_thirds(episodes: Sequence[Episode], values: dict[str, float], words: str) -> Groups:
    """Return three groups of about the same size; episodes of equal value are in one."""
    borders = np.quantile(list(values.values()), (1 / 3, 2 / 3))
    third = {name: int(np.searchsorted(borders, value, side="left")) for name, value in values.items()}
    groups: Groups = {}
    for k in sorted(set(third.values())):
        own = [episode for episode in episodes if third[episode.id] == k]
        low, high = min(values[e.id] for e in own), max(values[e.id] for e in own)
        groups[f"{words} {low:g}" if low == high else f"{words} {low:g} to {high:g}"] = own
    return groups
