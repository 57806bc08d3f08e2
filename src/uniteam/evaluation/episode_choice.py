"""Which episodes of a split a run plays: some homes' first, and one shard's of several."""

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import chain, zip_longest

from uniteam.errors import InvalidInputError
from uniteam.world.task.episode import Episode


@dataclass(frozen=True)
class Shard:
    """One of several parts of a run that are played apart, and merged.

    Attributes:
        number: from 1 to `count`.
        count: how many parts there are.
    """

    number: int
    count: int


def shard_named(name: str) -> Shard:
    """Return the shard that "2/4" names, the second of four; raises InvalidInputError."""
    match = re.fullmatch(r"(\d{1,6})/(\d{1,6})", name, re.ASCII)
    number, count = (int(match[1]), int(match[2])) if match else (0, 0)
    if not 1 <= number <= count:
        raise InvalidInputError(f"a shard is given as I/N, such as 2/4 for the second of four, not '{name}'")
    return Shard(number, count)


def choose_episodes(episodes: Iterable[Episode], count: int | None) -> list[int]:
    """Return the indices of the first `count` episodes, taken from the homes in turn so that a few show many homes."""
    by_home: dict[str, list[int]] = {}
    for index, episode in enumerate(episodes):
        by_home.setdefault(episode.home, []).append(index)
    in_turn = [index for index in chain.from_iterable(zip_longest(*by_home.values())) if index is not None]
    return in_turn[:count]


def deal(episodes: Sequence[Episode], chosen: Sequence[int], shard: Shard) -> list[int]:
    """Return a shard's part of the chosen indices, in their order.

    Parts differ by one episode at most. Laid out home by home the episodes are cut into runs, so that a home, which
    takes seconds to open, is shared by two shards only where a cut falls into it.

    Raises:
        InvalidInputError: there are more shards than episodes.
    """
    if shard.count > len(chosen):
        raise InvalidInputError(f"{len(chosen)} episodes cannot be dealt to {shard.count} shards; ask for fewer shards")
    by_home: dict[str, list[int]] = {}
    for index in chosen:
        by_home.setdefault(episodes[index].home, []).append(index)
    laid_out = list(chain.from_iterable(by_home.values()))
    first, last = (len(laid_out) * k // shard.count for k in (shard.number - 1, shard.number))
    own = set(laid_out[first:last])
    return [index for index in chosen if index in own]
