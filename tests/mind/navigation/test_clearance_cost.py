"""Paths that keep away from obstacles."""

import numpy as np
from worlds.box_world import Box, room
from worlds.driving import Drive

from uniteam.geometry import BasePose
from uniteam.grid import Grid, disc_mask
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.navigation.goal import Goal, GoalKind
from uniteam.mind.navigation.planning.bucket_queue import HIGHEST_PRICE
from uniteam.mind.navigation.planning.clearance import Clearance
from uniteam.mind.navigation.planning.clearance_cost import ClearancePrice

PILLARS = (Box((1.0, -0.9, 0.0), (1.4, -0.1, 2.0)), Box((1.0, 1.9, 0.0), (1.4, 2.9, 2.0)))


def least_clearance(*improvements: str) -> float:
    """Return how near (m) to a pillar the path past it leads that is planned with some improvements."""
    config = improved(BASELINE, improvements)
    drive = Drive.begin((*room(-1.0, -3.0, 4.0, 3.0), *PILLARS), BasePose(0.0, 0.0, 0.0), config.planner)
    cells = disc_mask(drive.bird_map.shape, drive.bird_map.to_cell(2.6, -0.2), 1)
    plan = drive.planner.plan(drive.bird_map, drive.base, Goal(GoalKind.FRONTIER, cells, distance=0.0))
    assert plan.reachable
    corner = np.array([1.2, -0.1])
    beside = plan.path[np.abs(plan.path[:, 0] - corner[0]) < 0.2]
    assert len(beside)
    return float(np.abs(beside[:, 1] - corner[1]).min())


def test_clearance_cost_leads_past_a_pillar_with_room_where_the_baseline_grazes_it() -> None:
    assert least_clearance() < 0.25
    assert least_clearance("clearance_cost") > 0.4


def test_a_cell_is_the_dearer_the_nearer_it_is_to_an_obstacle() -> None:
    obstacle = np.zeros((1, 40), dtype=np.bool_)
    obstacle[0, 0] = True
    prices = ClearancePrice()(Clearance(obstacle, Grid((0.0, 0.0), 0.05)))[0]
    assert (np.diff(prices.astype(int)) <= 0).all()
    assert (prices[6], prices[10], prices[39]) == (HIGHEST_PRICE, 1, 1)
    assert len(set(prices[6:11])) == 5
