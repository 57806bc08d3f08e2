"""Splits as files: JSON lines, gzip, self-contained.

A line is one of `{"home": {...}}` (once for each home, objects at rest where physics left them), `{"view_points":
{"home": name, "instances": {name: runs}}}` (see `lattice`) and `{"episode": {...}}`. A file may also be plain JSON
lines, so that a split can be written by hand.
"""

import gzip
import json
import zlib
from collections.abc import Iterator, Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

from uniteam.errors import DamagedFileError, UnknownNameError
from uniteam.geometry import BasePose, Point2
from uniteam.interface import Instruction, Joints
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES
from uniteam.world.homes.home import Home
from uniteam.world.homes.serialization import home_from_data, home_to_data
from uniteam.world.task.episode import Candidate, Certificate, Episode, Split
from uniteam.world.task.lattice import points_to_runs, runs_to_points

SPLIT_DIRECTORY = Path(__file__).parent / "splits"
SPLIT_NAMES = ("minival", "val", "test-standard", "test-challenge", "train")
SUFFIX = ".jsonl.gz"

_GZIP_MAGIC = b"\x1f\x8b"
ViewPoints = dict[str, tuple[Point2, ...]]


class _LazyHomes(Mapping[str, Home]):
    """Homes by name, each built from its data when it is first asked for."""

    def __init__(self, path: Path, data: dict[str, dict[str, Any]]) -> None:
        self._path = path
        self._data = data
        self._homes: dict[str, Home] = {}

    def __getitem__(self, name: str) -> Home:
        if name not in self._homes:
            data = self._data[name]
            try:
                self._homes[name] = home_from_data(data, self._path.parent)
            except (KeyError, TypeError, ValueError) as error:
                raise _damaged(self._path, f"home '{name}' is incomplete: {error!r}") from error
        return self._homes[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._data)

    def __len__(self) -> int:
        return len(self._data)


def load_split(name_or_path: str | Path) -> Split:
    """Read a built-in split by its name, or a split's file by its path.

    Raises:
        UnknownNameError: neither a built-in split nor a file; or an episode names a category that does not exist.
        DamagedFileError: the file is not a split.
    """
    path = _path_of(str(name_or_path))
    lines = _read_lines(path)
    try:
        homes = {line["home"]["name"]: line["home"] for line in lines if "home" in line}
        view_points = {v["home"]: _decode_view_points(v) for v in _contents(lines, "view_points")}
        episodes = tuple(_decode_episode(e, homes, view_points) for e in _contents(lines, "episode"))
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise _damaged(path, f"{type(error).__name__} {error}") from error
    if not episodes:
        raise _damaged(path, "it holds no episode")
    return Split(path.name.removesuffix(".gz").removesuffix(".jsonl"), episodes, _LazyHomes(path, homes))


def write_split(split: Split, path: Path) -> None:
    """Write a split so that the same split gives the same bytes."""
    lines: list[dict[str, Any]] = []
    for name, home in split.homes.items():
        episodes = [e for e in split.episodes if e.home == name]
        candidates = [c for e in episodes for c in (*e.objects, *e.goal_receptacles)]
        runs = {c.name: points_to_runs(c.view_points) for c in sorted(candidates, key=lambda c: c.name)}
        lines.append({"home": home_to_data(home, path.parent)})
        lines.append({"view_points": {"home": name, "instances": runs}})
        lines += ({"episode": _encode_episode(episode)} for episode in episodes)
    text = "".join(json.dumps(line, separators=(",", ":")) + "\n" for line in lines)
    partial = path.with_name(path.name + ".partial")
    partial.write_bytes(gzip.compress(text.encode(), mtime=0))
    partial.replace(path)


def _path_of(name_or_path: str) -> Path:
    if name_or_path in SPLIT_NAMES:
        return SPLIT_DIRECTORY / f"{name_or_path}{SUFFIX}"
    path = Path(name_or_path)
    if not path.is_file():
        raise UnknownNameError("split or episode file", name_or_path, SPLIT_NAMES)
    return path


def _read_lines(path: Path) -> list[dict[str, Any]]:
    try:
        content = path.read_bytes()
        text = (gzip.decompress(content) if content.startswith(_GZIP_MAGIC) else content).decode("utf-8")
        lines = [json.loads(line) for line in text.splitlines() if line.strip()]
    except (OSError, EOFError, ValueError, zlib.error) as error:
        raise _damaged(path, str(error)) from error
    if not all(isinstance(line, dict) for line in lines):
        raise _damaged(path, "a line is not a JSON object")
    return lines


def _contents(lines: list[dict[str, Any]], key: str) -> Iterator[dict[str, Any]]:
    return (line[key] for line in lines if key in line)


def _damaged(path: Path, what: str) -> DamagedFileError:
    return DamagedFileError(
        f"the episode file {path} cannot be read ({what}); write it again with 'uniteam episodes', or reinstall uniteam"
    )


def _decode_view_points(data: dict[str, Any]) -> ViewPoints:
    return {name: runs_to_points(runs) for name, runs in data["instances"].items()}


def _encode_episode(episode: Episode) -> dict[str, Any]:
    return {
        "id": episode.id,
        "home": episode.home,
        "start": asdict(episode.start),
        "instruction": asdict(episode.instruction),
        "objects": [candidate.name for candidate in episode.objects],
        "start_receptacles": list(episode.start_receptacles),
        "goal_receptacles": [candidate.name for candidate in episode.goal_receptacles],
        "unseen": episode.unseen,
        "seed": episode.seed,
        "certificate": asdict(episode.certificate) if episode.certificate else None,
    }


def _decode_episode(data: dict[str, Any], homes: dict[str, Any], view_points: dict[str, ViewPoints]) -> Episode:
    instruction = Instruction(**data["instruction"])
    _check_categories(instruction)
    if data["home"] not in homes:
        raise ValueError(f"episode '{data['id']}' is in home '{data['home']}', which the file does not hold")
    seen_from = view_points[data["home"]]
    _check_instances(data, {instance["name"] for instance in homes[data["home"]]["instances"]})
    certificate = data.get("certificate")
    return Episode(
        id=data["id"],
        home=data["home"],
        start=BasePose(**data["start"]),
        instruction=instruction,
        objects=tuple(Candidate(name, seen_from[name]) for name in data["objects"]),
        start_receptacles=tuple(data["start_receptacles"]),
        goal_receptacles=tuple(Candidate(name, seen_from[name]) for name in data["goal_receptacles"]),
        unseen=data["unseen"],
        seed=data["seed"],
        certificate=_decode_certificate(certificate) if certificate else None,
    )


def _decode_certificate(data: dict[str, Any]) -> Certificate:
    return Certificate(
        object=data["object"],
        grasp=BasePose(**data["grasp"]),
        receptacle=data["receptacle"],
        release=BasePose(**data["release"]),
        release_joints=Joints(**data["release_joints"]),
    )


def _check_instances(data: dict[str, Any], names: set[str]) -> None:
    unknown = sorted({*data["objects"], *data["start_receptacles"], *data["goal_receptacles"]} - names)
    if unknown:
        raise ValueError(f"episode '{data['id']}' speaks of '{unknown[0]}', which its home does not hold")


def _check_categories(instruction: Instruction) -> None:
    objects = load_catalogue().object_categories
    if instruction.object_category not in objects:
        raise UnknownNameError("object category", instruction.object_category, objects)
    for category in (instruction.start_receptacle, instruction.goal_receptacle):
        if category not in RECEPTACLE_CATEGORIES:
            raise UnknownNameError("receptacle category", category, RECEPTACLE_CATEGORIES)
