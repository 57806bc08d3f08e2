"""Splits as files: JSON lines, gzip, self-contained.

Everything is checked when it is read: the fields of a line by `split_schema`, an episode by `check_episode`. A line is
one of `{"split": {"version": 2}}` (once; a file without it is of version 1), `{"home": {...}}` (once for each home,
objects at rest), `{"view_points": {"home": name, "instances": {name: runs}}}` (see `lattice`) and `{"episode": {...}}`.
A file may also be plain JSON lines, so that a split can be written by hand.
"""

import gzip
import zlib
from pathlib import Path
from typing import TypeVar

import msgspec

from uniteam.errors import DamagedFileError, UniteamError, UnknownNameError
from uniteam.files import write_whole
from uniteam.geometry import BasePose, Point2
from uniteam.interface import Instruction, Joints
from uniteam.world.assets.reading import decode_json
from uniteam.world.homes.home import Home
from uniteam.world.homes.serialization import home_from_data
from uniteam.world.task.check_episode import episode_problems
from uniteam.world.task.encode_split import encode_split
from uniteam.world.task.episode import Candidate, Certificate, Episode, Split
from uniteam.world.task.lattice import runs_to_points
from uniteam.world.task.ovmm.ovmm_name import parse_ovmm_name
from uniteam.world.task.split_schema import (
    MOST_BYTES,
    MOST_VIEW_POINTS,
    CertificateData,
    EpisodeData,
    LineData,
    PoseData,
    ViewPointsData,
)
from uniteam.world.task.tags import Tags

SPLIT_DIRECTORY = Path(__file__).parent / "splits"
SPLIT_NAMES = ("minival", "val", "test-standard", "test-challenge", "train")
SUFFIX = ".jsonl.gz"

_GZIP_MAGIC = b"\x1f\x8b"
ViewPoints = dict[str, tuple[Point2, ...]]
Value = TypeVar("Value")


def load_split(name_or_path: str | Path) -> Split:
    """Read a built-in split by its name, a file by its path, or a folder of the challenge's files by "ovmm:FOLDER".

    Raises:
        UnknownNameError: neither a built-in split nor a file.
        DamagedFileError: the file is not a split, or something in it makes no sense; the sentence says where.
    """
    if (official := parse_ovmm_name(str(name_or_path))) is not None:
        return official.load()
    path = _path_of(str(name_or_path))
    return decode_split(_read(path), path)


def decode_split(content: bytes, path: Path) -> Split:
    """Return the split that the lines of a file say.

    Args:
        content: of the file, unpacked.
        path: of the file; the split bears its name, and what it names lies beside it.

    Raises:
        DamagedFileError: the content is not a split, or something in it makes no sense; the sentence says where.
    """
    contents = _Contents(path)
    for number, line in enumerate(content.split(b"\n"), start=1):
        if line.strip():
            try:
                contents.add(line)
            except (msgspec.MsgspecError, RecursionError, ValueError, UniteamError) as error:
                raise _damaged(path, f"line {number}: {_field(error)}") from error
    try:
        episodes = contents.episodes()
    except ValueError as error:
        raise _damaged(path, str(error)) from error
    if not episodes:
        raise _damaged(path, "it holds no episode")
    return Split(path.name.removesuffix(".gz").removesuffix(".jsonl"), episodes, contents.homes, contents.version)


def split_files(name: str) -> tuple[Path, ...]:
    """Return the files in which the episodes of a split stand; raises UnknownNameError."""
    return (_path_of(name),) if (official := parse_ovmm_name(name)) is None else official.files()


def split_label(name: str) -> str:
    """Return a short name for a split, which can be a folder's."""
    return Path(name).name.split(".")[0] if (official := parse_ovmm_name(name)) is None else official.label


