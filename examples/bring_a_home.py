"""Bring a home of your own: an L-shaped loft with a slanted wall, furnished from a folder of glTF binaries.

uniteam home 7 --source bring_a_home:loft
uniteam episodes --homes 0:3 --per-home 1 --source bring_a_home:loft --out loft.jsonl.gz
"""

from itertools import pairwise
from pathlib import Path

import numpy as np

from uniteam.world.assets.catalogue import load_library
from uniteam.world.homes.home import Home, Instance, Light, Room, Stage, Wall

FILES = Path(__file__).parent / "loft"
OUTLINE = ((0.0, 0.0), (6.0, 0.0), (6.0, 3.0), (3.0, 3.0), (3.0, 6.0), (0.0, 6.0))
UPRIGHT = (1.0, 0.0, 0.0, 0.0)


def loft(seed: int) -> Home:
    """Return the loft of a seed: its mug stands somewhere else on the table."""
    library = load_library(FILES)  # catalogue.json and models/*.glb, added to the models of the package
    light = Light((2.0, 2.0, 2.3), (1.0, 0.97, 0.93), 0.45)
    room = Room("loft", "living_room", OUTLINE, "planks_oak", "plaster_white", (0.95, 0.93, 0.88), light)
    walls = tuple(Wall(start, end, 0.1) for start, end in pairwise((*OUTLINE, OUTLINE[0])))
    dx, dy = np.random.default_rng(seed).uniform((-0.4, -0.25), (0.4, -0.05)).round(3)
    standing = {
        "table_1": ("plank_table", (4.0, 2.5, 0.0)),
        "couch_1": ("couch_et_sofa", (1.5, 5.4, 0.0)),
        "mug_1": ("tin_mug", (4.0 + dx, 2.5 + dy, 0.735)),
    }
    instances = tuple(
        Instance(name, model, library[model].category, library[model].role == "object", position, UPRIGHT, "loft")
        for name, (model, position) in standing.items()
    )
    return Home(f"loft-{seed}", Stage((room,), walls, 2.6, FILES / "slanted_wall.glb"), instances, library, seed)
