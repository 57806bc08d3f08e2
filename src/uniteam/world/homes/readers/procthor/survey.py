"""What of a file's houses can be read, before anything is made of them."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from uniteam.errors import DamagedFileError
from uniteam.world.homes.readers.procthor.classes import ASSET_DATABASE
from uniteam.world.homes.readers.procthor.house import read_procthor_house
from uniteam.world.homes.readers.procthor.houses_file import check_houses_path, count_houses

MOST_LOOKED_AT = 50


@dataclass(frozen=True)
class HousesSurvey:
    """What was found in a file of houses.

    Attributes:
        houses: how many it holds.
        looked_at: how many of them, from the first on, were read.
        has_sizes: whether an `asset-database.json` lies beside it.
        faults: the sentence about each house that cannot be read, by its number.
        stood: how many things stand in the others.
        unknown: types without a like here, and how many were left out.
        no_place: types that found no place, and how many were left out.
    """

    houses: int
    looked_at: int
    has_sizes: bool
    faults: Mapping[int, str]
    stood: int
    unknown: Mapping[str, int]
    no_place: Mapping[str, int]


def survey_houses(path: Path) -> HousesSurvey:
    """Read the first houses of a file, at most `MOST_LOOKED_AT`; physics does not settle their objects yet.

    Raises:
        InvalidInputError: there is no such file.
        DamagedFileError: it is no file of houses.
    """
    check_houses_path(path)
    houses = count_houses(path)
    faults: dict[int, str] = {}
    stood, unknown, no_place = 0, Counter[str](), Counter[str]()
    for number in range(min(houses, MOST_LOOKED_AT)):
        try:
            house = read_procthor_house(path, number)
        except DamagedFileError as error:
            faults[number] = str(error)
        else:
            stood += len(house.home.instances)
            unknown.update(house.unknown)
            no_place.update(house.no_place)
    has_sizes = (path.parent / ASSET_DATABASE).is_file()
    return HousesSurvey(houses, min(houses, MOST_LOOKED_AT), has_sizes, faults, stood, unknown, no_place)
