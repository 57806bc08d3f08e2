"""What each instance of a home is to an instruction: tables by which a picture of instances becomes one of roles."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from uniteam.interface import Instruction
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.homes.home import Home

Table = NDArray[np.uint8]
"""(N + 1,): one entry an instance of the home, and the last, to which -1 leads, for what is none."""


@lru_cache(maxsize=1)
def receptacle_classes() -> tuple[str, ...]:
    """Return the receptacle classes of the pack, sorted; the first of them has number 1."""
    return tuple(sorted({model.category for model in load_catalogue().models.values() if model.role == "receptacle"}))


OTHER_RECEPTACLE = 1 + len(receptacle_classes())
"""The number of a receptacle class that is not the pack's."""


def receptacle_number(category: str) -> int:
    """Return the number of a receptacle class, from 1 on."""
    classes = receptacle_classes()
    return 1 + classes.index(category) if category in classes else OTHER_RECEPTACLE


@dataclass(frozen=True)
class Labels:
    """Tables of a home and an instruction.

    Attributes:
        objects: 1 for what is of the asked class.
        start_receptacles: 1 for what is of the start class.
        goal_receptacles: 1 for what is of the goal class.
        receptacles: the number of the class, for every receptacle.
    """

    objects: Table
    start_receptacles: Table
    goal_receptacles: Table
    receptacles: Table


def labels_of(home: Home, instruction: Instruction) -> Labels:
    """Return the tables of a home and an instruction."""
    categories = [instance.category for instance in home.instances]
    roles = [home.model_of(instance).role for instance in home.instances]
    numbers = [receptacle_number(c) if role == "receptacle" else 0 for c, role in zip(categories, roles, strict=True)]
    asked = (instruction.object_category, instruction.start_receptacle, instruction.goal_receptacle)
    objects, starts, goals = (_table([int(category == name) for category in categories]) for name in asked)
    return Labels(objects, starts, goals, _table(numbers))


def _table(values: list[int]) -> Table:
    return np.array([*values, 0], np.uint8)
