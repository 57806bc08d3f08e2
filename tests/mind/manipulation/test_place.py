"""Placing in a world of boxes: where the baseline lets go, and what each improvement mends."""

import math
from dataclasses import replace

import numpy as np
import pytest
from worlds.arm_world import ArmWorld, play
from worlds.box_world import Box

from uniteam.geometry import BasePose
from uniteam.interface import BaseDisplacement, DiscreteAction, Instruction
from uniteam.mind.agents.config import BASELINE
from uniteam.mind.agents.improvements import improved
from uniteam.mind.manipulation.arm_clearance import Load
from uniteam.mind.manipulation.place.edge_margin import SafeFromEdges
from uniteam.mind.manipulation.place.place import PlaceConfig, PlaceTask, place
from uniteam.mind.manipulation.place.placing_points import densest_slab

INSTRUCTION = Instruction("cup", "sofa", "table")
CUP = Box((0.0, 0.0, 0.0), (0.08, 0.08, 0.1), "cup")
CUP_LOAD = Load(0.04, 0.04, 0.1)


def table(x: float, depth: float = 0.7, height: float = 0.75, name: str = "table") -> Box:
    return Box((x, -0.7, 0.0), (x + depth, 0.7, height), name)


def config(*improvements: str) -> PlaceConfig:
    """Return the baseline's placing with some improvements, and little patience for the fall."""
    return replace(improved(BASELINE, set(improvements)).place, rest_steps=2)


def place_in(world: ArmWorld, settings: PlaceConfig, load: Load = CUP_LOAD, held: Box = CUP) -> list[object]:
    """Place at the last attempt, with a seeded generator; return the actions."""
    world.held = held
    task = PlaceTask(load, settings.choose_points, settings.release, np.random.default_rng(5))
    _, actions = play(world, INSTRUCTION, lambda view: place(view, task, settings, is_last=True))
    return list(actions)


def is_over(world: ArmWorld, box: Box, margin: float = 0.0) -> bool:
    """Whether the gripper let go over a box, no nearer to its edge than the margin (m)."""
    assert world.released is not None
    x, y, z = world.released
    inside = all(box.low[i] + margin <= value <= box.high[i] - margin for i, value in enumerate((x, y)))
    return inside and z > box.high[2]


def test_the_baseline_drives_to_a_table_lets_go_over_it_and_waits_for_the_fall() -> None:
    goal = table(0.9, height=0.5)
    world = ArmWorld((goal,), BasePose(0.0, 0.0, 0.1))
    actions = place_in(world, config())
    assert is_over(world, goal)
    assert world.hits == []
    assert world.released is not None and world.released[2] == pytest.approx(0.9, abs=0.05)
    assert actions[-3:] == [DiscreteAction.DESNAP_OBJECT, *[DiscreteAction.EMPTY_ACTION] * 2]
    assert BASELINE.place.rest_steps == 200


def test_the_baseline_chooses_the_point_whose_slab_holds_most_points() -> None:
    generator = np.random.default_rng(0)
    crowd = np.column_stack([generator.uniform(0.0, 0.1, (400, 2)), np.full(400, 0.7)])
    scattered = np.column_stack([generator.uniform(1.0, 2.0, (400, 2)), generator.uniform(0.0, 0.7, 400)])
    chosen = densest_slab(np.concatenate([crowd, scattered]).astype(np.float32), CUP_LOAD, generator)
    assert len(chosen.points) == 50
    best = chosen.points[chosen.best_first()[0]]
    assert best[0] < 0.2 and best[2] == pytest.approx(0.7)


def test_stepwise_place_gets_to_a_table_that_one_long_drive_does_not_reach() -> None:
    """A box stands where the long drive would end; a few small steps end before it, in reach of the arm."""
    goal = table(0.95, depth=0.5, height=0.5)
    obstacle = Box((0.75, -0.3, 0.0), (0.95, 0.3, 0.3))
    start = BasePose(0.0, 0.0, 0.0)
    worlds = [ArmWorld((goal, obstacle), start) for _ in range(2)]
    actions = [
        place_in(worlds[0], config()),
        place_in(worlds[1], config("stepwise_place", "drop_height")),
    ]
    assert worlds[0].base.distance_to(0.0, 0.0) < 0.01
    assert not is_over(worlds[0], goal)
    assert is_over(worlds[1], goal)
    drives = [a.x for a in actions[1] if isinstance(a, BaseDisplacement) and a.x > 0]
    assert drives and max(drives) <= 0.25


