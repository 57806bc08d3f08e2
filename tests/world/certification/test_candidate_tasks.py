"""Tasks that make sense in a home, and their order."""

from collections import Counter

import numpy as np

from uniteam.interface import Instruction
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.world.certification.candidate_tasks import CandidateTask, Tally, in_order_of_variety, possible_tasks
from uniteam.world.generation.objects.settling import resting_on
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.splits import load_split


def test_tasks_move_objects_between_different_classes_of_furniture() -> None:
    split = load_split("minival")
    home = split.homes[split.episodes[0].home]
    support = resting_on(home, Simulator(home, HEAD_CAMERA_HALF).physics)
    tasks = possible_tasks(home, support)
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
