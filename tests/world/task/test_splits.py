"""Splits as files, and the lattice their view points lie on."""

import gzip
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from uniteam.errors import DamagedFileError, UnknownNameError
from uniteam.geometry import BasePose
from uniteam.interface import Instruction, Joints
from uniteam.world.assets.catalogue import load_catalogue
from uniteam.world.homes.home import Home, Instance, Light, Room, Stage
from uniteam.world.homes.polygon import rectangle
from uniteam.world.task.episode import Candidate, Certificate, Episode, Split
from uniteam.world.task.lattice import lattice_points_near, points_to_runs, runs_to_points
from uniteam.world.task.splits import load_split, write_split

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
    category = load_catalogue().object_categories[0]
    release = Joints(lift=0.9, arm=0.3, wrist_pitch=-1.5, head_pan=-1.57, head_tilt=-0.8)
    return Episode(
        id=identifier,
        home=home,
        start=BasePose(1.25, 2.5, -1.0 / 3.0),
        instruction=Instruction(category, "table", "sink"),
        objects=(Candidate("cup_1", ((0.1, -0.2), (0.2, -0.2), (-0.1, 0.3))),),
        start_receptacles=("table_1",),
        goal_receptacles=(Candidate("sink_1", ((2.0, 2.0),)), Candidate("sink_2", ())),
        unseen=True,
        seed=11,
        certificate=Certificate("cup_1", BasePose(0.1, 0.2, 0.3), "sink_1", BasePose(1.0, 2.0, 3.0), release),
    )


def _split() -> Split:
    homes = {name: _home(name) for name in ("home_1", "home_2")}
    episodes = (_episode("0", "home_1"), _episode("1", "home_1"), _episode("2", "home_2"))
    return Split("mine", episodes, homes)


def _viewable(episode: Episode) -> list[tuple[str, list[tuple[float, float]]]]:
    return [(c.name, sorted(c.view_points)) for c in (*episode.objects, *episode.goal_receptacles)]


def test_a_split_comes_back_from_its_file_as_it_was_written(tmp_path: Path) -> None:
    split = _split()
    path = tmp_path / "mine.jsonl.gz"
    write_split(split, path)
    read = load_split(str(path))
    assert read.name == "mine"
    assert dict(read.homes) == split.homes
    for got, expected in zip(read.episodes, split.episodes, strict=True):
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
    with pytest.raises(UnknownNameError, match="category 'tabel'"):
        load_split(path)


def test_an_episode_about_what_its_home_does_not_hold_is_damaged(tmp_path: Path) -> None:
    path = tmp_path / "strange.jsonl"
    homes = {name: replace(home, instances=home.instances[1:]) for name, home in _split().homes.items()}
    write_split(replace(_split(), homes=homes), path)
    with pytest.raises(DamagedFileError, match="'table_1', which its home does not hold"):
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
