"""Splits as files, and the lattice their view points lie on."""

import gzip
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from worlds.filled import filled

from uniteam.errors import DamagedFileError, UnknownNameError
from uniteam.geometry import BasePose
from uniteam.interface import Instruction, Joints
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.homes.home import Home, Instance, Light, Room, Stage
from uniteam.world.homes.polygon import rectangle
from uniteam.world.task.episode import Candidate, Certificate, Episode, Split
from uniteam.world.task.lattice import lattice_points_near, points_to_runs, runs_to_points
from uniteam.world.task.split_schema import MOST_BYTES
from uniteam.world.task.splits import load_split, write_split
from uniteam.world.task.tags import Tags

UPRIGHT = (1.0, 0.0, 0.0, 0.0)


def _home(name: str) -> Home:
    light = Light((1.0, 1.0, 2.4), (1.0, 1.0, 1.0), 0.4)
    room = Room(
        "hall_1", "hall", rectangle((0.0, 0.0), (4.0, 3.0)), "planks_oak", "plaster_white", (1.0, 0.9, 0.8), light
    )
    things = tuple(
        Instance(
            f"{category}_{k}",
            load_catalogue().of_category(category)[0].id,
            category,
            category == "cup",
            (1.0 + k, 1.0, 0.0),
            UPRIGHT,
            "hall_1",
        )
        for category, k in (("table", 1), ("sink", 1), ("sink", 2), ("cup", 1))
    )
    return Home(name, Stage((room,), (), 2.6), things, load_catalogue(), seed=7)


def _episode(identifier: str, home: str) -> Episode:
    release = Joints(lift=0.9, arm=0.3, wrist_pitch=-1.5, head_pan=-1.57, head_tilt=-0.8)
    return Episode(
        id=identifier,
        home=home,
        start=BasePose(1.25, 2.5, -1.0 / 3.0),
        instruction=Instruction("cup", "table", "sink"),
        objects=(Candidate("cup_1", ((0.1, -0.2), (0.2, -0.2), (-0.1, 0.3))),),
        start_receptacles=("table_1",),
        goal_receptacles=(Candidate("sink_1", ((2.0, 2.0),)), Candidate("sink_2", ((2.0, 2.0), (2.1, 2.0)))),
        unseen=True,
        seed=11,
        certificate=Certificate(
            "cup_1", BasePose(0.1, 0.2, 0.3), "sink_1", BasePose(1.0, 2.0, 3.0), release, Joints(0.5, 0.2), 0.25
        ),
        tags=Tags("lived_in", 120.5, 7, 11.2, 0.31, 0.75, 812, 2, 3),
    )


def _split() -> Split:
    homes = {name: _home(name) for name in ("home_1", "home_2")}
    episodes = (_episode("0", "home_1"), _episode("1", "home_1"), _episode("2", "home_2"))
    return Split("mine", episodes, homes, version=3)


def _viewable(episode: Episode) -> list[tuple[str, list[tuple[float, float]]]]:
    return [(c.name, sorted(c.view_points)) for c in (*episode.objects, *episode.goal_receptacles)]


def test_a_split_comes_back_from_its_file_as_it_was_written(tmp_path: Path) -> None:
    split = _split()
    path = tmp_path / "mine.jsonl.gz"
    write_split(split, path)
    read = load_split(str(path))
    assert (read.name, read.version) == ("mine", 3)
    assert dict(read.homes) == split.homes
    for got, expected in filled(zip(read.episodes, split.episodes, strict=True)):
        assert got.certificate == expected.certificate
        assert (got.start, got.instruction, got.seed) == (expected.start, expected.instruction, expected.seed)
        assert _viewable(got) == _viewable(expected)


def test_the_same_split_gives_the_same_bytes(tmp_path: Path) -> None:
    write_split(_split(), tmp_path / "a.jsonl.gz")
    write_split(_split(), tmp_path / "b.jsonl.gz")
    assert (tmp_path / "a.jsonl.gz").read_bytes() == (tmp_path / "b.jsonl.gz").read_bytes()


def test_a_split_may_be_written_by_hand_as_plain_lines(tmp_path: Path) -> None:
    write_split(_split(), tmp_path / "packed.jsonl.gz")
    plain = tmp_path / "plain.jsonl"
    plain.write_bytes(gzip.decompress((tmp_path / "packed.jsonl.gz").read_bytes()))
    assert load_split(plain).name == "plain"
    assert load_split(plain).episodes == load_split(tmp_path / "packed.jsonl.gz").episodes


