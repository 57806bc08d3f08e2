"""A house of ProcTHOR as a home of ours, and an account of what is not in it."""

import re
from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from uniteam.errors import DamagedFileError
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.assets.reading import damaged
from uniteam.world.homes.check import home_problems
from uniteam.world.homes.home import Home
from uniteam.world.homes.readers.procthor.classes import ASSET_DATABASE, read_asset_database
from uniteam.world.homes.readers.procthor.furnishing import Furnisher
from uniteam.world.homes.readers.procthor.houses_file import read_house
from uniteam.world.homes.readers.procthor.stage import UnknownWallError, stage_of


@dataclass(frozen=True)
class ProcthorHouse:
    """A house that was read.

    Attributes:
        home: with its objects a little above where they are to lie.
        unknown: types of AI2-THOR that have no like here, and how many of each were left out.
        no_place: types that found no place on what they lay on, and how many of each were left out.
    """

    home: Home
    unknown: Mapping[str, int]
    no_place: Mapping[str, int]


def read_procthor_house(path: Path, number: int = 0) -> ProcthorHouse:
    """Return a house of a file of ProcTHOR, furnished with models of the package.

    Sizes of assets are taken from an `asset-database.json` beside the file, where there is one.

    Args:
        path: `*.jsonl.gz` with a house a line, or `*.json` with one.
        number: which of the houses, from 0.

    Raises:
        InvalidInputError: there is no such file, or it does not hold so many houses.
        DamagedFileError: the file cannot be read, or what stands there is no sound house.
    """
    house = read_house(path, number)
    assets = read_asset_database(path.parent / ASSET_DATABASE)
    try:
        stage = stage_of(house)
    except UnknownWallError as error:
        raise _unsound(path, number, str(error)) from error
    furnisher = Furnisher(stage, load_catalogue(), assets)
    for entry in house.objects:
        furnisher.put(entry)
    home = Home(_name(path, number), stage, tuple(furnisher.instances), furnisher.library, number)
    problem = next(home_problems(home), None)
    if problem is not None:
        raise _unsound(path, number, problem)
    return ProcthorHouse(home, Counter(furnisher.unknown), Counter(furnisher.no_place))


def _unsound(path: Path, number: int, reason: str) -> DamagedFileError:
    return damaged(path, f"house {number} of", reason)


def _name(path: Path, number: int) -> str:
    return f"procthor-{re.sub(r'[^A-Za-z0-9_-]', '_', path.name.partition('.')[0])}-{number}"
