"""The views of which perception made most and least, as pictures: what is right and wrong, seen at a glance."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from uniteam.files import try_folder
from uniteam.interface import Detection, Instruction, Segmentation
from uniteam.mind.perception.learned.asking import ROLES, Asking
from uniteam.mind.perception.learned.eyes import Glimpse
from uniteam.mind.perception.words.meaning import plain_words
from uniteam.training.records import Thing
from uniteam.visualization.picture_file import write_png
from uniteam.visualization.segmentation_view import draw_segmentation

FEWEST_THINGS = 4
"""A view with fewer things of a name says little."""
SCALE = 2


@dataclass(frozen=True)
class Look:
    """A view and what was made of it.

    Attributes:
        rgb: (H, W, 3) at half size.
        instances: (H, W) indices of `things`, -1 for anything else.
        things: of the home.
        glimpses: the regions that were found.
        matched: of each glimpse, the index of the thing that it shows, -1 for none.
        there: indices of the objects and receptacles that were there to be seen.
    """

    rgb: NDArray[np.uint8]
    instances: NDArray[np.int16]
    things: Sequence[Thing]
    glimpses: Sequence[Glimpse]
    matched: Sequence[int]
    there: Sequence[int]


@dataclass(frozen=True)
class _Example:
    """A picture, the share of the things there that were told rightly, and its rank; the lowest comes first."""

    picture: NDArray[np.uint8]
    share: float
    rank: tuple[float, int]


class ExampleViews:
    """Keeps the views in which most and fewest of the things that were there got their names."""

    def __init__(self, asking: Asking, keep: int = 3) -> None:
        """Take what names glimpses, and how many views of each kind are kept."""
        self._asking, self._keep = asking, keep
        self.best: list[_Example] = []
        self.worst: list[_Example] = []

    def __call__(self, look: Look) -> None:
        """Take note of a view."""
        if len(look.there) < FEWEST_THINGS:
            return
        pairs = zip(look.glimpses, look.matched, strict=True)
        told = {index for glimpse, index in pairs if self._is_right(glimpse, look, index)}
        share = len(told.intersection(look.there)) / len(look.there)
        for kept, sign in ((self.best, -1), (self.worst, 1)):
            rank = sign * share, -len(look.there)
            if len(kept) < self._keep or rank < kept[-1].rank:
                kept.append(_Example(self._picture(look), share, rank))
                kept.sort(key=lambda example: example.rank)
                del kept[self._keep :]

    def write(self, folder: Path) -> list[Path]:
        """Write `best-1.png`, `worst-1.png` and so on, the view and what it was taken for; raises UnwritableError."""
        try_folder(folder)
        paths = []
        for name, kept in (("best", self.best), ("worst", self.worst)):
            for number, example in enumerate(kept, 1):
                paths.append(folder / f"{name}-{number}.png")
                write_png(paths[-1], example.picture)
        return paths

    def _is_right(self, glimpse: Glimpse, look: Look, index: int) -> bool:
        return index >= 0 and self._asking.best_name(glimpse) == plain_words(look.things[index].category)

    def _picture(self, look: Look) -> NDArray[np.uint8]:
        """Return the view beside itself with the regions and their names; behind a wrong name stands what it is."""
        instances = np.full(look.instances.shape, -1, dtype=np.int16)
        for number, glimpse in enumerate(look.glimpses):
            instances[glimpse.region.mask] = number
        detections = tuple(
            Detection(((self._words(glimpse, look, index), 1.0),))
            for glimpse, index in zip(look.glimpses, look.matched, strict=True)
        )
        nothing = Instruction("", "", "")
        plain = look.rgb.repeat(SCALE, axis=0).repeat(SCALE, axis=1)
        return np.hstack([plain, draw_segmentation(look.rgb, Segmentation(instances, detections), nothing, SCALE)])

    def _words(self, glimpse: Glimpse, look: Look, index: int) -> str:
        said = self._asking.best_name(glimpse)
        if self._is_right(glimpse, look, index):
            return said
        is_named = index >= 0 and look.things[index].role in ROLES.values()
        return f"{said}? {plain_words(look.things[index].category)}" if is_named else f"{said}? nothing"


NoteLook = Callable[[Look], None]


def ignore_look(look: Look) -> None:
    """Keep no view."""
