"""The challenge's layout read from the smallest data there is, and what is said where something of it is wrong."""

import gzip
import json
import math
import shutil
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

pytest.importorskip("alktx2", reason="the encoder has wheels for Linux only")

from worlds.ovmm_miniature.tiny import START, write_tiny

from uniteam.errors import DamagedFileError
from uniteam.world.homes.readers.hssd_scene import read_hssd_home
from uniteam.world.task.environment import Environment
from uniteam.world.task.ovmm.data_check import check_episodes, episode_folders
from uniteam.world.task.splits import load_split, split_files, split_label


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder that holds `data/`, whole."""
    folder = tmp_path_factory.mktemp("tiny")
    write_tiny(folder)
    return folder


@pytest.fixture
def copied(whole: Path, tmp_path: Path) -> Path:
    """Return a copy of the folder of episodes, to be spoilt with the data around it."""
    shutil.copytree(whole / "data", tmp_path / "data")
    return tmp_path / "data" / "datasets" / "ovmm" / "minival"


def episodes_of(whole: Path) -> Path:
    """Return the folder of episodes."""
    return whole / "data" / "datasets" / "ovmm" / "minival"


def change(folder: Path, how: Callable[[dict[str, Any]], None]) -> None:
    """Change the one episode of a folder."""
    content = json.loads(gzip.decompress((folder / "episodes.json.gz").read_bytes()))
    how(content["episodes"][0])
    (folder / "episodes.json.gz").write_bytes(gzip.compress(json.dumps(content).encode()))


def put(field: str, value: object, episode: dict[str, Any]) -> None:
    """Set a field of an episode."""
    episode[field] = value


def test_the_episode_is_what_it_was_made_of(whole: Path) -> None:
    split = load_split(f"ovmm:{episodes_of(whole)}")
    (episode,) = split.episodes
    assert (split.name, episode.id) == ("ovmm-minival", "loft_0")
    assert (episode.start.x, episode.start.y, episode.start.heading) == pytest.approx((START.x, START.y, START.heading))
    assert str(episode.instruction) == "Move cup from table to chest of drawers"
    assert episode.objects[0].view_points == ((3.4, 1.8), (4.4, 1.8))
    assert sorted(episode.goal_receptacles[0].view_points) == [(1.0, 4.9), (1.5, 4.9), (2.0, 4.9)]
    home = split.homes[episode.home]
    assert home.by_name[episode.start_receptacles[0]].category == "table"
    assert home.by_name[episode.objects[0].name].position == pytest.approx((3.8, 2.4, 0.701), abs=1e-5)
    Environment(home, episode).reset()


def test_the_other_reading_of_a_start_mirrors_its_heading(whole: Path) -> None:
    (episode,) = load_split(f"ovmm-as-written:{episodes_of(whole)}").episodes
    assert episode.start.heading == pytest.approx(-START.heading)
    assert split_label(f"ovmm-as-written:{episodes_of(whole)}") == "ovmm-as-written-minival"


def test_matrices_and_view_points_may_stand_in_the_episode_itself(copied: Path) -> None:
    before = load_split(f"ovmm:{copied}")
    poses, points = np.load(copied / "transformations.npy"), np.load(copied / "viewpoints.npy")

    def inline(episode: dict[str, Any]) -> None:
        episode["rigid_objs"] = [[name, [*poses[row].tolist(), [0, 0, 0, 1]]] for name, row in episode["rigid_objs"]]
        for goal in (*episode["candidate_objects"], *episode["candidate_goal_receps"]):
            goal["view_points"] = [
                {"agent_state": {"position": points[k, :3].tolist(), "rotation": points[k, 3:7].tolist()}, "iou": 0.1}
                for k in goal["view_points"]
            ]

    change(copied, inline)
    for name in ("transformations.npy", "viewpoints.npy"):
        (copied / name).unlink()
    after = load_split(f"ovmm:{copied}")
    assert after.episodes == before.episodes
    assert [home.instances for home in after.homes.values()] == [home.instances for home in before.homes.values()]
    assert [path.name for path in split_files(f"ovmm:{copied}")] == ["episodes.json.gz"]


def test_a_scene_by_itself_is_a_home_without_small_objects(whole: Path) -> None:
    home = read_hssd_home(whole / "data/hssd-hab/scenes-uncluttered/loft.scene_instance.json")
    assert [instance.category for instance in home.instances] == ["table", "chest_of_drawers"]
    assert home.library.models.keys() == {instance.model for instance in home.instances}
    assert [room.kind for room in home.stage.rooms] == ["living_room", "hall"]


def test_furniture_that_lies_on_its_side_is_read_with_its_tilt_in_the_model(copied: Path) -> None:
    scene = copied.parents[2] / "hssd-hab/scenes-uncluttered/loft.scene_instance.json"
    content = json.loads(scene.read_text())
    upright = read_hssd_home(scene).instances[0]
    content["object_instances"][0]["rotation"] = [math.sqrt(0.5), math.sqrt(0.5), 0.0, 0.0]
    content["object_instances"][0]["translation"] = [3.0, 0.5, -2.0]
    scene.write_text(json.dumps(content))
    home = read_hssd_home(scene)
    width, depth, height = read_hssd_home(scene).model_of(home.instances[0]).size
    assert home.instances[0].quaternion == pytest.approx((1.0, 0.0, 0.0, 0.0))
    assert (width, depth, height) == pytest.approx((1.0, 0.7, 0.7), abs=1e-4)
    assert home.instances[0].model != upright.model


FAULTS: dict[str, tuple[Callable[[Path], None], str]] = {
    "no episodes": (lambda d: (d / "episodes.json.gz").unlink(), "there is no such file"),
    "not gzip": (lambda d: _write(d / "episodes.json.gz", b"{}"), "Not a gzipped file"),
    "cut": (lambda d: _write(d / "episodes.json.gz", (d / "episodes.json.gz").read_bytes()[:300]), "end-of-stream"),
    "another field": (lambda d: change(d, partial(put, "scene_id", 3)), "episodes[0].scene_id"),
    "no scene": (lambda d: shutil.rmtree(d.parents[2] / "hssd-hab"), "no folder above holds"),
    "no scene file": (lambda d: shutil.rmtree(d.parents[2] / "hssd-hab/scenes-uncluttered"), "there is no such file"),
    "no models": (lambda d: shutil.rmtree(d.parents[2] / "hssd-hab/objects"), "there is no such file among"),
    "no objects": (lambda d: shutil.rmtree(d.parents[2] / "objects/train_val"), "there is no such file among"),
    "a pointer": (lambda d: _write(_stage(d), b"version https://git-lfs.github.com/spec/v1\noid"), "git lfs pull"),
    "not an array": (lambda d: _write(d / "viewpoints.npy", b"no array"), "viewpoints.npy"),
    "another array": (lambda d: np.save(d / "transformations.npy", np.zeros((3, 4))), "rows of 3 x 4"),
    "few rows": (lambda d: np.save(d / "transformations.npy", np.zeros((0, 3, 4))), "row 0 of transformations.npy"),
    "few views": (lambda d: np.save(d / "viewpoints.npy", np.zeros((0, 8))), "row 0 of viewpoints.npy"),
    "no start": (lambda d: change(d, partial(put, "start_position", [0, 0, 0])), "no start of its own"),
    "a start outside": (lambda d: change(d, partial(put, "start_position", [40, 0, 9])), "outside every room"),
    "no such object": (lambda d: change(d, lambda e: put("object_id", "9", e["candidate_objects"][0])), "no index"),
}


def _write(path: Path, content: bytes) -> None:
    path.write_bytes(content)


def _stage(episodes: Path) -> Path:
    return episodes.parents[2] / "hssd-hab/stages/loft.glb"


@pytest.mark.parametrize("fault", FAULTS)
def test_a_fault_is_told_in_a_sentence_by_the_split_and_by_the_check(copied: Path, fault: str) -> None:
    spoil, told = FAULTS[fault]
    spoil(copied)
    with pytest.raises(DamagedFileError) as caught:
        load_split(f"ovmm:{copied}")
    assert told in str(caught.value)
    fatal = [finding for finding in check_episodes(copied) if finding.is_fatal]
    assert fatal


def test_one_odd_episode_among_sound_ones_is_left_out_and_said(copied: Path, caplog: pytest.LogCaptureFixture) -> None:
    content = json.loads(gzip.decompress((copied / "episodes.json.gz").read_bytes()))
    odd = {**content["episodes"][0], "episode_id": "1", "goal_recep_category": "table"}
    content["episodes"].append(odd)
    (copied / "episodes.json.gz").write_bytes(gzip.compress(json.dumps(content).encode()))
    split = load_split(f"ovmm:{copied}")
    assert [episode.id for episode in split.episodes] == ["loft_0"]
    assert "1 of 2 episodes" in caplog.text and "loft_1" in caplog.text


def test_the_check_of_sound_data_says_what_is_there_and_what_it_costs(whole: Path) -> None:
    assert episode_folders(whole) == [episodes_of(whole)]
    findings = list(check_episodes(episodes_of(whole)))
    assert not [finding for finding in findings if finding.is_fatal]
    told = {kind: " ".join(f.sentence for f in findings if f.kind == kind) for kind in ("there", "missing", "cost")}
    assert "1 episodes in 1 scenes, with 5 view points and 1 poses" in told["there"]
    assert told["missing"] == ""
    assert "MB for the largest home, loft-0" in told["cost"]


def test_the_check_says_where_a_start_is_blocked(copied: Path) -> None:
    change(copied, partial(put, "start_position", [4.0, 0.0, -2.5]))
    told = [finding.sentence for finding in check_episodes(copied) if finding.kind == "odd"]
    assert any("start in something; the first is loft_0" in sentence for sentence in told)
