"""`uniteam home`: generate a home, draw it and list what is in it."""

from collections import Counter
from pathlib import Path
from typing import Annotated, Literal

import cv2
import numpy as np
import tyro
from numpy.typing import NDArray
from rich.console import Console
from rich.table import Table

from uniteam.visualization.home_pictures import draw_plan, view_from_above, views_inside
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES
from uniteam.world.generation.generate import generate_home
from uniteam.world.homes.home import Home, Instance


def home(
    seed: Annotated[int, tyro.conf.Positional],
    pool: Literal["train", "test"] = "test",
    out: Path | None = None,
) -> None:
    """Generate the home of a seed, draw it and list what is in it.

    Args:
        seed: which home.
        pool: "train" for the models of training homes, "test" for those kept from them.
        out: directory for plan.png, above.png and a picture inside each room; "home_SEED" where none is given.
    """
    generated = generate_home(seed, pool)
    directory = Path(f"home_{seed}") if out is None else out
    directory.mkdir(parents=True, exist_ok=True)
    _save(directory / "plan.png", draw_plan(generated))
    _save(directory / "above.png", view_from_above(generated))
    for name, image in views_inside(generated):
        _save(directory / f"{name}.png", image)
    console = Console()
    console.print(_table(generated))
    console.print(f"pictures in {directory}", highlight=False)


def _save(path: Path, image: NDArray[np.uint8]) -> None:
    cv2.imwrite(str(path), image[..., ::-1])


def _table(generated: Home) -> Table:
    area = sum(room.area for room in generated.stage.rooms)
    table = Table(title=f"home {generated.name}: {len(generated.stage.rooms)} rooms, {area:.0f} m2", show_lines=True)
    for heading in ("room", "m2", "receptacles", "decor", "objects"):
        table.add_column(heading, overflow="fold")
    for room in generated.stage.rooms:
        inside = [instance for instance in generated.instances if instance.room == room.name]
        receptacles = [i for i in inside if i.category in RECEPTACLE_CATEGORIES and not i.movable]
        decor = [i for i in inside if i.category not in RECEPTACLE_CATEGORIES and not i.movable]
        objects = [i for i in inside if i.movable]
        table.add_row(room.name, f"{room.area:.1f}", _counted(receptacles), _counted(decor), _counted(objects))
    return table


def _counted(instances: list[Instance]) -> str:
    counts = Counter(instance.category.replace("_", " ") for instance in instances)
    return ", ".join(name if number == 1 else f"{number} {name}" for name, number in sorted(counts.items()))