class _Contents:
    """What the lines of a file hold; nothing in it comes twice."""

    def __init__(self, path: Path) -> None:
        self._folder = path.parent
        self._view_points: dict[str, ViewPoints] = {}
        self._count = 0
        self._episodes: dict[str, EpisodeData] = {}
        self._versions: dict[str, int] = {}
        self.homes: dict[str, Home] = {}

    @property
    def version(self) -> int:
        """Of the split; 1 where no line says so."""
        return self._versions.get("version", 1)

    def add(self, line: bytes) -> None:
        """Take in a line."""
        data = decode_json(line, LineData)
        parts = (data.home, data.view_points, data.episode, data.split)
        if sum(part is not msgspec.UNSET for part in parts) != 1:
            raise ValueError("it must hold one of home, view_points, episode and split")
        if data.home is not msgspec.UNSET:
            home = home_from_data(msgspec.json.decode(data.home), self._folder)
            _add(self.homes, "home", home.name, home)
        if data.view_points is not msgspec.UNSET:
            _add(self._view_points, "view points of home", data.view_points.home, self._points(data.view_points))
        if data.episode is not msgspec.UNSET:
            _add(self._episodes, "episode", data.episode.id, data.episode)
        if data.split is not msgspec.UNSET:
            _add(self._versions, "split's", "version", data.split.version)

    def episodes(self) -> tuple[Episode, ...]:
        """Return the episodes; raises ValueError that names the one in which something is wrong."""
        return tuple(self._checked(data) for data in self._episodes.values())

    def _points(self, data: ViewPointsData) -> ViewPoints:
        points = {}
        for name, runs in data.instances.items():
            try:
                points[name] = runs_to_points(runs)
            except ValueError as error:
                raise ValueError(f"view points of '{name}' in home '{data.home}': {error}") from error
            self._count += len(points[name])
            if self._count > MOST_VIEW_POINTS:
                raise ValueError(f"the file holds more than {MOST_VIEW_POINTS} view points")
        return points

    def _checked(self, data: EpisodeData) -> Episode:
        if data.home not in self.homes:
            raise ValueError(f"episode '{data.id}': home: the file holds no '{data.home}'")
        episode = _episode(data, self._view_points.get(data.home, {}))
        problem = next(episode_problems(episode, self.homes[data.home]), None)
        if problem is not None:
            raise ValueError(f"episode '{data.id}': {problem}")
        return episode


def _add(known: dict[str, Value], kind: str, name: str, value: Value) -> None:
    if name in known:
        raise ValueError(f"the {kind} '{name}' comes twice")
    known[name] = value


def _field(error: Exception) -> str:
    """Return what is wrong, with the field's plain path."""
    return str(error).replace("`$.", "`") or type(error).__name__


def write_split(split: Split, path: Path) -> None:
    """Write a split, packed; raises UnwritableError."""
    write_whole(path, gzip.compress(encode_split(split, path.parent), mtime=0))


def _path_of(name_or_path: str) -> Path:
    if name_or_path in SPLIT_NAMES:
        return SPLIT_DIRECTORY / f"{name_or_path}{SUFFIX}"
    path = Path(name_or_path)
    try:
        is_file = path.is_file()
    except (OSError, ValueError):
        is_file = False
    if not is_file:
        raise UnknownNameError("split or episode file", name_or_path, SPLIT_NAMES, "a file, or ovmm:FOLDER")
    return path


def _read(path: Path) -> bytes:
    """Return a file's content, unpacked as far as is sensible."""
    try:
        with path.open("rb") as file:
            is_packed = file.read(len(_GZIP_MAGIC)) == _GZIP_MAGIC
        with gzip.open(path) if is_packed else path.open("rb") as content:
            unpacked: bytes = content.read(MOST_BYTES + 1)
    except (OSError, EOFError, ValueError, zlib.error) as error:
        raise _damaged(path, str(error)) from error
    if len(unpacked) > MOST_BYTES:
        raise _damaged(path, f"unpacked it has more than {MOST_BYTES} bytes")
    return unpacked


def _damaged(path: Path, what: str) -> DamagedFileError:
    return DamagedFileError(
        f"the episode file {path} cannot be read ({what}); write it again with 'uniteam episodes', or reinstall uniteam"
    )


def _episode(data: EpisodeData, seen_from: ViewPoints) -> Episode:
    """Return the episode; what nobody gave view points has none."""
    return Episode(
        id=data.id,
        home=data.home,
        start=_pose(data.start),
        instruction=Instruction(**msgspec.structs.asdict(data.instruction)),
        objects=tuple(Candidate(name, seen_from.get(name, ())) for name in data.objects),
        start_receptacles=tuple(data.start_receptacles),
        goal_receptacles=tuple(Candidate(name, seen_from.get(name, ())) for name in data.goal_receptacles),
        unseen=data.unseen,
        seed=data.seed,
        certificate=None if data.certificate is None else _certificate(data.certificate),
        tags=None if data.tags is None else Tags(**msgspec.structs.asdict(data.tags)),
    )


def _certificate(data: CertificateData) -> Certificate:
    release, grasp = (Joints(**msgspec.structs.asdict(joints)) for joints in (data.release_joints, data.grasp_joints))
    stands = _pose(data.grasp), _pose(data.release)
    return Certificate(data.object, stands[0], data.receptacle, stands[1], release, grasp, data.release_rise)


def _pose(data: PoseData) -> BasePose:
    return BasePose(data.x, data.y, data.heading)
