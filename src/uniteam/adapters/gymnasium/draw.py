"""Which episode is played next, in which home: a home stays for some episodes, because to open one takes a second."""

from collections import defaultdict
from pathlib import Path

import numpy as np

from uniteam.adapters.gymnasium.open_home import OpenHome
from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.geometry import PinholeCamera
from uniteam.world.task.episode import Episode, Split
from uniteam.world.task.splits import load_split


class Draw:
    """Draws episodes of a split, and keeps the home of the last one open.

    Attributes:
        split: of which they are.
    """

    def __init__(self, split: str | Path | Split, camera: PinholeCamera, stay: int) -> None:
        """Take the split.

        Args:
            split: its name, its file, or itself.
            camera: of the robot's head.
            stay: how many episodes are drawn of a home before another home is.

        Raises:
            UnknownNameError: there is no such split.
            InvalidInputError: a home cannot stay for less than one episode.
        """
        if stay < 1:
            raise InvalidInputError(f"a home stays for at least one episode, episodes_per_home={stay} is too few")
        self.split = split if isinstance(split, Split) else load_split(split)
        self._camera, self._stay = camera, stay
        self._in_home: dict[str, list[Episode]] = defaultdict(list)
        for episode in self.split.episodes:
            self._in_home[episode.home].append(episode)
        self._by_id = {episode.id: episode for episode in self.split.episodes}
        self._home, self._left = "", 0
        self._open: OpenHome | None = None

    def any(self, generator: np.random.Generator) -> Episode:
        """Return an episode of the home that stays, or of another once that has had its number."""
        if self._left == 0:
            homes = list(self._in_home)
            self._home, self._left = homes[generator.integers(len(homes))], self._stay
        self._left -= 1
        episodes = self._in_home[self._home]
        return episodes[generator.integers(len(episodes))]

    def named(self, id_: str) -> Episode:
        """Return an episode by its id; raises UnknownNameError."""
        if id_ not in self._by_id:
            raise UnknownNameError(f"episode of split {self.split.name}", str(id_), self._by_id)
        return self._by_id[id_]

    def restart(self) -> None:
        """Forget which home stays, so that what is drawn next hangs on the generator alone."""
        self._left = 0

    def open(self, episode: Episode) -> OpenHome:
        """Return the home of an episode, opened; only the last one is kept, for each takes a hundred megabytes."""
        home = self.split.homes[episode.home]
        if self._open is None or self._open.home is not home:
            self._open = None
            self._open = OpenHome(home, self._camera)
        return self._open
