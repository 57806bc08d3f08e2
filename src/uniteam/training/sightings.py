"""What perception makes of a home's views, beside what was there: the raw material of every figure."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from uniteam.geometry import BasePose, PinholeCamera
from uniteam.interface import Joints, Observation
from uniteam.mind.perception.learned.asking import ROLES, Asking
from uniteam.mind.perception.learned.eyes import Eyes, Glimpse
from uniteam.mind.perception.learned.kinds import Kind
from uniteam.mind.perception.words.meaning import plain_words
from uniteam.stretch import HEAD_CAMERA_FULL, HEAD_CAMERA_HALF
from uniteam.training.example_views import Look, NoteLook, ignore_look
from uniteam.training.records import Thing
from uniteam.training.views import View
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES

MATCH = 0.3
"""Intersection over union from which on a detection is of a thing."""
LOWEST = 0.01
"""Raw scores below this are not kept."""
FEWEST_PIXELS = 100
"""Of a thing in a half-size frame, from which on it counts as there to be seen."""
FARTHEST = 3.0
"""m, up to which it does."""


@dataclass(frozen=True)
class Present:
    """A thing that was there to be seen: its pixels at half size, and the best overlap of a region of its kind."""

    frame: int
    index: int
    thing: Thing
    pixels: int
    overlap: float


@dataclass(frozen=True)
class Answer:
    """What came of asking for a word: a region with its scores, and the thing that it matches, if it does.

    Attributes:
        frame, word, role: what was asked, in which frame.
        raw, score: before and after calibration.
        pixels: of the region, at half size.
        matched: the thing of the region; None where it overlaps none enough.
        index: of that thing in its home, -1 for none.
    """

    frame: int
    word: str
    role: str
    raw: float
    score: float
    pixels: int
    matched: Thing | None
    index: int

    @property
    def is_right(self) -> bool:
        """Whether the thing is what was asked for."""
        return self.matched is not None and self.matched.category == self.word


@dataclass
class Sightings:
    """All of what was seen and asked in some homes.

    Attributes:
        present: objects and receptacles that were there to be seen.
        answers: for every category of object of the home, and every receptacle's name, in each of its frames.
        receptacle_pixels: (R + 1, R + 1) counts of pixels, truth in rows, what was said in columns; the last is none.
        seconds: what each frame took.
        frames: how many there are.
    """

    present: list[Present] = field(default_factory=list)
    answers: list[Answer] = field(default_factory=list)
    receptacle_pixels: NDArray[np.int64] = field(
        default_factory=lambda: np.zeros((len(RECEPTACLE_CATEGORIES) + 1,) * 2, dtype=np.int64)
    )
    seconds: list[float] = field(default_factory=list)
    frames: int = 0


class Watcher:
    """Looks at views and notes what it sees."""

    def __init__(self, eyes: Eyes, asking: Asking, camera: PinholeCamera, on_look: NoteLook = ignore_look) -> None:
        """Take the perception, the camera with which it sees (half or full), and who is told of each view."""
        self._eyes, self._asking, self._camera, self._on_look = eyes, asking, camera, on_look
        self.sightings = Sightings()

    def watch(self, views: Iterable[View], things: Sequence[Thing]) -> None:
        """Look at the views of a home whose instances are `things`."""
        objects = sorted({thing.category for thing in things if thing.role == "object"})
        asked = [self._asking.asked(word, Kind.OBJECT) for word in objects]
        asked += [self._asking.asked(word, Kind.RECEPTACLE) for word in RECEPTACLE_CATEGORIES]
        for view in views:
            began = perf_counter()
            glimpses = self._eyes.look(observation_of(view, self._camera))
            self.sightings.seconds.append(perf_counter() - began)
            overlaps = _overlaps(glimpses, view.half.instances, len(things))
            there = self._note_present(view, things, overlaps, glimpses)
            matched = [int(o.argmax()) if o.size and o.max() >= MATCH else -1 for o in overlaps]
            for glimpse, index in zip(glimpses, matched, strict=True):
                pixels = int(np.count_nonzero(glimpse.region.mask))
                for word in asked:
                    if word.kind is glimpse.region.kind:
                        raw = self._asking.raw_score(glimpse, word)
                        if raw >= LOWEST:
                            score = self._asking.score(glimpse, word)
                            thing = things[index] if index >= 0 else None
                            answer = Answer(
                                self.sightings.frames, word.word, ROLES[word.kind], raw, score, pixels, thing, index
                            )
                            self.sightings.answers.append(answer)
            self._note_receptacles(view, things, glimpses)
            self._on_look(Look(view.half.rgb, view.half.instances, things, glimpses, matched, there))
            self.sightings.frames += 1

    def _note_present(
        self, view: View, things: Sequence[Thing], overlaps: list[NDArray[np.float64]], glimpses: Sequence[Glimpse]
    ) -> list[int]:
        """Note the objects and receptacles that are there to be seen; return their indices."""
        instances, depth, there = view.half.instances, view.half.depth, list[Present]()
        pixels = np.bincount(instances.ravel() + 1, minlength=len(things) + 1)[1:]
        for index in map(int, np.flatnonzero(pixels >= FEWEST_PIXELS)):
            thing = things[index]
            if thing.role not in ("object", "receptacle") or np.median(depth[instances == index]) > FARTHEST:
                continue
            own = [o[index] for o, g in zip(overlaps, glimpses, strict=True) if ROLES[g.region.kind] == thing.role]
            there.append(Present(self.sightings.frames, index, thing, int(pixels[index]), float(max(own, default=0.0))))
        self.sightings.present += there
        return [present.index for present in there]

    def _note_receptacles(self, view: View, things: Sequence[Thing], glimpses: Sequence[Glimpse]) -> None:
        """Count the pixels of each receptacle's name that were given each name."""
        none = len(RECEPTACLE_CATEGORIES)
        number = {name: k for k, name in enumerate(RECEPTACLE_CATEGORIES)}
        label_of = [number[t.category] if t.role == "receptacle" else none for t in things]
        truth = np.array([*label_of, none])[view.half.instances]
        said = np.full(truth.shape, none)
        for glimpse in glimpses:
            if glimpse.region.kind is Kind.RECEPTACLE:
                name = self._asking.best_name(glimpse)
                labels = {plain_words(n): k for n, k in number.items()}
                said[glimpse.region.mask] = labels.get(name, none)
        np.add.at(self.sightings.receptacle_pixels, (truth.ravel(), said.ravel()), 1)


def observation_of(view: View, camera: PinholeCamera) -> Observation:
    """Return a view as the observation of a run with the half or the full camera, without the truth."""
    frame = view.fine if camera == HEAD_CAMERA_FULL else view.half
    assert camera in (HEAD_CAMERA_FULL, HEAD_CAMERA_HALF)
    here = BasePose(0.0, 0.0, 0.0)
    return Observation(frame.rgb, frame.depth, camera, view.camera_to_start, here, Joints(0.0, 0.0), False, 0)


def _overlaps(glimpses: Sequence[Glimpse], instances: NDArray[np.int16], count: int) -> list[NDArray[np.float64]]:
    """Return, for each glimpse, the (count,) intersections over union with the instances."""
    areas = np.bincount(instances.ravel() + 1, minlength=count + 1)[1:]
    overlaps = []
    for glimpse in glimpses:
        mask = glimpse.region.mask
        common = np.bincount(instances[mask] + 1, minlength=count + 1)[1:]
        overlaps.append(common / np.maximum(areas + np.count_nonzero(mask) - common, 1))
    return overlaps