def test_an_unknown_split_is_answered_with_the_nearest_name() -> None:
    with pytest.raises(UnknownNameError, match="did you mean 'minival'"):
        load_split("minval")


@pytest.mark.parametrize("content", [b"no json", b"\x1f\x8b broken", b'{"episode": {"id": "0"}}', b"[1]", b""])
def test_a_damaged_file_is_named_in_one_sentence(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "bad.jsonl.gz"
    path.write_bytes(content)
    with pytest.raises(DamagedFileError, match=r"bad\.jsonl\.gz"):
        load_split(path)


def test_a_truncated_file_is_damaged(tmp_path: Path) -> None:
    path = tmp_path / "short.jsonl.gz"
    write_split(_split(), path)
    path.write_bytes(path.read_bytes()[:-40])
    with pytest.raises(DamagedFileError, match=r"short\.jsonl\.gz"):
        load_split(path)


@pytest.mark.parametrize("field", ["object_category", "start_receptacle", "goal_receptacle"])
def test_a_category_that_does_not_exist_is_refused(tmp_path: Path, field: str) -> None:
    path = tmp_path / "plain.jsonl"
    write_split(_split(), path)
    lines = [json.loads(line) for line in gzip.decompress(path.read_bytes()).splitlines()]
    for line in lines:
        if "episode" in line:
            line["episode"]["instruction"][field] = "tabel"
    path.write_text("\n".join(json.dumps(line) for line in lines))
    with pytest.raises(DamagedFileError, match=f"episode '0': instruction.{field}: unknown .* category 'tabel'"):
        load_split(path)


def test_an_episode_about_what_its_home_does_not_hold_is_damaged(tmp_path: Path) -> None:
    path = tmp_path / "strange.jsonl"
    homes = {
        name: replace(home, instances=(home.instances[0], *home.instances[2:])) for name, home in _split().homes.items()
    }
    write_split(replace(_split(), homes=homes), path)
    with pytest.raises(DamagedFileError, match="'sink_1' is nothing that its home holds"):
        load_split(path)


def test_runs_hold_exactly_the_lattice_points_they_were_made_of() -> None:
    rng = np.random.default_rng(0)
    around = lattice_points_near(-1.0, 2.0, 1.5, 0.7)
    chosen = around[rng.random(len(around)) < 0.7]
    points = [(float(x), float(y)) for x, y in chosen]
    runs = points_to_runs(points)
    assert sorted(runs_to_points(runs)) == sorted(points)
    assert len(runs) < 2 * len(points)


def test_no_point_of_the_floor_is_farther_from_the_lattice_than_the_judge_allows() -> None:
    lattice = lattice_points_near(0.0, 0.0, 1.0, 1.0)
    places = np.random.default_rng(1).uniform(-0.9, 0.9, (200, 2))
    distances = np.linalg.norm(places[:, None] - lattice[None], axis=2).min(axis=1)
    assert distances.max() < 0.1


NONSENSE: dict[str, Callable[[dict[str, Any]], None]] = {
    "objects": lambda e: e.update(objects=[]),
    "goal_receptacles": lambda e: e.update(goal_receptacles=[]),
    "start: .* outside every room": lambda e: e["start"].update(x=50.0),
    "episode.start.x": lambda e: e["start"].update(x="one"),
    "episode.start.heading": lambda e: e["start"].update(heading=1e9),
    "both 'sink'": lambda e: e["instruction"].update(start_receptacle="sink"),
    "episode.seed": lambda e: e.update(seed=-1),
    "seed`": lambda e: e.update(seed=10**30),
    "'cup_1' is named twice": lambda e: e.update(objects=["cup_1", "cup_1"]),
    "is of class": lambda e: e.update(goal_receptacles=["table_1"]),
    "start_receptacles: 'sink_1' is of class": lambda e: e.update(start_receptacles=["sink_1"]),
    "episode.unseen": lambda e: e.update(unseen="yes"),
    "unknown field `colour`": lambda e: e.update(colour="red"),
    "certificate.object": lambda e: e["certificate"].update(object="sink_1"),
    "holds no 'elsewhere'": lambda e: e.update(home="elsewhere"),
    "comes twice": lambda e: e.update(id="1"),
}


def _lines(tmp_path: Path) -> list[dict[str, Any]]:
    write_split(_split(), tmp_path / "good.jsonl.gz")
    return [json.loads(line) for line in gzip.decompress((tmp_path / "good.jsonl.gz").read_bytes()).splitlines()]


def _load(lines: list[dict[str, Any]], tmp_path: Path) -> Split:
    path = tmp_path / "nonsense.jsonl"
    path.write_text("\n".join(json.dumps(line) for line in lines))
    return load_split(path)


@pytest.mark.parametrize("said", NONSENSE)
def test_nonsense_in_an_episode_is_refused_with_the_file_and_the_field(tmp_path: Path, said: str) -> None:
    lines = _lines(tmp_path)
    NONSENSE[said](next(line["episode"] for line in lines if "episode" in line))
    with pytest.raises(DamagedFileError, match=rf"nonsense\.jsonl.*{said}"):
        _load(lines, tmp_path)


@pytest.mark.parametrize(
    "runs", [[], [1, 2], [20, 0, 10**9], [20, 5, 1], [20, 1, 3, 20, 3, 4], ["a", 1, 1], [900, 1, 1]]
)
def test_view_points_that_make_no_sense_are_refused(tmp_path: Path, runs: list[Any]) -> None:
    lines = _lines(tmp_path)
    next(line["view_points"] for line in lines if "view_points" in line)["instances"]["sink_1"] = runs
    with pytest.raises(DamagedFileError, match="view"):
        _load(lines, tmp_path)


@pytest.mark.parametrize(
    ("field", "value"), [("seed", "7"), ("seed", "11"), ("x", "1.25"), ("low", "[0.0,0.0]"), ("home", '"home_1"')]
)
def test_a_field_that_comes_twice_in_a_line_is_refused(tmp_path: Path, field: str, value: str) -> None:
    write_split(_split(), tmp_path / "good.jsonl.gz")
    text = gzip.decompress((tmp_path / "good.jsonl.gz").read_bytes()).decode()
    path = tmp_path / "doubled.jsonl"
    said = f'"{field}":{value}'
    assert said in text
    path.write_text(text.replace(said, f"{said},{said}", 1))
    with pytest.raises(DamagedFileError, match=rf"doubled\.jsonl .*line \d: the field '{field}' comes twice"):
        load_split(path)


def test_homes_view_points_and_instances_that_come_twice_are_refused(tmp_path: Path) -> None:
    lines = _lines(tmp_path)
    for doubled in lines[:3]:
        with pytest.raises(DamagedFileError, match="comes twice"):
            _load([*lines, doubled], tmp_path)
    home = next(line["home"] for line in lines if "home" in line)
    home["instances"].append(home["instances"][0])
    with pytest.raises(DamagedFileError, match="instance"):
        _load(lines, tmp_path)


@pytest.mark.parametrize("content", [b'{"home":' + b"[" * 100_000, b'{"episode": "\xff"}', b'{"home": null}', b"{}"])
def test_lines_that_are_none_are_refused(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "bad.jsonl").write_bytes(content)
    with pytest.raises(DamagedFileError, match=r"bad\.jsonl"):
        load_split(tmp_path / "bad.jsonl")


def test_a_small_file_that_unpacks_to_a_huge_one_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "bomb.jsonl.gz"
    path.write_bytes(gzip.compress(b" " * (MOST_BYTES + 1), 1))
    with pytest.raises(DamagedFileError, match="more than"):
        load_split(path)


def test_the_digest_is_that_of_the_content(tmp_path: Path) -> None:
    split = _split()
    assert split.digest == _load(_lines(tmp_path), tmp_path).digest
    later = replace(split.episodes[0], seed=12)
    assert replace(split, episodes=(later, *split.episodes[1:])).digest != split.digest
    home = split.homes["home_1"]
    moved = {**split.homes, "home_1": replace(home, stage=replace(home.stage, ceiling_height=2.7))}
    assert replace(split, homes=moved).digest != split.digest


def test_a_file_that_tells_no_version_is_of_the_first(tmp_path: Path) -> None:
    path = tmp_path / "mine.jsonl"
    write_split(_split(), path)
    lines = gzip.decompress(path.read_bytes()).decode().splitlines(keepends=True)
    path.write_text("".join(lines[1:]))
    assert load_split(path).version == 1
    path.write_text(lines[0] + "".join(lines))
    with pytest.raises(DamagedFileError, match="version"):
        load_split(path)


def test_another_version_is_another_split() -> None:
    assert _split().digest != replace(_split(), version=4).digest
