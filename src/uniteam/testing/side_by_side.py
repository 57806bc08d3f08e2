"""Two agents, or two perceptions, see the same at once and must answer the same.

That both are alive at once shows what they share and should not: a state of their class, the generator of random
numbers that belongs to everybody.
"""

from collections.abc import Callable, Iterable
from copy import deepcopy
from dataclasses import dataclass
from typing import Generic, TypeVar

from uniteam.interface import Action, Instruction, Observation
from uniteam.testing.difference import first_difference
from uniteam.testing.episodes import checked_episodes
from uniteam.testing.failure import CheckFailedError, called, one_line
from uniteam.testing.handed_out import HandedOut
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Episode

Answer = TypeVar("Answer")


@dataclass(frozen=True)
class Subject(Generic[Answer]):
    """What is checked, by two of its methods.

    Attributes:
        name: what to call it in a sentence ("agent 'random'").
        method: the name of the one that answers ("act").
        reset: takes an instruction and a seed.
        answer: takes an observation.
        problem: says what is wrong with an answer to an observation; empty where nothing is.
    """

    name: str
    method: str
    reset: Callable[[Instruction, int], None]
    answer: Callable[[Observation], Answer]
    problem: Callable[[Answer, Observation], str]


class Watched(Generic[Answer]):
    """A subject at work: whatever it does wrong by itself is told at once."""

    def __init__(self, subject: Subject[Answer]) -> None:
        self.name = subject.name
        self._subject = subject
        self._handed_out = HandedOut()
        self._answers: list[tuple[int, Answer, Answer]] = []

    def reset(self, episode: Episode) -> None:
        """Begin an episode; raises CheckFailedError."""
        called(f"{self.name}: reset", lambda: self._subject.reset(episode.instruction, episode.seed))

    def answer(self, observation: Observation) -> Answer:
        """Return the answer to an observation.

        Raises:
            CheckFailedError: none comes, it is not what it should be, or the observation was written into.
        """
        where = f"{self.name}: {self._subject.method} at step {observation.step}"
        given = self._handed_out.copy_of(observation)
        answer = called(where, lambda: self._subject.answer(given))
        problem = self._subject.problem(answer, observation)
        if problem:
            raise CheckFailedError(f"{where} {problem}")
        self._handed_out.check_last(self.name)
        self._answers.append((observation.step, answer, deepcopy(answer)))
        return answer

    def check_afterwards(self) -> None:
        """Raise CheckFailedError where an observation or an answer has changed since it was given."""
        self._handed_out.check_all(self.name)
        for step, answer, kept in self._answers:
            changed = first_difference(answer, kept, _word(answer))
            if changed:
                raise CheckFailedError(
                    f"{self.name}: {changed}, which {self._subject.method} returned at step {step}, was changed "
                    "afterwards; return a copy of what is used again"
                )


@dataclass(frozen=True)
class Trial(Generic[Answer]):
    """How subjects are tried.

    Attributes:
        environment: where; its observations carry the truth.
        make: returns a new subject; those made alike must be alike.
        show: what of an observation the subjects are shown.
        next_action: from an answer and the step's number to what is done next.
        steps: at most so many of an episode are played.
    """

    environment: Environment
    make: Callable[[], Subject[Answer]]
    show: Callable[[Observation], Observation]
    next_action: Callable[[Answer, int], Action]
    steps: int

    def check(self) -> list[Observation]:
        """Check copies against each other, and an episode against the same one played first; return what was seen.

        Raises:
            CheckFailedError: what differed, and at which step.
        """
        _, first_episode, second_episode = checked_episodes()
        one, other = Watched(self.make()), Watched(self.make())
        seen = self._play(one, other, first_episode, "two copies made alike, with the same seed, answer differently")
        fresh = Watched(self.make())
        self._play(one, fresh, second_episode, "what was played before leaks: a copy that is reset, and a new one")
        return seen

    def _play(self, one: Watched[Answer], other: Watched[Answer], episode: Episode, blame: str) -> list[Observation]:
        observation, seen = self.environment.reset(episode), list[Observation]()
        for each in (one, other):
            each.reset(episode)
        while not self.environment.is_over and len(seen) < self.steps:
            answer = _same_answer(one, other, (self.show(observation), self.show(observation)), blame)
            seen.append(observation)
            observation = self.environment.step(self.next_action(answer, len(seen)))
        for each in (one, other):
            each.check_afterwards()
        return seen


def check_alike(
    one: Subject[Answer], other: Subject[Answer], seen: Iterable[tuple[Observation, Observation]], blame: str
) -> None:
    """Check that two new subjects answer the same to what was seen in the first of `checked_episodes`.

    Args:
        one: the first of them.
        other: the second.
        seen: what the first and what the second is shown, step by step.
        blame: what it means where they do not, for the sentence.

    Raises:
        CheckFailedError: what differed, and at which step.
    """
    _, episode, _ = checked_episodes()
    watched = Watched(one), Watched(other)
    for each in watched:
        each.reset(episode)
    for shown in seen:
        _same_answer(*watched, shown, blame)


def _same_answer(
    one: Watched[Answer], other: Watched[Answer], shown: tuple[Observation, Observation], blame: str
) -> Answer:
    answer, another = one.answer(shown[0]), other.answer(shown[1])
    differing = first_difference(answer, another, _word(answer))
    if differing:
        raise CheckFailedError(
            f"{one.name}: {blame} (at step {shown[0].step}, in {differing}: {one_line(answer)} and {one_line(another)})"
        )
    return answer


def _word(answer: object) -> str:
    return type(answer).__name__.lower()
