"""Tasks that make sense in a home, and their order."""

from collections import Counter
from dataclasses import replace

import numpy as np
from worlds.small_home import CATALOGUE, CUP, SINK, TABLE, instance, small_home

from uniteam.interface import Instruction
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.certification.candidate_tasks import CandidateTask, Tally, in_order_of_variety, possible_tasks
from uniteam.world.generation.objects.settling import resting_on
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.splits import load_split

TRUNK = replace(TABLE, id="trunk", category="trunk")
WITH_TRUNK = Catalogue({**CATALOGUE.models, "trunk": TRUNK}, frozenset())


def test_tasks_move_objects_between_different_classes_of_furniture() -> None:
    split = load_split("minival")
    home = split.homes[split.episodes[0].home]
    support = resting_on(home, Simulator(home, HEAD_CAMERA_HALF).physics)
    tasks = possible_tasks(home, support, 2.0)
    assert tasks
    for task in tasks:
        instruction = task.instruction
        assert instruction.start_receptacle != instruction.goal_receptacle
        assert {home.by_name[support[name]].category for name in task.objects} == {instruction.start_receptacle}
        assert {home.by_name[name].category for name in task.objects} == {instruction.object_category}
        assert {home.by_name[name].category for name in task.goals} == {instruction.goal_receptacle}
        assert set(task.start_receptacles) == {support[name] for name in task.objects}


def test_goal_classes_that_a_split_lacks_are_tried_first() -> None:
    tally = Tally()
    for _ in range(30):
        tally.add(Instruction("cup", "table", "bed"), unseen=False)
    tasks = tuple(
        CandidateTask(Instruction("cup", "table", goal), ("cup_1",), ("t",), ("g",), False) for goal in ("bed", "sink")
    )
    rng = np.random.default_rng(0)
    first = Counter(next(in_order_of_variety(tasks, tally, rng)).instruction.goal_receptacle for _ in range(50))
    assert first["sink"] >= 48


def test_others_of_the_class_may_lie_close_by_where_that_is_allowed() -> None:
    home = small_home(
        instance("table", TABLE, 2.0, 2.0), instance("sink", SINK, 3.0, 3.5),
        instance("cup_table", CUP, 2.0, 2.0, 0.75), instance("cup_sink", CUP, 3.0, 3.5, 0.7),
        instance("other_table", TABLE, 6.5, 0.5), instance("trunk", TRUNK, 6.5, 3.0), library=WITH_TRUNK,
    )  # fmt: skip
    support = {"cup_table": "table", "cup_sink": "sink"}
    assert not possible_tasks(home, support, 2.0)
    asked = {str(task.instruction) for task in possible_tasks(home, support, 0.0)}
    assert "Move cup from table to sink" in asked and "Move cup from sink to trunk" in asked
