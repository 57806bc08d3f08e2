"""A split that grows on the disk while its episodes are made, and goes on where it was interrupted."""

from collections.abc import Callable, Iterable, Iterator
from hashlib import sha256
from pathlib import Path

from uniteam.errors import InvalidInputError
from uniteam.world.certification.candidate_tasks import Tally
from uniteam.world.certification.generate_episodes import EpisodeMaker
from uniteam.world.certification.rejection import Proposals
from uniteam.world.homes.home import Home
from uniteam.world.task.episode import Episode, Split
from uniteam.world.task.splits import SUFFIX, load_split, write_split


class GrowingSplit:
    """The episodes of a split made so far, in a file beside the one that they will be in.

    Attributes:
        partial: the file, a split that can be played; there is none before the first episode and after `finish`.
        proposals: what came of the episodes that were proposed in homes done now; not of those done before.
    """

    def __init__(self, out: Path, recipe: object, style: str) -> None:
        """Take up what an earlier call with the same recipe left beside `out`; raises DamagedFileError.

        Args:
            out: the split's file at the end.
            recipe: what decides which episodes are made; its text tells one call from another.
            style: in which the homes are made.
        """
        self.proposals = Proposals()
        self._style = style
        self._out = out
        self._name = out.name.removesuffix(SUFFIX)
        self.partial = out.with_name(f"{self._name}.part-{sha256(repr(recipe).encode()).hexdigest()[:8]}{SUFFIX}")
        self._before = load_split(self.partial) if self.partial.exists() else Split(self._name, (), {})
        self._homes: dict[str, Home] = {}
        self._episodes: list[Episode] = []

    @property
    def split(self) -> Split:
        """What there is so far."""
        return Split(self._name, tuple(self._episodes), self._homes)

    def add_home(self, home: Home, count: int, tally: Tally) -> int:
        """Add up to `count` episodes of a home, made before or now, and return how many; the tally grows with them.

        Raises:
            InvalidInputError: another home of this name is there already.
            UnwritableError: an episode cannot be kept.
        """
        if home.name in self._homes:
            raise InvalidInputError(
                f"two homes are named '{home.name}'; a source must name each seed's home differently"
            )
        first = len(self._episodes)
        for episode in self._made_before(home, count, tally) or self._make(home, count, tally):
            self._homes[home.name] = home
            self._episodes.append(episode)
        return len(self._episodes) - first

    def finish(self) -> None:
        """Write the split's file whole and take the other away; raises UnwritableError."""
        write_split(self.split, self._out)
        self.partial.unlink(missing_ok=True)

    def _made_before(self, home: Home, count: int, tally: Tally) -> tuple[Episode, ...]:
        """Return the episodes of a home that was finished before and is the same still, else none."""
        episodes = tuple(episode for episode in self._before.episodes if episode.home == home.name)
        if len(episodes) != count or self._before.homes[home.name] != home:
            return ()
        for episode in episodes:
            tally.add(episode.instruction, episode.unseen)
        return episodes

    def _make(self, home: Home, count: int, tally: Tally) -> Iterator[Episode]:
        """Yield the episodes of a home, each kept on the disk before the next is begun."""
        maker = EpisodeMaker(home, tally, self._style)
        for episode in maker.episodes(count):
            yield episode
            write_split(self._kept(), self.partial)
        self.proposals.add(maker.proposals)

    def _kept(self) -> Split:
        """Return what there is so far, and what was made before of homes that have not come up again yet."""
        waiting = [episode for episode in self._before.episodes if episode.home not in self._homes]
        homes = {episode.home: self._before.homes[episode.home] for episode in waiting}
        return Split(self._name, (*self._episodes, *waiting), {**self._homes, **homes})


def grow(split: GrowingSplit, homes: Iterable[Home], per_home: int, on_home: Callable[[Home, int], None]) -> None:
    """Add up to `per_home` episodes of each home, varied over all of them.

    Args:
        split: to add them to.
        homes: in their order.
        per_home: episodes wanted in each.
        on_home: called with every home that is done and the number of its episodes.
    """
    tally = Tally()
    for home in homes:
        on_home(home, split.add_home(home, per_home, tally))
