"""Crops of what the segmenter itself proposes: the masks that the namer will see, and its false alarms as junk."""

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np

from uniteam.files import try_folder
from uniteam.mind.perception.learned.eyes import segmented
from uniteam.mind.perception.learned.networks import Network
from uniteam.stretch import HEAD_CAMERA_HALF
from uniteam.training.crop_samples import crop_record
from uniteam.training.other_looks import other_looks
from uniteam.training.records import CropRecord, Crops, Thing, write_records
from uniteam.training.sightings import observation_of
from uniteam.training.views import View, training_home, views_of
from uniteam.world.assets.catalogue import Catalogue

OF_A_THING, OF_NONE = 0.4, 0.2
"""Intersection over union with the nearest thing from which a proposal is that thing, and up to which it is none."""


def make_proposals(
    folder: Path,
    segmenter: Path,
    homes: range,
    on_home: Callable[[], None],
    views: int,
    library: Catalogue | None = None,
) -> None:
    """Make the crops of proposals in training homes that a folder lacks.

    Args:
        folder: where they are kept.
        segmenter: the network's file.
        homes: their numbers.
        on_home: called after each.
        views: of each home.
        library: of the homes' models; None for the pack.
    """
    try_folder(folder)
    network = Network(segmenter)
    for number in homes:
        path = folder / f"proposals-{number:05d}.msgpack"
        if not path.exists():
            home, rng = training_home(number, library), np.random.default_rng([number, 11])
            looks = other_looks(home, np.random.default_rng([number, 17]))
            things, seen = looks.things_of(home), views_of(home, views, rng, mesh_of=looks.mesh_of)
            crops = [c for view in seen for c in proposed_crops(view, things, network)]
            write_records(path, Crops(crops))
        on_home()


def proposed_crops(view: View, things: list[Thing], segmenter: Network) -> Iterator[CropRecord]:
    """Yield the crops of a view's proposals that are clearly of a thing, or clearly of none."""
    instances = view.half.instances
    areas = np.bincount(instances.ravel() + 1, minlength=len(things) + 1)[1:]
    for region in segmented(segmenter, observation_of(view, HEAD_CAMERA_HALF)):
        common = np.bincount(instances[region.mask] + 1, minlength=len(things) + 1)[1:]
        overlaps = common / np.maximum(areas + np.count_nonzero(region.mask) - common, 1)
        best = int(overlaps.argmax())
        if overlaps[best] >= OF_A_THING:
            yield crop_record(view, region.mask, things[best])
        elif overlaps[best] <= OF_NONE:
            yield crop_record(view, region.mask, None)
