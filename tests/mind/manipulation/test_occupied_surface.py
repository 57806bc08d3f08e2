"""Room for what is held among the other things on a surface."""

import numpy as np
import pytest

from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.manipulation.arm_clearance import Load
from uniteam.mind.manipulation.place.occupied_surface import RoomAmongOthers
from uniteam.mind.skills.view import Points

RADIO = Load(0.12, 0.05, 0.15)


def surface(x0: float, x1: float, height: float = 0.7) -> Points:
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(x0, x1, 0.01), np.arange(0.0, 0.5, 0.01)))
    return np.column_stack([x, y, np.full(len(x), height)]).astype(np.float32)


COASTER = np.array([[x, y, 0.71] for x in (0.22, 0.26, 0.3) for y in (0.22, 0.26, 0.3)], dtype=np.float32)


@pytest.mark.parametrize(("improvements", "is_beside"), [((), False), (("occupied_surface",), True)])
def test_occupied_surface_keeps_off_a_coaster_on_which_others_would_put_a_radio(
    improvements: tuple[str, ...], is_beside: bool
) -> None:
    rule = improved(BASELINE, {"edge_margin", *improvements}).place.choose_points
    top = surface(0.0, 0.8)
    top = top[np.abs(top[:, :2] - 0.26).max(axis=1) > 0.03]
    near_coaster = 0
    for seed in range(8):
        chosen = rule(top, COASTER, RADIO, np.random.default_rng(seed))
        distances = np.hypot(*(chosen.points[:, :2] - 0.26).T)
        near_coaster += int(np.count_nonzero(distances < 0.12))
    assert (near_coaster == 0) is is_beside


def test_things_below_the_surface_and_high_above_it_are_not_in_the_way() -> None:
    sample = surface(0.0, 0.01)[:1]
    room = RoomAmongOthers()
    below, on_it, above = (np.array([[0.05, 0.0, z]], dtype=np.float32) for z in (0.5, 0.72, 1.2))
    assert room(sample, below, RADIO) == 0.0
    assert room(sample, above, RADIO) == 0.0
    assert room(sample, on_it, RADIO) == pytest.approx(0.12 + 0.02 - 0.05, abs=1e-6)


def test_where_nothing_has_room_enough_the_roomiest_point_is_offered() -> None:
    rule = improved(BASELINE, {"edge_margin", "occupied_surface"}).place.choose_points
    clutter = np.array([[0.0, 0.25, 0.75], [0.2, 0.25, 0.75]], dtype=np.float32)
    chosen = rule(surface(0.0, 0.2), clutter, Load(0.3, 0.3, 0.1), np.random.default_rng(0))
    assert len(chosen.points) >= 1
    assert abs(chosen.points[0][1] - 0.25) > 0.15
