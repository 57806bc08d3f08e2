"""Which tasks a home offers, and in which order to try them so that a split is varied."""

from collections import Counter
from collections.abc import Iterator, Mapping
from copy import deepcopy
from dataclasses import dataclass, field
from itertools import product

import numpy as np

from uniteam.interface import Instruction
from uniteam.world.homes.home import Home, Instance


@dataclass(frozen=True)
class CandidateTask:
    """An instruction that makes sense in a home.

    Attributes:
        instruction: what is asked.
        objects: names of the objects of the class that lie on an instance of the start class.
        start_receptacles: names of the instances on which they lie.
        goals: names of the instances of the goal class.
        unseen: whether the object's class occurs in no training home.
    """

    instruction: Instruction
    objects: tuple[str, ...]
    start_receptacles: tuple[str, ...]
    goals: tuple[str, ...]
    unseen: bool


@dataclass
class Tally:
    """How often a split asks for each class so far."""

    objects: Counter[str] = field(default_factory=Counter)
    goals: Counter[str] = field(default_factory=Counter)
    starts: Counter[str] = field(default_factory=Counter)
    unseen: int = 0
    total: int = 0

    def add(self, instruction: Instruction, unseen: bool) -> None:
        """Count an episode."""
        self.objects[instruction.object_category] += 1
        self.goals[instruction.goal_receptacle] += 1
        self.starts[instruction.start_receptacle] += 1
        self.unseen += unseen
        self.total += 1

    def copy(self) -> "Tally":
        """Return a tally of its own with the same counts."""
        return deepcopy(self)

    def weight(self, instruction: Instruction) -> float:
        """Return how welcome an instruction is: rare classes are, goal classes most of all."""
        goal, start = self.goals[instruction.goal_receptacle], self.starts[instruction.start_receptacle]
        return 1.0 / ((1 + goal) ** 2 * (1 + self.objects[instruction.object_category]) * (1 + start) ** 0.5)


def possible_tasks(home: Home, support: Mapping[str, str], distractor_distance: float) -> tuple[CandidateTask, ...]:
    """Return the tasks of a home.

    Args:
        home: with its objects at rest.
        support: by an object's name, the receptacle on which it lies.
        distractor_distance: objects of the class that do not count lie at least this far (m) from those that do.
    """
    goals = _names_by_category(i for i in home.instances if home.model_of(i).role == "receptacle")
    lying: dict[tuple[str, str], list[str]] = {}
    for name, receptacle in support.items():
        lying.setdefault((home.by_name[name].category, home.by_name[receptacle].category), []).append(name)
    unseen = home.library.unseen_categories

    def held_by(names: list[str]) -> tuple[str, ...]:
        return tuple(sorted({support[name] for name in names}))

    return tuple(
        CandidateTask(
            Instruction(category, start, goal), tuple(names), held_by(names), tuple(goals[goal]), category in unseen
        )
        for ((category, start), names), goal in product(lying.items(), goals)
        if goal != start and _nearest_other(home, category, names) >= distractor_distance
    )


def in_order_of_variety(
    tasks: tuple[CandidateTask, ...], tally: Tally, rng: np.random.Generator
) -> Iterator[CandidateTask]:
    """Yield tasks in random order, those with classes that the split lacks sooner."""
    if tasks:
        weights = np.array([tally.weight(task.instruction) for task in tasks])
        keys = np.log(rng.random(len(tasks))) / weights  # Efraimidis and Spirakis 2006: sampling without replacement
        yield from (tasks[i] for i in np.argsort(-keys, kind="stable"))


def _names_by_category(instances: Iterator[Instance]) -> dict[str, list[str]]:
    names: dict[str, list[str]] = {}
    for instance in instances:
        names.setdefault(instance.category, []).append(instance.name)
    return names


def _nearest_other(home: Home, category: str, names: list[str]) -> float:
    """Return the distance (m) from an object that counts to the nearest of its class that does not."""
    counted = np.array([home.by_name[name].position for name in names])
    others = [instance.position for instance in home.of_category(category) if instance.name not in names]
    distances = np.linalg.norm(counted[:, None] - np.array(others).reshape(1, -1, 3), axis=2)
    return float(distances.min(initial=np.inf))
