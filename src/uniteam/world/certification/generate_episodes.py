"""Certified episodes for homes: varied tasks, and a start that is far from the object."""

from collections import Counter
from collections.abc import Iterable, Iterator

import numpy as np

from uniteam.geometry import BasePose
from uniteam.interface import Instruction
from uniteam.world.certification.candidate_tasks import CandidateTask, Tally, in_order_of_variety, possible_tasks
from uniteam.world.certification.certify import Certifier
from uniteam.world.certification.rejection import Cause, Proposals, Rejected
from uniteam.world.generation.objects.settling import resting_on
from uniteam.world.generation.style import LIVED_IN, TIDY
from uniteam.world.homes.home import Home
from uniteam.world.task.episode import Episode

START_DISTANCE = 3.0
"""The robot starts at least this far (m) from every object that counts."""
UNSEEN_SHARE = 0.5

MOST_FAILURES = 3
"""A goal class that failed so often in a home is not tried there again."""

_START_CLEARANCE = 0.36
_SEED_KEY = 4_711


DISTRACTOR_DISTANCE = {TIDY.name: 2.0, LIVED_IN.name: 0.0}
"""By style: objects of the class that do not count lie at least this far (m) from those that do; else as in tidy."""


class EpisodeMaker:
    """Makes the episodes of one home.

    Attributes:
        proposals: what came of those that were tried so far.
    """

    def __init__(self, home: Home, tally: Tally, style: str) -> None:
        """Take a home and what the split asks for so far.

        Args:
            home: with a seed.
            tally: grows with every episode made.
            style: in which the home was made.
        """
        self.proposals = Proposals()
        self._home = home
        self._tally = tally
        self._rng = np.random.default_rng([_SEED_KEY, home.seed or 0])
        self._certifier = Certifier(home, style)
        support = resting_on(home, self._certifier.simulator.physics)
        self._tasks = possible_tasks(home, support, DISTRACTOR_DISTANCE.get(style, DISTRACTOR_DISTANCE[TIDY.name]))
        self._used: set[Instruction] = set()
        self._hopeless: set[CandidateTask] = set()
        self._failures: Counter[str] = Counter()

    def episodes(self, count: int) -> Iterator[Episode]:
        """Yield up to `count` certified episodes as they are made; fewer where the home has no more to offer."""
        for number in range(count):
            episode = self._next(f"{self._home.name}-{number}")
            if episode is None:
                return
            yield episode

    def _next(self, identifier: str) -> Episode | None:
        for task in self._in_order():
            if not self._is_promising(task):
                continue
            episode = self._certify(task, identifier)
            if isinstance(episode, Rejected):
                self.proposals.rejected[episode.cause] += 1
            else:
                self.proposals.certified += 1
                self._used.add(task.instruction)
                self._tally.add(task.instruction, task.unseen)
                return episode
            self._hopeless.add(task)
            self._failures[task.instruction.goal_receptacle] += 1
        return None

    def _in_order(self) -> Iterable[CandidateTask]:
        """Yield the tasks left: the unseen first while the split has too few of them, else the seen first."""
        left = tuple(task for task in self._tasks if self._is_promising(task))
        wants_unseen = self._tally.unseen < UNSEEN_SHARE * (self._tally.total + 1)
        first = tuple(task for task in left if task.unseen == wants_unseen)
        second = tuple(task for task in left if task.unseen != wants_unseen)
        yield from in_order_of_variety(first, self._tally, self._rng)
        yield from in_order_of_variety(second, self._tally, self._rng)

    def _is_promising(self, task: CandidateTask) -> bool:
        is_new = task.instruction not in self._used and task not in self._hopeless
        return is_new and self._failures[task.instruction.goal_receptacle] < MOST_FAILURES

    def _certify(self, task: CandidateTask, identifier: str) -> Episode | Rejected:
        start = self._start(task.objects)
        seed = int(self._rng.integers(2**31))
        return Rejected(Cause.NO_START) if start is None else self._certifier.certify(task, identifier, start, seed)

    def _start(self, objects: Iterable[str]) -> BasePose | None:
        """Return a random pose on the connected floor, far from the objects, rounded to a centimetre."""
        floor = self._certifier.simulator.floor
        cells = np.argwhere(floor.largest_component & (floor.cells >= _START_CLEARANCE))
        for row, column in self._rng.permutation(cells)[:200]:
            x, y = (round(v, 2) for v in floor.to_point(row, column))
            positions = [self._home.by_name[name].position for name in objects]
            if all(np.hypot(p[0] - x, p[1] - y) >= START_DISTANCE for p in positions):
                return BasePose(x, y, round(float(self._rng.uniform(-np.pi, np.pi)), 3))
        return None
