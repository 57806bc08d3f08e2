"""`uniteam home`: draw a home, of a seed or of a file, and list what is in it."""

from collections import Counter
from pathlib import Path
from typing import Annotated, Literal

import tyro
from rich.table import Table

from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.files import try_folder
from uniteam.visualization.home_pictures import draw_plan, view_from_above, views_inside
from uniteam.visualization.picture_file import write_png
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES
from uniteam.world.generation.registry import home_of_seed, source_name
from uniteam.world.homes.home import Home, Instance
from uniteam.world.homes.serialization import read_home

Style = Literal["tidy", "lived_in"]


def home(
    what: Annotated[str, tyro.conf.Positional], source: str = "test", style: Style = "tidy", out: Path | None = None
) -> None:
    """Draw a home and list what is in it.

    Args:
        what: seed of the home to generate, or a home's own file (JSON).
        source: what makes the home of a seed: "test" for models kept from training, "train" for the others, or a
            function of your own, "my_homes:lofts".
        style: "tidy" homes as a robot would like them, or "lived_in" ones as people leave them; not for a function of
            your own.
        out: directory for plan.png, above.png and a picture inside each room; "home_SEED" or "home_FILE" where none is
            given.
    """
    seed = _seed(what)
    drawn = home_of_seed(source_name(source, style), seed) if seed is not None else read_home(_file(what))
    directory = Path(f"home_{Path(what).stem}") if out is None else out
    try_folder(directory)
    write_png(directory / "plan.png", draw_plan(drawn))
    write_png(directory / "above.png", view_from_above(drawn))
    for name, image in views_inside(drawn):
        write_png(directory / f"{name}.png", image)
    console = make_console()
    console.print(_table(drawn))
    console.print(f"pictures in {shown(directory)}", soft_wrap=True)


def _seed(what: str) -> int | None:
    """Return the seed that was given, or None where a file was."""
    try:
        return int(what)
    except ValueError:
        return None


def _file(what: str) -> Path:
    path = Path(what)
    try:
        is_file = path.is_file()
    except (OSError, ValueError):  # no name that a file can have
        is_file = False
    if not is_file:
        raise InvalidInputError(f"'{what[:100]}' is neither a seed (a whole number) nor the file of a home")
    return path


def _table(drawn: Home) -> Table:
    area = sum(room.area for room in drawn.stage.rooms)
    title = f"home {shown(drawn.name)}: {len(drawn.stage.rooms)} rooms, {area:.0f} m2"
    table = Table(title=title, show_lines=True)
    for heading in ("room", "m2", "receptacles", "decor", "objects"):
        table.add_column(heading, overflow="fold")
    for room in drawn.stage.rooms:
        inside = [instance for instance in drawn.instances if instance.room == room.name]
        receptacles = [i for i in inside if i.category in RECEPTACLE_CATEGORIES and not i.movable]
        decor = [i for i in inside if i.category not in RECEPTACLE_CATEGORIES and not i.movable]
        objects = [i for i in inside if i.movable]
        columns = (_counted(receptacles), _counted(decor), _counted(objects))
        table.add_row(shown(room.name), f"{room.area:.1f}", *columns)
    return table


def _counted(instances: list[Instance]) -> str:
    counts = Counter(instance.category.replace("_", " ") for instance in instances)
    return shown(", ".join(name if number == 1 else f"{number} {name}" for name, number in sorted(counts.items())))
