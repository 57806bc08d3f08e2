"""How far view points lie from what is seen from them, in a room of boxes."""

import numpy as np
import pytest
from worlds.small_home import CUP, TABLE, TABLE_HEIGHT, instance, small_home

from uniteam.world.certification.view_points import Viewpoints
from uniteam.world.physics.navigable_floor import NavigableFloor
from uniteam.world.physics.physics_model import compile_home
from uniteam.world.task.footprint import distance_to_footprint

HOME = small_home(instance("table", TABLE, 1.9, 1.9), instance("cup", CUP, 1.9, 2.2, TABLE_HEIGHT))


@pytest.mark.parametrize("name", ["table", "cup"])
def test_view_points_lie_within_a_metre_of_the_footprint_and_so_far_away(name: str) -> None:
    views = Viewpoints(HOME, NavigableFloor(HOME), compile_home(HOME)).of(name)
    distances = distance_to_footprint(HOME, HOME.by_name[name], np.array(views))
    assert 0.9 < distances.max() <= 1.0
    assert len(views) > 20
