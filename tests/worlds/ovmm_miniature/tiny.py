"""The smallest data in the challenge's layout: one room, a table, a chest, a cup, one episode that nobody certified."""

import math
from pathlib import Path

from worlds.ovmm_miniature.ktx2_pictures import Ktx2Pictures
from worlds.ovmm_miniature.miniature import Original, write_miniature
from worlds.own_home import made_home

from uniteam.geometry import BasePose
from uniteam.interface import Instruction
from uniteam.world.task.episode import Candidate, Episode

START = BasePose(2.5, 1.2, math.radians(70.0))


def tiny_original(folder: Path) -> Original:
    """Return a home, whose files are written into a folder, and its episode."""
    home = made_home(folder)
    episode = Episode(
        id="loft-0",
        home=home.name,
        start=START,
        instruction=Instruction("cup", "table", "chest_of_drawers"),
        objects=(Candidate("cup_1", ((3.4, 1.8), (4.4, 1.8))),),
        start_receptacles=("table_1",),
        goal_receptacles=(Candidate("chest_1", ((1.0, 4.9), (1.5, 4.9), (2.0, 4.9))),),
        unseen=False,
        seed=0,
    )
    return Original({home.name: home}, (episode,))


def write_tiny(folder: Path) -> Path:
    """Write the data below a folder, and return the folder of its episodes."""
    return write_miniature(tiny_original(folder / "original"), folder, Ktx2Pictures())
