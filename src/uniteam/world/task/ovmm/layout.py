"""Where the challenge's files lie: home-robot's layout, found from a folder of episodes.

    data/datasets/ovmm/val/episodes.json.gz
    data/hssd-hab/scenes-uncluttered/<id>.scene_instance.json
    data/objects/train_val/.../configs/...
    data/objects/hssd-receptacles.csv

Episodes name files by paths that begin with `data/`; what stands for that folder is the one above the episodes in which
these are found, whatever its name.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from uniteam.world.assets.reading import damaged

RECEPTACLES_CSV = "hssd-receptacles.csv"


@dataclass(frozen=True)
class DataFolder:
    """The folder that episodes call `data/`."""

    root: Path

    def file(self, named: str) -> Path:
        """Return the file that a path of an episode names."""
        return self.root.joinpath(*_inner(named))

    def receptacle_tables(self) -> list[Path]:
        """Return the tables of furniture's classes that there are."""
        return sorted((self.root / "objects").rglob(RECEPTACLES_CSV))


def find_data(episodes: Path, scene_id: str) -> DataFolder:
    """Return the folder of data for the episodes of a folder.

    Args:
        episodes: the folder.
        scene_id: of an episode of it, "data/hssd-hab/...".

    Raises:
        DamagedFileError: none of the folders above holds that scene.
    """
    inner = _inner(scene_id)
    above = _above(episodes.resolve())
    found = next((folder for folder in above if folder.joinpath(*inner).is_file()), None)
    if found is None:
        found = next((folder for folder in above if (folder / inner[0]).is_dir()), None)
    if found is None:
        reason = f"no folder above holds '{'/'.join(inner)}'; lay the scenes out as docs/official-data.md says"
        raise damaged(episodes, "the scenes of the episodes in", reason)
    return DataFolder(found)


def _above(folder: Path) -> Iterable[Path]:
    return [candidate for parent in (folder, *folder.parents) for candidate in (parent, parent / "data")]


def _inner(named: str) -> tuple[str, ...]:
    """Return the parts of a path without its first `data/`; none that leads upwards."""
    parts = tuple(part for part in PurePosixPath(named).parts if part not in ("..", ".", "/"))
    return parts[1:] if parts[:1] == ("data",) and len(parts) > 1 else parts
