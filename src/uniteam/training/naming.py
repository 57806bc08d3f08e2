"""How often the namer is right when it is handed the true region: what naming costs without what finding costs."""

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from uniteam.geometry import PinholeCamera
from uniteam.mind.perception.learned.eyes import Eyes, half_frame
from uniteam.mind.perception.learned.kinds import Kind
from uniteam.mind.perception.learned.regions import Region
from uniteam.mind.perception.words.meaning import load_words
from uniteam.training.records import Thing
from uniteam.training.sightings import FARTHEST, FEWEST_PIXELS, observation_of
from uniteam.training.views import View

_KINDS = {"object": Kind.OBJECT, "receptacle": Kind.RECEPTACLE}


@dataclass(frozen=True)
class Named:
    """A true region and the likeliest of the names of its group: seen objects, unseen ones, or receptacles."""

    thing: Thing
    pixels: int
    name: str


def named(
    eyes: Eyes,
    views: Iterable[View],
    things: Sequence[Thing],
    groups: Sequence[Collection[str]],
    camera: PinholeCamera,
) -> list[Named]:
    """Return the name of each true region that is there to be seen.

    Args:
        eyes: the networks.
        views: of a home.
        things: what its instances are.
        groups: of names that are told apart; a thing is named within the group of its own.
        camera: with which things are seen, the half or the full one.
    """
    words, found = load_words(), []
    vectors = [np.stack([words.meaning(name).vector for name in sorted(group)]) for group in groups]
    for view in views:
        instances, depth = view.half.instances, view.half.depth
        pixels = np.bincount(instances.ravel() + 1, minlength=len(things) + 1)[1:]
        regions, own = [], []
        for index in map(int, np.flatnonzero(pixels >= FEWEST_PIXELS)):
            mask = instances == index
            if things[index].role in _KINDS and np.median(depth[mask]) <= FARTHEST:
                regions.append(Region(_KINDS[things[index].role], mask, 1.0, np.zeros(0, np.float32)))
                own.append((things[index], int(pixels[index])))
        frame = half_frame(observation_of(view, camera))
        glimpses = eyes.name(regions, frame, view.camera_to_start)
        for glimpse, (thing, count) in zip(glimpses, own, strict=True):
            for group, table in zip(groups, vectors, strict=True):
                if thing.category in group:
                    found.append(Named(thing, count, sorted(group)[int((table @ glimpse.vector).argmax())]))
    return found
