"""Read a recording: what was asked, decided, seen and true, step by step."""

import io
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from uniteam.errors import DamagedFileError
from uniteam.evaluation.recording.archive import damaged, read_archive
from uniteam.evaluation.recording.camera_films import COLOUR_FILM, DEPTH_FILM, HIGH_LABEL_FILM, LABEL_FILM
from uniteam.evaluation.recording.depth_code import STRIDE, decode_depth
from uniteam.evaluation.recording.header import Header, header_from_json
from uniteam.evaluation.recording.label_video import decode_labels
from uniteam.evaluation.recording.map_track import read_maps
from uniteam.evaluation.recording.pose_track import PoseTrack
from uniteam.evaluation.recording.step_line import RecordedStep, step_from_line
from uniteam.evaluation.recording.video import BYTES, COLOUR, decode_video
from uniteam.evaluation.results.result import EpisodeResult, result_from_line
from uniteam.geometry import BasePose
from uniteam.interface import Joints, MapOverlay, Segmentation
from uniteam.world.homes.home import Home
from uniteam.world.task.episode import Episode, Split
from uniteam.world.task.splits import decode_split, load_split

EPISODE = "episode.jsonl"
"""The member with the episode and its home, where a file can say it."""

_ROWS: Mapping[str, tuple[tuple[int, ...], type]] = {
    "robot/base_to_start": ((3,), np.float64),
    "robot/joints": ((7,), np.float64),
    "robot/camera_to_start": ((4, 4), np.float64),
    "robot/is_holding": ((), np.bool_),
    "robot/checksums": ((3,), np.uint32),
    "truth/base_to_world": ((3,), np.float64),
    "truth/joints": ((7,), np.float64),
}
"""Arrays with a row a moment: what a row is. The robot's have none where no step was taken."""


@dataclass(frozen=True)
class RecordedFrame:
    """What the agent saw at a moment, as nearly as it was kept.

    Attributes:
        rgb: (H, W, 3) uint8, compressed with losses.
        depth: (ceil(H / 2), ceil(W / 2)) float32, metres: every second pixel each way, to 1 %; 0 where there is none.
        segmentation: what the perception answered, exactly; None for an agent that does not say, and at the last
            moment, upon which nothing was decided.
    """

    rgb: NDArray[np.uint8]
    depth: NDArray[np.float32]
    segmentation: Segmentation | None


