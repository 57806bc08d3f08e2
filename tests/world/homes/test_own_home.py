"""A home that nobody here made: an L-shaped room, a mesh for a stage, models from a folder of glTF files."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from worlds.camera_scenes import looking
from worlds.own_home import HEIGHT, SLANT, TABLE_HEIGHT, made_home

from uniteam.geometry import BasePose, PinholeCamera, pose_matrix
from uniteam.interface import BaseDisplacement, DiscreteAction, Instruction
from uniteam.stretch import BASE_RADIUS, HEAD_CAMERA_HALF
from uniteam.world.homes.home import Home
from uniteam.world.homes.serialization import check_home, home_digest, read_home, write_home
from uniteam.world.physics.navigable_floor import NavigableFloor
from uniteam.world.physics.physics import Physics
from uniteam.world.rendering.camera import render
from uniteam.world.rendering.scene import Scene
from uniteam.world.simulation.graspable import TAKE_NOTHING
from uniteam.world.simulation.simulator import Simulator
from uniteam.world.task.environment import Environment
from uniteam.world.task.episode import Candidate, Episode, Split
from uniteam.world.task.splits import load_split, write_split

CAMERA = PinholeCamera.from_horizontal_fov(64, 48, np.radians(60.0))
DIAGONAL = np.pi / 4


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("own")


@pytest.fixture(scope="module")
def home(folder: Path) -> Home:
    return made_home(folder)


def own_episode() -> Episode:
    """Return an episode that begins before the cup on the table and ends at the chest."""
    return Episode(
        id="loft-0",
        home="loft",
        start=BasePose(3.8, 1.7, np.pi / 2),
        instruction=Instruction("cup", "table", "chest_of_drawers"),
        objects=(Candidate("cup_1", ((3.8, 1.7),)),),
        start_receptacles=("table_1",),
        goal_receptacles=(Candidate("chest_1", ((1.0, 4.8),)),),
        unseen=False,
        seed=1,
    )


def test_an_own_home_is_sound_and_comes_back_from_its_file(home: Home, folder: Path) -> None:
    check_home(home)
    write_home(home, folder / "loft.json")
    read = read_home(folder / "loft.json")
    assert read == home
    assert home_digest(read) == home_digest(home)


def test_the_floor_ends_at_the_outline_and_at_the_mesh(home: Home) -> None:
    floor = NavigableFloor(home)
    assert not floor.is_free(4.5, 4.5)  # the notch of the L
    assert floor.is_free(1.5, 1.5) and floor.is_free(4.5, 1.5)
    assert floor.clearance(1.5, 3.45) == pytest.approx(0.3, abs=0.02)  # from the round column
    assert floor.clearance(4.8, 1.2) == pytest.approx(1.0 / np.sqrt(2), abs=0.03)  # from the slanted wall
    row, column = floor.to_cell(5.7, 0.3)
    assert not floor.largest_component[row, column]  # nobody gets behind it


def test_the_base_stops_at_the_slanted_wall(home: Home) -> None:
    simulator = Simulator(home, HEAD_CAMERA_HALF)
    simulator.reset(BasePose(4.3, 1.7, -DIAGONAL))
    steps = 0
    while not simulator.apply(BaseDisplacement(x=0.1), TAKE_NOTHING).blocked:
        steps += 1
    gap = (SLANT[0][0] - simulator.base.x + simulator.base.y) / np.sqrt(2)
    assert steps > 3
    assert BASE_RADIUS - 0.03 < gap < BASE_RADIUS + 0.12


def test_a_thing_that_falls_on_the_mesh_touches_a_wall(home: Home) -> None:
    physics = Physics(home)
    physics.set_pose("cup_1", pose_matrix(np.array([5.31, 0.69, 1.0]), np.array([1.0, 0.0, 0.0, 0.0])))
    assert "wall" in physics.touching("cup_1")


def test_the_mesh_and_the_own_models_are_seen_where_they_are(home: Home) -> None:
    scene = Scene(home)
    wall = render(scene, CAMERA, looking((4.3, 1.7, 1.2), (5.3, 0.7, 1.2)))
    assert wall.depth[24, 32] == pytest.approx(np.sqrt(2), abs=1e-3)
    table = render(scene, CAMERA, looking((4.0, 1.2, 1.4), (4.0, 2.5, 0.6)))
    assert set(np.unique(table.instances)) >= {0, 2}


def test_no_ray_leaves_an_l_shaped_room(home: Home) -> None:
    scene = Scene(home)
    for eye in ((1.5, 1.5), (4.0, 1.0), (2.4, 5.4)):
        for turn in np.arange(0.0, 2.0 * np.pi, np.pi / 4.0):
            for tilt in (-0.7, 0.0, 0.7):
                pose = looking((*eye, 1.3), (eye[0] + np.cos(turn), eye[1] + np.sin(turn), 1.3 + tilt))
                assert render(scene, CAMERA, pose).depth.all()


def test_what_of_the_mesh_reaches_the_ceiling_is_hidden_with_it(home: Home) -> None:
    scene = Scene(home)
    pose = np.diag([1.0, -1.0, -1.0, 1.0])
    pose[:3, 3] = (3.0, 3.0, 9.0)
    scene.show("ceiling", False)
    assert render(scene, CAMERA, pose).depth[24, 10] > HEIGHT
    assert "stage" in scene.names


def test_an_episode_is_played_in_an_own_home(home: Home) -> None:
    environment = Environment(home, episode=own_episode())
    observation = environment.reset()
    assert observation.depth.any()
    environment.step(DiscreteAction.MANIPULATION_MODE)
    observation = environment.step(DiscreteAction.SNAP_OBJECT)
    assert observation.is_holding
    environment.step(DiscreteAction.DESNAP_OBJECT)
    environment.step(DiscreteAction.STOP)
    assert environment.is_over
    assert environment.measures.find_object_phase_success
    assert environment.measures.pick_object_phase_success


def test_a_split_of_an_own_home_is_opened_by_another_process_in_another_folder(home: Home, folder: Path) -> None:
    path = folder / "runs" / "loft.jsonl.gz"
    path.parent.mkdir()
    write_split(Split("loft", (own_episode(),), {home.name: home}), path)
    read = load_split(path)
    assert read.homes["loft"] == home
    code = (
        "import sys\nfrom uniteam.world.homes.serialization import home_digest\n"
        "from uniteam.world.task.splits import load_split\n"
        f"print(home_digest(load_split({str(path)!r}).homes['loft']))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd="/")
    assert done.stdout.strip() == home_digest(home)


def test_another_library_or_another_mesh_makes_another_home(home: Home, tmp_path: Path) -> None:
    changed = made_home(tmp_path)
    assert home_digest(changed) == home_digest(home)
    mesh = tmp_path / "stage.glb"
    mesh.write_bytes(mesh.read_bytes().replace(b"0.7, 0.6, 0.5", b"0.7, 0.6, 0.6"))
    assert home_digest(changed) != home_digest(home)
    assert replace(home, library=replace(home.library, models={})) != home


def test_a_cup_stays_on_its_own_table(home: Home) -> None:
    physics = Physics(home)
    assert physics.settle()
    assert physics.pose("cup_1")[2, 3] == pytest.approx(TABLE_HEIGHT, abs=0.002)
    assert physics.touching("cup_1") == {"table_1"}
