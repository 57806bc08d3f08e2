"""Homes of a file of ProcTHOR's houses: the seed is the number of the house, and physics lets its objects settle."""

import logging
from collections import Counter
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path

from uniteam.registry import Family
from uniteam.world.generation.objects.settling import settle
from uniteam.world.homes.home import Home
from uniteam.world.homes.readers.procthor.house import read_procthor_house
from uniteam.world.homes.readers.procthor.houses_file import check_houses_path

_MOST_NAMED = 4

_log = logging.getLogger(__name__)


def procthor_home(seed: int, path: Path) -> Home:
    """Return the home of one of a file's houses, and warn of what is left out; raises what the reader does."""
    house = read_procthor_house(path, seed)
    home = settle(house.home)
    fell = Counter(i.category for i in house.home.instances) - Counter(i.category for i in home.instances)
    reasons = {"has no like here": house.unknown, "found no place": house.no_place, "did not come to rest": fell}
    said = "; ".join(f"{what} {counted(counts)}" for what, counts in reasons.items() if counts)
    if said:
        _log.warning("house %d of %s: %d things stand in it; %s", seed, path, len(home.instances), said)
    return home


def _source(argument: str) -> Callable[[int], Home]:
    path = Path(argument)
    check_houses_path(path)
    return partial(procthor_home, path=path)


PROCTHOR: Family[Callable[[int], Home]] = Family(
    "houses of ProcTHOR, from a file that you bring", "FILE.jsonl.gz", "val.jsonl.gz", _source
)


def counted(counts: Mapping[str, int]) -> str:
    """Return the commonest names with their numbers: "5 (2 Faucet, 2 Lettuce, 1 more)"."""
    common = sorted(counts.items(), key=lambda item: (-item[1], item[0]))
    rest = sum(number for _, number in common[_MOST_NAMED:])
    named = [f"{number} {name}" for name, number in common[:_MOST_NAMED]] + ([f"{rest} more"] if rest else [])
    return f"{sum(counts.values())} ({', '.join(named)})"
