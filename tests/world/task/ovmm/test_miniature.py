"""Two homes of the pack as the challenge's data: what is read of them against what our generator made."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("alktx2", reason="the encoder has wheels for Linux only")

from worlds.filled import filled
from worlds.ovmm_miniature.ktx2_pictures import Ktx2Pictures
from worlds.ovmm_miniature.miniature import Original, original, write_miniature
from worlds.ovmm_miniature.reference import (
    lit_alike,
    models_with_coded_textures,
    with_coded_textures,
    with_its_stage_as_a_mesh,
)
from worlds.ovmm_miniature.scene_files import handles

from uniteam.geometry import BasePose
from uniteam.stretch import HEAD_CAMERA_HALF, NAVIGATION_POSTURE, head_camera_to_base
from uniteam.world.homes.home import Home
from uniteam.world.oracle.oracle import Oracle
from uniteam.world.physics.navigable_floor import NavigableFloor
from uniteam.world.rendering.camera import render
from uniteam.world.rendering.kernels.frame import Frame
from uniteam.world.rendering.scene import Scene
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Episode, Split
from uniteam.world.task.splits import load_split

pytestmark = pytest.mark.slow

VIEWS_A_GOAL = 2


@dataclass(frozen=True)
class Miniature:
    """What was made, of what, and with which pictures."""

    made_of: Original
    split: Split
    coded: Ktx2Pictures
    folder: Path

    def pairs(self) -> Iterator[tuple[Episode, Episode, Home, Home]]:
        """Yield each episode as it was and as it is read, with its homes."""
        for was, read in zip(self.made_of.episodes, self.split.episodes, strict=True):
            yield was, read, self.made_of.homes[was.home], self.split.homes[read.home]


@pytest.fixture(scope="module")
def miniature(tmp_path_factory: pytest.TempPathFactory) -> Miniature:
    """Write the miniature and read it."""
    folder, made_of, coded = tmp_path_factory.mktemp("miniature"), original(), Ktx2Pictures()
    return Miniature(made_of, load_split(f"ovmm:{write_miniature(made_of, folder, coded)}"), coded, folder)


def test_everything_stands_where_it_stood(miniature: Miniature) -> None:
    for _, _, was, read in filled(list(miniature.pairs())):
        names = handles(was)
        assert {i.name for i in read.instances} == set(names.values())
        for instance in filled(was.instances):
            found = read.by_name[names[instance.name]]
            assert found.movable == instance.movable
            assert found.position == pytest.approx(instance.position, abs=0.02)
            if not instance.movable:
                assert found.category == instance.category


def test_episodes_ask_the_same_from_the_same_start(miniature: Miniature) -> None:
    for was, read, home, _ in filled(list(miniature.pairs())):
        names = handles(home)
        assert (read.instruction, read.start.x, read.start.y) == (was.instruction, was.start.x, was.start.y)
        assert read.start.heading == pytest.approx(was.start.heading)
        assert {names[c.name]: set(c.view_points) for c in (*was.objects, *was.goal_receptacles)} == {
            c.name: set(c.view_points) for c in (*read.objects, *read.goal_receptacles)
        }
        assert set(read.start_receptacles) <= {names[name] for name in was.start_receptacles}


def test_the_robot_can_drive_where_it_could(miniature: Miniature) -> None:
    for _, _, was, read in filled(list(miniature.pairs())):
        before, after = NavigableFloor(was), NavigableFloor(read)
        assert not (after.largest_component & ~before.largest_component).any()
        assert after.largest_component.sum() > 0.97 * before.largest_component.sum()


def views(episode: Episode, home: Home) -> Iterator[BasePose]:
    """Yield the start, and poses at view points of the candidates that face them."""
    yield episode.start
    for candidate in (*episode.objects, *episode.goal_receptacles):
        x, y, _ = home.by_name[candidate.name].position
        points = candidate.view_points
        for px, py in points[:: max(1, len(points) // VIEWS_A_GOAL)]:
            yield BasePose(px, py, float(np.arctan2(y - py, x - px)))


def seen(scene: Scene, pose: BasePose) -> Frame:
    """Return what the head camera sees."""
    return render(scene, HEAD_CAMERA_HALF, pose.matrix() @ head_camera_to_base(NAVIGATION_POSTURE))


def alike(one: Frame, other: Frame) -> float:
    """Return the share of pixels that differ by one grey level at most."""
    return float((np.abs(one.rgb.astype(int) - other.rgb).max(axis=2) <= 1).mean())


@dataclass(frozen=True)
class Scenes:
    """What is seen of one home: as it is read, and as our generator made it, with its walls and with them as a mesh."""

    read: Scene
    walls: Scene
    mesh: Scene


def scenes_of(miniature: Miniature, home: Home, read: Home) -> Scenes:
    """Return the scenes of a home."""
    lit, shown = lit_alike(home), models_with_coded_textures(miniature.coded)
    walls = with_coded_textures(lit, miniature.folder, miniature.coded)
    mesh = with_its_stage_as_a_mesh(lit, miniature.folder, miniature.coded)
    return Scenes(Scene(read), Scene(walls, mesh_of=shown), Scene(mesh, mesh_of=shown))


def test_the_camera_sees_what_it_saw_in_our_generators_home(miniature: Miniature) -> None:
    scenes: dict[str, Scenes] = {}
    shares, with_walls = [], []
    for was, _, home, read in filled(list(miniature.pairs())):
        if home.name not in scenes:
            scenes[home.name] = scenes_of(miniature, home, read)
        here = scenes[home.name]
        order = list(handles(home).values())
        of_read = np.array([*(order.index(instance.name) for instance in read.instances), -1])
        for pose in filled(list(views(was, home))):
            got, wanted, straight = (seen(scene, pose) for scene in (here.read, here.mesh, here.walls))
            assert np.quantile(np.abs(got.depth - straight.depth), 0.999) < 1e-3
            assert (of_read[got.instances] == straight.instances).mean() > 0.999
            shares.append(alike(got, wanted))
            with_walls.append(alike(got, straight))
    assert min(shares) >= 0.99
    assert np.mean(with_walls) > 0.85  # boards and door frames of straight walls are lit at other points than a mesh's


def test_an_episode_is_solved_as_its_certificate_says(miniature: Miniature) -> None:
    was, read, home, there = next(miniature.pairs())
    names = handles(home)
    assert was.certificate is not None
    certificate = replace(
        was.certificate, object=names[was.certificate.object], receptacle=names[was.certificate.receptacle]
    )
    environment = Environment(there, replace(read, certificate=certificate))
    observation = environment.reset()
    oracle = Oracle(environment)
    oracle.reset(read.instruction, read.seed)
    while not environment.is_over:
        observation = environment.step(oracle.act(observation).action)
    assert environment.measures.overall_success
