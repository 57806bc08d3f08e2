"""Views of a home: what the camera sees at both sizes, with the truth of every pixel."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from uniteam.stretch import HEAD_CAMERA_FULL, HEAD_CAMERA_HALF, head_camera_to_base
from uniteam.training.stands import Stand, Stands
from uniteam.world.assets.catalogue import Catalogue
from uniteam.world.generation.generate import generate_home
from uniteam.world.generation.style import STYLES
from uniteam.world.homes.home import Home
from uniteam.world.rendering.camera import render
from uniteam.world.rendering.kernels.frame import Frame
from uniteam.world.rendering.meshes.robot_mesh import part_poses, robot_parts
from uniteam.world.rendering.scene import MeshOf, Scene, mesh_of_model

FIRST_SEED = 1_000_000
"""Of training homes; far from those of the splits."""


@dataclass(frozen=True)
class View:
    """What the robot sees from one stand.

    Attributes:
        half: what `HEAD_CAMERA_HALF` sees; its instances are indices into the home's, -1 for anything else.
        fine: what `HEAD_CAMERA_FULL` sees from the same place.
        camera_to_start: (4, 4), with z = 0 at the floor.
    """

    half: Frame
    fine: Frame
    camera_to_start: NDArray[np.float64]


def training_home(number: int, library: Catalogue | None = None) -> Home:
    """Return the training home of a number, of the models of a library or of the pack; every third is lived in."""
    style = STYLES["lived_in" if number % 3 == 2 else "tidy"]
    return generate_home(FIRST_SEED + number, "train", style, library)


def views_of(
    home: Home,
    count: int,
    rng: Generator,
    most_tilt: float = 1.5,
    most_rise: float = 0.06,
    mesh_of: MeshOf = mesh_of_model,
) -> Iterator[View]:
    """Yield views of a home.

    Args:
        home: any.
        count: how many.
        rng: for where the camera stands.
        most_tilt: by how much (degrees) the camera is rolled.
        most_rise: by how much (m) it is higher or lower than on the robot.
        mesh_of: what is shown for an instance.
    """
    scene, stands = Scene(home, robot_parts(), mesh_of), Stands(home, rng)
    for _ in range(count):
        yield _view(
            scene, stands.draw(), math.radians(rng.uniform(-most_tilt, most_tilt)), rng.uniform(-1, 1) * most_rise
        )


def _view(scene: Scene, stand: Stand, roll: float, rise: float) -> View:
    for name, pose in part_poses(stand.base, stand.joints).items():
        scene.move(name, pose)
    to_world = stand.base.matrix() @ head_camera_to_base(stand.joints) @ _rolled(roll)
    to_world[2, 3] += rise
    half, fine = (render(scene, camera, to_world) for camera in (HEAD_CAMERA_HALF, HEAD_CAMERA_FULL))
    return View(half, fine, to_world)


def _rolled(angle: float) -> NDArray[np.float64]:
    turn = np.eye(4)
    turn[:2, :2] = (math.cos(angle), -math.sin(angle)), (math.sin(angle), math.cos(angle))
    return turn