class Recording:
    """An episode as it was played.

    A *moment* is what there was at one time: 0 is before the first step, k is after k steps. Step k is what the agent
    decided and did upon what it saw at moment k; so there is one moment more. What is called truth it was not told.

    Attributes:
        path: of the file.
        header: what it is of: agent, configuration, camera, names.
        result: what the episode came to, as in `results.jsonl`.
        steps: what was decided, why, and what came of it.
        objects: where the movable instances were at each moment (truth).
    """

    def __init__(self, path: Path, members: Mapping[str, bytes]) -> None:
        """Take the members of a recording's archive; `read_recording` reads a file."""
        self.path, self._members = path, members
        with self._reading():
            self.header: Header = header_from_json(members["recording.json"])
            self.result: EpisodeResult = result_from_line(members["result.json"])[1]
            self.steps: tuple[RecordedStep, ...] = self._read_steps()
            self._rows = {name: self._read_rows(name) for name in _ROWS}
            self.objects = PoseTrack(
                self.header.objects,
                *(self._array(f"truth/object_{name}") for name in ("moments", "indices", "poses")),
            )
            self._pixels = self._array("truth/visible_pixels")
            if self._pixels.shape != (len(self.steps) + 1, len(self.header.instances)):
                raise ValueError("the visible pixels are not of every moment and instance")

    @property
    def episode(self) -> Episode:
        """What was asked, and what would have counted."""
        return self.split.episodes[0]

    @property
    def home(self) -> Home:
        """Where it was played, with the objects where they lay at first."""
        return self.split.homes[self.episode.home]

    @cached_property
    def split(self) -> Split:
        """The one episode and its home, as a split.

        Raises:
            UniteamError: they lie in the data of the split that was played, which is not there any more, or is other.
        """
        if EPISODE not in self._members:
            return self._of_source(load_split(self.header.split))
        with self._reading():
            return replace(decode_split(self._members[EPISODE], self.path), name=self.split_name)

    def _of_source(self, source: Split) -> Split:
        own = tuple(episode for episode in source.episodes if episode.id == self.result.episode)
        homes = {episode.home: source.homes[episode.home] for episode in own}
        instances = [tuple(instance.name for instance in home.instances) for home in homes.values()]
        if instances != [self.header.instances]:
            raise damaged(self.path, f"'{self.header.split}', on which it was played, does not have its home any more")
        return Split(self.split_name, own, homes)

    @property
    def split_name(self) -> str:
        """Name of the split that the episode is from."""
        return str(self.header.configuration.get("split", ""))

    def base_to_start(self, moment: int) -> BasePose:
        """Return where the robot believed to be (m, rad, start frame)."""
        return BasePose(*map(float, self._rows["robot/base_to_start"][moment]))

    def joints(self, moment: int) -> Joints:
        """Return where the robot felt its joints."""
        return Joints(*map(float, self._rows["robot/joints"][moment]))

    def camera_to_start(self, moment: int) -> NDArray[np.float64]:
        """Return the (4, 4) pose of the camera as the robot believed it."""
        return np.array(self._rows["robot/camera_to_start"][moment])

    def is_holding(self, moment: int) -> bool:
        """Return whether the gripper felt something."""
        return bool(self._rows["robot/is_holding"][moment])

    def checksums(self, moment: int) -> tuple[int, ...]:
        """Return the checksums of what the agent saw, in the order of `checksums_of`."""
        return tuple(map(int, self._rows["robot/checksums"][moment]))

    def base_to_world(self, moment: int) -> BasePose:
        """Return where the base was (m, rad, world; truth)."""
        return BasePose(*map(float, self._rows["truth/base_to_world"][moment]))

    def true_joints(self, moment: int) -> Joints:
        """Return where the joints were (truth)."""
        return Joints(*map(float, self._rows["truth/joints"][moment]))

    def visible_pixels(self, instance: str) -> NDArray[np.int32]:
        """Return how many pixels of the head camera showed an instance of the home at each moment, (M,) (truth)."""
        return np.array(self._pixels[:, self.header.instances.index(instance)])

    def frames(self) -> Iterator[RecordedFrame]:
        """Yield what the agent saw, moment by moment; raises DamagedFileError."""
        camera, contents = self.header.camera, self._members
        size, half = (camera.height, camera.width), (-(-camera.height // STRIDE), -(-camera.width // STRIDE))
        with self._reading():
            films = (
                decode_video(contents[COLOUR_FILM], COLOUR, *size),
                decode_video(contents[DEPTH_FILM], BYTES, *half),
                decode_labels(contents[LABEL_FILM], contents.get(HIGH_LABEL_FILM, b""), *size),
            )
            detections = (*(step.detections for step in self.steps), None)[: len(self._rows["robot/joints"])]
            for known, rgb, code, labels in zip(detections, *films, strict=True):
                seen = None if known is None else Segmentation(labels, known)
                yield RecordedFrame(rgb, decode_depth(code), seen)

    def maps(self) -> Iterator[MapOverlay | None]:
        """Yield the agent's map and plan, step by step, None where it showed none; raises DamagedFileError."""
        with self._reading():
            arrays = {name: self._array(f"map/{name}") for name in ("cells", "labels", "points")}
            yield from read_maps((step.map for step in self.steps), arrays)

    def _read_steps(self) -> tuple[RecordedStep, ...]:
        steps = tuple(step_from_line(line) for line in self._members["steps.jsonl"].splitlines())
        if [step.step for step in steps] != list(range(self.header.steps)):
            raise ValueError(f"its steps are not those from 0 to {self.header.steps - 1}")
        return steps

    def _read_rows(self, name: str) -> NDArray[Any]:
        row, kind = _ROWS[name]
        count = len(self.steps) + 1 if self.steps or name.startswith("truth/") else 0
        array = self._array(name)
        if array.shape != (count, *row) or array.dtype != kind:
            raise ValueError(f"'{name}' holds {array.shape} {array.dtype}")
        return array

    def _array(self, name: str) -> NDArray[Any]:
        array: NDArray[Any] = np.load(io.BytesIO(self._members[f"{name}.npy"]), allow_pickle=False)
        return array

    @contextmanager
    def _reading(self) -> Iterator[None]:
        """Raise DamagedFileError, with the file's name, for whatever does not fit in it."""
        try:
            yield
        except KeyError as error:
            raise damaged(self.path, f"{error.args[0]} is missing") from error
        except (msgspec.MsgspecError, DamagedFileError, EOFError, RecursionError, ValueError) as error:
            raise damaged(self.path, str(error)) from error


def read_recording(path: str | Path) -> Recording:
    """Read a recording.

    Args:
        path: of a file that `uniteam evaluate --record` or `uniteam run --record` wrote.

    Raises:
        DamagedFileError: there is no such file, or it is no whole recording.
        NewerFormatError: it is of a later version of the format.
    """
    return Recording(Path(path), read_archive(Path(path)))
