"""Bring a task of your own: episodes made by hand, in the loft of bring_a_home.py.

python bring_a_task.py
uniteam evaluate --agents baseline uniteam-plus --split tidy_loft.jsonl.gz
"""

from pathlib import Path

from bring_a_home import loft

from uniteam import BasePose, Home, Instruction
from uniteam.world.task.episode import Candidate, Episode, Split
from uniteam.world.task.lattice import lattice_points_near
from uniteam.world.task.splits import write_split


def candidate(home: Home, name: str, reach: float) -> Candidate:
    """Return an instance that counts; it is found from points of the floor up to `reach` (m) from its middle."""
    x, y, _ = home.by_name[name].position
    return Candidate(name, tuple((float(px), float(py)) for px, py in lattice_points_near(x, y, reach, reach)))


def episode(home: Home) -> Episode:
    """Return the task of a home: bring the mug from the table to the couch."""
    return Episode(
        id=f"{home.name}-mug",
        home=home.name,
        start=BasePose(1.0, 1.0, 0.0),
        instruction=Instruction("cup", "table", "couch"),
        objects=(candidate(home, "mug_1", reach=1.0),),
        start_receptacles=("table_1",),
        goal_receptacles=(candidate(home, "couch_1", reach=2.5),),
        unseen=False,
        seed=home.seed or 0,
    )


if __name__ == "__main__":
    homes = [loft(seed) for seed in range(3)]
    write_split(
        Split("tidy_loft", tuple(episode(home) for home in homes), {home.name: home for home in homes}),
        Path("tidy_loft.jsonl.gz"),
    )