def test_stepwise_place_finds_a_way_for_the_arm_where_the_baseline_hits_a_lamp() -> None:
    goal = table(0.5, height=0.7)
    lamp = Box((0.55, -0.1, 0.7), (0.65, 0.1, 1.3))
    worlds = [ArmWorld((goal, lamp), BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    place_in(worlds[0], config())
    place_in(worlds[1], config("stepwise_place", "drop_height"))
    assert worlds[0].hits
    assert is_over(worlds[1], goal)
    assert worlds[1].hits == []


def test_edge_margin_keeps_away_from_the_edge_and_from_what_lies_there() -> None:
    grid = np.stack(np.meshgrid(np.arange(0.0, 0.5, 0.01), np.arange(0.0, 0.5, 0.01)), axis=-1).reshape(-1, 2)
    top = np.column_stack([grid, np.full(len(grid), 0.7)]).astype(np.float32)
    near_edge = np.repeat(top[top[:, 0] < 0.04], 20, axis=0)
    cloud = np.concatenate([top, near_edge])
    greedy = densest_slab(cloud, CUP_LOAD, np.random.default_rng(1))
    careful = SafeFromEdges()(cloud, CUP_LOAD, np.random.default_rng(1))
    assert greedy.points[greedy.best_first()[0]][0] < 0.12
    best = careful.points[careful.best_first()[0]]
    assert 0.11 < best[0] < 0.39 and 0.11 < best[1] < 0.39
    assert (careful.worth > 0).all()


def test_edge_margin_takes_the_bottom_of_a_basin_for_safe_and_its_walls_for_no_place_at_all() -> None:
    ticks = np.arange(0.0, 0.4, 0.01)
    x, y = (axis.ravel() for axis in np.meshgrid(ticks, ticks))
    is_rim = (x < 0.05) | (x > 0.35) | (y < 0.05) | (y > 0.35)
    basin = np.column_stack([x, y, np.where(is_rim, 0.9, 0.75)])
    wall = [(0.05, v, h) for v in ticks for h in np.arange(0.75, 0.9, 0.01)]
    cloud = np.concatenate([basin, wall]).astype(np.float32)
    chosen = SafeFromEdges()(cloud, CUP_LOAD, np.random.default_rng(2))
    best = chosen.points[chosen.best_first()[0]]
    assert best[2] == pytest.approx(0.75, abs=0.01)
    assert 0.1 < best[0] < 0.3 and 0.1 < best[1] < 0.3


def test_surface_fallback_uses_a_flat_surface_where_the_baseline_lets_go_blindly() -> None:
    """No table is detected: the baseline stretches past the narrow desk, the improvement puts down on it."""
    desk = Box((0.42, -0.4, 0.0), (0.62, 0.4, 0.8), "desk")
    worlds = [ArmWorld((desk,), BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    actions = place_in(worlds[0], config())
    place_in(worlds[1], config("surface_fallback"))
    assert actions[0] is DiscreteAction.MANIPULATION_MODE
    assert not is_over(worlds[0], desk)
    assert is_over(worlds[1], desk)


def test_surface_fallback_extends_blindly_only_where_there_is_no_surface_either() -> None:
    world = ArmWorld((), BasePose(0.0, 0.0, 0.0))
    place_in(world, config("surface_fallback"))
    assert world.released is not None
    assert math.hypot(world.released[0], world.released[1]) > 0.6


def test_drop_height_lifts_a_tall_object_over_a_counter_that_it_would_hit() -> None:
    counter = table(0.5, height=0.9)
    vase = Box((0.0, 0.0, 0.0), (0.1, 0.1, 0.25), "cup")
    load = Load(0.05, 0.05, 0.25)
    worlds = [ArmWorld((counter,), BasePose(0.0, 0.0, 0.0)) for _ in range(2)]
    place_in(worlds[0], config(), load, vase)
    place_in(worlds[1], config("drop_height"), load, vase)
    assert worlds[0].hits
    assert worlds[1].hits == []
    assert is_over(worlds[1], counter)
    assert worlds[1].released is not None and worlds[0].released is not None
    assert worlds[1].released[2] > worlds[0].released[2]
