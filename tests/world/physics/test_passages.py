"""How wide ways are and what a base gets to, in a home of two rooms."""

import math
from dataclasses import replace

import pytest
from worlds.small_home import CATALOGUE, SINK, TABLE, instance, small_home

from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.assets.model import Box
from uniteam.world.homes.home import Home
from uniteam.world.physics.passages import survey

BLOCK = replace(TABLE, id="block", category="wardrobe", size=(0.3, 0.3, 1.0), shapes=(Box((0, 0, 0.5), (0.3, 0.3, 1)),))
LARGE = replace(BLOCK, id="large", size=(1.2, 1.0, 1.0), shapes=(Box((0, 0, 0.5), (1.2, 1.0, 1.0)),))
LIBRARY = Catalogue({**CATALOGUE.models, "block": BLOCK, "large": LARGE}, frozenset())


def with_block_before_the_door(y: float) -> Home:
    """Return the home with a sink in the east room and a block in the doorway, which is at y 1.5 to 2.4."""
    sink = replace(instance("sink", SINK, 6.0, 3.7), room="east")
    return small_home(sink, instance("block", BLOCK, 4.0, y), library=LIBRARY)


def test_the_way_is_as_wide_as_the_door() -> None:
    found = survey(small_home(replace(instance("sink", SINK, 6.0, 3.7), room="east"), library=LIBRARY))
    assert list(found.widths.values()) == [pytest.approx(0.9, abs=0.04)]
    assert found.narrowest == ("east", found.widths["east"])
    assert found.reached == {"sink": True}
    assert not found.shut


def test_what_stands_in_the_door_narrows_the_way_and_may_shut_a_room() -> None:
    narrow = survey(with_block_before_the_door(1.5))
    assert narrow.widths["east"] == pytest.approx(0.75, abs=0.04)
    assert narrow.reached["sink"]
    shut = survey(with_block_before_the_door(1.95))
    assert shut.widths["east"] < 0.6
    assert shut.shut == ("east",) and shut.narrowest is None
    assert shut.reached == {"sink": False, "block": True}


def test_what_stands_behind_other_furniture_is_not_reached() -> None:
    corner = instance("sink", SINK, 3.6, 0.35)
    fence = (instance("before", LARGE, 3.3, 1.15), instance("beside", LARGE, 2.75, 0.5, yaw=math.pi / 2))
    assert survey(small_home(corner, library=LIBRARY)).reached["sink"]
    found = survey(small_home(corner, *fence, library=LIBRARY))
    assert found.reached == {"sink": False, "before": True, "beside": True}
