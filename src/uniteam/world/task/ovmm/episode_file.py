"""The files of a split of the challenge's episodes, as far as they are read.

Written by habitat-lab's OVMM branch (`rearrange_generator.py`, `ovmm_dataset.py`): `episodes.json.gz`, and two arrays
to whose rows its episodes may point instead of holding matrices and view points themselves.
"""

import gzip
import zlib
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import msgspec
import numpy as np
from numpy.typing import NDArray

from uniteam.world.assets.reading import damaged
from uniteam.world.homes.readers.hssd_schema import Three

EPISODES, VIEW_POINTS, TRANSFORMATIONS = "episodes.json.gz", "viewpoints.npy", "transformations.npy"
FILES = (EPISODES, VIEW_POINTS, TRANSFORMATIONS)
MOST_BYTES = 4 * 1024**3
"""Of the episodes once unpacked."""

_WHAT = "the episodes"
Quaternion = tuple[float, float, float, float]
Rows = list[list[float]]


class AgentState(msgspec.Struct):
    """Where an agent stands: Habitat's world, (x, y, z, w)."""

    position: Three
    rotation: Quaternion = (0.0, 0.0, 0.0, 1.0)


class ViewPoint(msgspec.Struct):
    """A place from which a goal is seen."""

    agent_state: AgentState


class Goal(msgspec.Struct):
    """An object or a receptacle's surface that counts.

    Attributes:
        object_id: of an object its index in `rigid_objs`; of a receptacle a number that says nothing outside of the
            simulator.
        object_name: of an object its config; of a receptacle "<furniture's instance>|<receptacle>".
        view_points: in full, or rows of `viewpoints.npy`.
    """

    object_id: str
    object_name: str = ""
    object_category: str = ""
    view_points: list[int | ViewPoint] = []


class OvmmEpisode(msgspec.Struct):
    """An episode; a rigid object's pose is a (4, 4) matrix by rows, or a row of `transformations.npy`."""

    episode_id: str
    scene_id: str
    start_position: Three
    start_rotation: Quaternion
    rigid_objs: list[tuple[str, int | Rows]]
    object_category: str
    start_recep_category: str
    goal_recep_category: str
    candidate_objects: list[Goal]
    candidate_goal_receps: list[Goal]
    candidate_start_receps: list[Goal] = []
    additional_obj_config_paths: list[str] = []
    name_to_receptacle: dict[str, str] = {}


class _Content(msgspec.Struct):
    episodes: list[OvmmEpisode]


@dataclass(frozen=True)
class OvmmFiles:
    """What a folder of episodes holds.

    Attributes:
        folder: in which they lie.
        episodes: in the file's order.
        transformations: (N, 3, 4) float64, rotation and translation in Habitat's world.
        view_points: (M, 3) float64 positions in Habitat's world.
    """

    folder: Path
    episodes: Sequence[OvmmEpisode]
    transformations: NDArray[np.float64]
    view_points: NDArray[np.float64]

    def pose(self, transform: int | Rows) -> NDArray[np.float64]:
        """Return the (3, 4) pose that an episode gives an object; raises ValueError where it gives none."""
        if isinstance(transform, int):
            if not 0 <= transform < len(self.transformations):
                raise ValueError(f"row {transform} of {TRANSFORMATIONS} does not exist")
            return self.transformations[transform]
        matrix = np.array(transform, dtype=np.float64)
        if matrix.shape not in ((4, 4), (3, 4)):
            raise ValueError("a rigid object's transform is no (4, 4) matrix")
        return matrix[:3]

    def seen_from(self, goal: Goal) -> NDArray[np.float64]:
        """Return the (K, 3) view points of a goal in Habitat's world; raises ValueError where there are no such."""
        return np.array([self._seen_from(point) for point in goal.view_points]).reshape(-1, 3)

    def _seen_from(self, point: int | ViewPoint) -> Sequence[float]:
        if isinstance(point, ViewPoint):
            return point.agent_state.position
        if not 0 <= point < len(self.view_points):
            raise ValueError(f"row {point} of {VIEW_POINTS} does not exist")
        row: Sequence[float] = self.view_points[point]
        return row


def read_ovmm_files(folder: Path) -> OvmmFiles:
    """Return the episodes of a folder with their arrays; an array that is missing is empty.

    Raises:
        DamagedFileError: the episodes are missing, or a file is not what it should be; the sentence names the field.
    """
    episodes = _read_episodes(folder / EPISODES)
    transformations = _read_array(folder / TRANSFORMATIONS, (3, 4))
    view_points = _read_array(folder / VIEW_POINTS, (8,))
    return OvmmFiles(folder, episodes, transformations, view_points[:, :3].astype(np.float64))


def _read_episodes(path: Path) -> list[OvmmEpisode]:
    try:
        with gzip.open(path) as file:
            content = file.read(MOST_BYTES + 1)
        if len(content) > MOST_BYTES:
            raise damaged(path, _WHAT, f"unpacked they have more than {MOST_BYTES} bytes")
        return msgspec.json.decode(content, type=_Content).episodes
    except FileNotFoundError as error:
        raise damaged(path, _WHAT, "there is no such file") from error
    except (OSError, EOFError, zlib.error, msgspec.MsgspecError, RecursionError) as error:
        raise damaged(path, _WHAT, str(error).replace("`$.", "`")) from error


def _read_array(path: Path, shape: tuple[int, ...]) -> NDArray[np.float64]:
    if not path.exists():
        return np.zeros((0, *shape))
    try:
        values = np.load(path, allow_pickle=False)
    except (OSError, ValueError, EOFError) as error:
        raise damaged(path, "the array", str(error)) from error
    if not isinstance(values, np.ndarray) or values.dtype.kind != "f" or values.shape[1:] != shape:
        raise damaged(path, "the array", f"it must hold rows of {' x '.join(map(str, shape))} floating-point numbers")
    if not np.isfinite(values).all():
        raise damaged(path, "the array", "a number of it is not finite")
    return values.astype(np.float64)
