"""Views of training homes on the disk, made a home at a time; what is there is not made again."""

from collections.abc import Callable
from pathlib import Path

import numpy as np

from uniteam.files import try_folder
from uniteam.training.crop_samples import crops_of
from uniteam.training.other_looks import other_looks
from uniteam.training.records import CropRecord, Crops, FrameRecord, Frames, frame_record, write_records
from uniteam.training.views import training_home, views_of
from uniteam.world.assets.catalogue import Catalogue

VIEWS_A_HOME = 60


def make_views(
    folder: Path,
    homes: range,
    on_home: Callable[[], None],
    views: int = VIEWS_A_HOME,
    library: Catalogue | None = None,
) -> None:
    """Make the frames and crops of training homes that a folder lacks.

    Args:
        folder: where they are kept.
        homes: their numbers.
        on_home: called after each.
        views: of each home.
        library: of the homes' models; None for the pack.

    Raises:
        UnwritableError: the folder cannot be written into.
    """
    try_folder(folder)
    for number in homes:
        if not crops_path(folder, number).exists():
            _make_home(folder, number, views, library)
        on_home()


def crops_path(folder: Path, number: int) -> Path:
    """Return where the crops of a home are kept."""
    return folder / f"crops-{number:05d}.msgpack"


def frames_path(folder: Path, number: int) -> Path:
    """Return where the frames of a home are kept."""
    return folder / f"frames-{number:05d}.msgpack"


def _make_home(folder: Path, number: int, views: int, library: Catalogue | None) -> None:
    home, rng = training_home(number, library), np.random.default_rng([number, 7])
    looks = other_looks(home, np.random.default_rng([number, 17]))
    things = looks.things_of(home)
    frames: list[FrameRecord] = []
    crops: list[CropRecord] = []
    for view in views_of(home, views, rng, mesh_of=looks.mesh_of):
        frames.append(frame_record(view))
        crops += crops_of(view, things, rng)
    write_records(frames_path(folder, number), Frames(things, frames))
    write_records(crops_path(folder, number), Crops(crops))
