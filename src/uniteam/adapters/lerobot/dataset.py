"""Recordings as a LeRobotDataset, version 3.0, of which nothing but pyarrow and PyAV is needed.

The layout is that of lerobot 0.6 (`lerobot.datasets`, docs/source/lerobot-dataset-v3.mdx).
"""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from uniteam.adapters.action_vector import ACTION_NAMES
from uniteam.adapters.lerobot.cameras import HEAD, HEAD_DEPTH, FilmedCamera
from uniteam.adapters.lerobot.demonstration import Demonstration, demonstration, pictures
from uniteam.adapters.lerobot.film_series import FilmPlace, FilmSeries, film_info
from uniteam.adapters.lerobot.layout import (
    DATA_FILE_MB,
    DATA_PATH,
    EPISODES_FILE,
    FILES_PER_CHUNK,
    FRAMES_PER_SECOND,
    INFO_FILE,
    STATS_FILE,
    TASKS_FILE,
    VERSION,
    VIDEO_FILE_MB,
    VIDEO_PATH,
    FileNumber,
)
from uniteam.adapters.lerobot.statistics import PixelCounts, Statistics, count_pixels, vector_statistics
from uniteam.adapters.lerobot.tables import StepTable, write_episodes, write_tasks
from uniteam.adapters.state_vector import STATE_NAMES
from uniteam.errors import InvalidInputError
from uniteam.evaluation.recording.recording import Recording
from uniteam.files import write_json
from uniteam.geometry import PinholeCamera

ROBOT_TYPE = "uniteam_stretch"
"""As the LeRobot plug-in of the same name calls the robot."""

Columns = dict[str, NDArray[Any]]

_VECTORS = {"observation.state": STATE_NAMES, "action": ACTION_NAMES}
_NUMBERS = {
    "next.reward": "float32",
    "next.done": "bool",
    "next.success": "bool",
    "timestamp": "float32",
    "frame_index": "int64",
    "episode_index": "int64",
    "index": "int64",
    "task_index": "int64",
}


