"""The room that the robot takes with a load."""

import pytest
from worlds.box_world import Box, room
from worlds.driving import Drive

from uniteam.geometry import BasePose
from uniteam.grid import disc_mask
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.manipulation.arm_clearance import EMPTY_GRIPPER, Load
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.navigation.planning.plan import Plan
from uniteam.stretch import BASE_RADIUS

BROOM = Load(along_base=0.4, along_arm=0.05, below=0.1)
NARROW_AND_WIDE = (Box((1.0, -1.2, 0.0), (1.3, -0.35, 1.2)), Box((1.0, 0.35, 0.0), (1.3, 0.9, 1.2)))
NARROW_ONLY = (Box((1.0, -2.0, 0.0), (1.3, -0.35, 1.2)), Box((1.0, 0.35, 0.0), (1.3, 2.0, 1.2)))


def planned(walls: tuple[Box, ...], load: Load, *improvements: str) -> Plan:
    """Return the plan to the other end of a room, past walls and with a load."""
    config = improved(BASELINE, ("true_radius", *improvements))
    drive = Drive.begin((*room(-1.0, -2.0, 3.0, 2.0), *walls), BasePose(0.0, 0.0, 0.0), config.planner)
    drive.planner.carry(config.footprint(load))
    cells = disc_mask(drive.bird_map.shape, drive.bird_map.to_cell(2.3, 0.0), 1)
    return drive.planner.plan(drive.bird_map, drive.base, Goal(GoalKind.FRONTIER, cells, distance=0.0))


def test_load_footprint_takes_a_broom_round_where_the_baseline_drives_through_the_gap() -> None:
    through, round_it = planned(NARROW_AND_WIDE, BROOM), planned(NARROW_AND_WIDE, BROOM, "load_footprint")
    assert through.reachable and round_it.reachable
    assert through.distance < 2.6
    assert round_it.distance > 3.0


def test_with_an_empty_gripper_and_where_there_is_no_wider_way_the_gap_is_taken() -> None:
    assert planned(NARROW_AND_WIDE, EMPTY_GRIPPER, "load_footprint").distance < 2.6
    only = planned(NARROW_ONLY, BROOM, "load_footprint")
    assert only.reachable
    assert only.distance < 2.6


@pytest.mark.parametrize(("load", "radius"), [(EMPTY_GRIPPER, BASE_RADIUS), (BROOM, BASE_RADIUS + 0.15)])
def test_the_footprint_holds_base_and_load(load: Load, radius: float) -> None:
    assert improved(BASELINE, {"load_footprint"}).footprint(load) == pytest.approx(radius)