class DatasetWriter:
    """Writes a dataset into a folder, recording by recording."""

    def __init__(self, root: Path, camera: PinholeCamera, with_depth: bool) -> None:
        """Begin a dataset of pictures of a camera in a folder that exists.

        Raises:
            InvalidInputError: the camera's pictures have an odd height or width, which films cannot have.
        """
        if camera.height % 2 or camera.width % 2:
            raise InvalidInputError(
                f"films need pictures of even size, the camera's are {camera.height}x{camera.width}"
            )
        self._root, self._camera = root, camera
        self._size = (camera.height, camera.width)
        cameras = (HEAD, HEAD_DEPTH) if with_depth else (HEAD,)
        self._films = {each: FilmSeries(root, each.key, each.kind, self._size) for each in cameras}
        self._steps = StepTable(root)
        self._tasks: dict[str, int] = {}
        self._episodes: list[dict[str, Any]] = []
        self._columns: list[Columns] = []
        self._pixels: dict[str, PixelCounts] = {}
        self._count = 0

    def add(self, recording: Recording, advance: Callable[[], None] = lambda: None) -> None:
        """Append the episode of a recording; `advance` is called after each step.

        Raises:
            InvalidInputError: no step was taken in it, or its camera has pictures of another size.
        """
        self._check(recording)
        shown = demonstration(recording)
        pixels, places = self._film(recording, advance)
        columns = self._columns_of(shown)
        file = self._steps.add(columns)
        statistics = _statistics(columns, pixels, tuple(self._films))
        self._episodes.append(self._episode_row(shown, file, places, statistics))
        self._columns.append(columns)
        for key, counts in pixels.items():
            self._pixels[key] = self._pixels[key] + counts if key in self._pixels else counts
        self._count += shown.length

    def finish(self) -> None:
        """Write what is known only at the end; raises InvalidInputError where there is no episode."""
        if not self._episodes:
            raise InvalidInputError("a dataset needs at least one episode")
        self._steps.close()
        for film in self._films.values():
            film.close()
        write_episodes(self._root / EPISODES_FILE, self._episodes)
        write_tasks(self._root / TASKS_FILE, tuple(self._tasks))
        everything = {name: np.concatenate([each[name] for each in self._columns]) for name in self._columns[0]}
        write_json(self._root / STATS_FILE, _statistics(everything, self._pixels, tuple(self._films)))
        write_json(self._root / INFO_FILE, self._info())

    def _check(self, recording: Recording) -> None:
        camera = recording.header.camera
        if not recording.steps:
            raise InvalidInputError(f"in '{recording.path}' no step was taken; leave it out")
        if (camera.height, camera.width) != self._size:
            raise InvalidInputError(
                f"'{recording.path}' has pictures of {camera.height}x{camera.width}, those before it of "
                f"{self._size[0]}x{self._size[1]}; make a dataset of each"
            )

    def _film(
        self, recording: Recording, advance: Callable[[], None]
    ) -> tuple[dict[str, PixelCounts], dict[str, FilmPlace]]:
        """Film what was seen before each step; return the pixels that were counted and where the films are."""
        pixels: dict[str, PixelCounts] = {}
        for film in self._films.values():
            film.begin_episode()
        for frame in pictures(recording):
            for camera, film in self._films.items():
                picture = camera.read(frame)
                film.add(picture)
                counted = count_pixels(picture, len(camera.values))
                pixels[camera.key] = pixels[camera.key] + counted if camera.key in pixels else counted
            advance()
        return pixels, {camera.key: film.end_episode() for camera, film in self._films.items()}

    def _columns_of(self, shown: Demonstration) -> Columns:
        frames = np.arange(shown.length, dtype=np.int64)
        task = self._tasks.setdefault(shown.task, len(self._tasks))
        return {
            "observation.state": shown.states,
            "action": shown.actions,
            "next.reward": shown.rewards,
            "next.done": frames == shown.length - 1,
            "next.success": shown.are_successes,
            "timestamp": (frames / FRAMES_PER_SECOND).astype(np.float32),
            "frame_index": frames,
            "episode_index": np.full(shown.length, len(self._episodes), np.int64),
            "index": self._count + frames,
            "task_index": np.full(shown.length, task, np.int64),
        }

    def _episode_row(
        self, shown: Demonstration, file: FileNumber, places: dict[str, FilmPlace], statistics: dict[str, Statistics]
    ) -> dict[str, Any]:
        row: dict[str, Any] = {
            "episode_index": len(self._episodes),
            "tasks": [shown.task],
            "length": shown.length,
            "dataset_from_index": self._count,
            "dataset_to_index": self._count + shown.length,
            "data/chunk_index": file.chunk,
            "data/file_index": file.file,
            "meta/episodes/chunk_index": 0,
            "meta/episodes/file_index": 0,
        }
        for key, place in places.items():
            row |= {
                f"videos/{key}/chunk_index": place.file.chunk,
                f"videos/{key}/file_index": place.file.file,
                f"videos/{key}/from_timestamp": place.begins,
                f"videos/{key}/to_timestamp": place.ends,
            }
        row |= {f"stats/{key}/{name}": value for key, found in statistics.items() for name, value in found.items()}
        told = {"agent": shown.agent, "episode": shown.episode, "overall_success": shown.is_success}
        return row | {f"uniteam/{name}": value for name, value in told.items()}

    def _info(self) -> dict[str, Any]:
        return {
            "codebase_version": VERSION,
            "robot_type": ROBOT_TYPE,
            "fps": FRAMES_PER_SECOND,
            "total_episodes": len(self._episodes),
            "total_frames": self._count,
            "total_tasks": len(self._tasks),
            "chunks_size": FILES_PER_CHUNK,
            "data_files_size_in_mb": DATA_FILE_MB,
            "video_files_size_in_mb": VIDEO_FILE_MB,
            "splits": {"train": f"0:{len(self._episodes)}"},
            "data_path": DATA_PATH,
            "video_path": VIDEO_PATH,
            "features": self._features(),
        }

    def _features(self) -> dict[str, Any]:
        vectors = {
            key: {"dtype": "float32", "shape": [len(names)], "names": list(names)} for key, names in _VECTORS.items()
        }
        films = {
            camera.key: {
                "dtype": "video",
                "shape": [*self._size, camera.kind.channels],
                "names": ["height", "width", "channels"],
                "info": film_info(camera.kind, self._size),
            }
            for camera in self._films
        }
        numbers = {key: {"dtype": dtype, "shape": [1], "names": None} for key, dtype in _NUMBERS.items()}
        return {**vectors, **films, **numbers}


def _statistics(
    columns: Columns, pixels: dict[str, PixelCounts], cameras: Sequence[FilmedCamera]
) -> dict[str, Statistics]:
    return {
        **{key: vector_statistics(values) for key, values in columns.items()},
        **{camera.key: pixels[camera.key].statistics(camera.values) for camera in cameras},
    }
