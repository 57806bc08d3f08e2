"""`uniteam home`: draw a home, of a seed or of a file, and list what is in it."""

from collections import Counter
from pathlib import Path
from typing import Annotated, Literal

import tyro
from rich.table import Table

from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.files import try_folder, try_output
from uniteam.visualization.home_pictures import draw_plan, view_from_above, views_inside
from uniteam.visualization.picture_file import write_png
from uniteam.world.assets.model import RECEPTACLE_CATEGORIES
from uniteam.world.export.glb import write_glb
from uniteam.world.export.mjcf import FILE as MJCF_FILE
from uniteam.world.export.mjcf import write_mjcf
from uniteam.world.generation.registry import home_of_seed, source_name
from uniteam.world.homes.home import Home, Instance
from uniteam.world.homes.serialization import read_home
from uniteam.world.physics.passages import Passages, survey

Style = Literal["tidy", "lived_in"]


def home(
    what: Annotated[str, tyro.conf.Positional],
    source: str = "test",
    style: Style = "tidy",
    out: Path | None = None,
    mjcf: Annotated[Path | None, tyro.conf.arg(metavar="DIR")] = None,
    glb: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None,
) -> None:
    """Draw a home, list what is in it and how a base gets about there, and write it for other programs.

    Args:
        what: seed of the home to generate, or a home's own file (JSON).
        source: what makes the home of a seed: "test" for models kept from training, "train" for the others, a
            function of your own, "my_homes:lofts", or the houses of a file of ProcTHOR, "procthor:val.jsonl.gz", of
            which the seed is the number.
        style: "tidy" homes as a robot would like them, or "lived_in" ones as people leave them; not for a function of
            your own.
        out: directory for plan.png, above.png and a picture inside each room; "home_SEED" or "home_FILE" where none is
            given.
        mjcf: directory for a MuJoCo model of the home, home.xml with its meshes and textures.
        glb: file (.glb) for the home in one glTF binary.
    """
    seed = _seed(what)
    drawn = home_of_seed(source_name(source, style), seed) if seed is not None else read_home(_file(what))
    directory = Path(f"home_{Path(what).stem}") if out is None else out
    if glb is not None:
        try_output(glb, (".glb",))
    for folder in (directory, mjcf):
        if folder is not None:
            try_folder(folder)
    write_png(directory / "plan.png", draw_plan(drawn))
    write_png(directory / "above.png", view_from_above(drawn))
    for name, image in views_inside(drawn):
        write_png(directory / f"{name}.png", image)
    console = make_console()
    passages = survey(drawn)
    console.print(_table(drawn, passages))
    console.print(_narrowest(passages), soft_wrap=True)
    console.print(f"pictures in {shown(directory)}", soft_wrap=True)
    if mjcf is not None:
        write_mjcf(drawn, mjcf)
        console.print(f"MuJoCo model: {shown(mjcf / MJCF_FILE)}", soft_wrap=True)
    if glb is not None:
        write_glb(drawn, glb)
        console.print(f"glTF binary: {shown(glb)}", soft_wrap=True)


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


def _narrowest(passages: Passages) -> str:
    """Return what a base of 0.3 m radius finds on its ways."""
    words = ["no way between rooms lets the base through"]
    if passages.narrowest is not None:
        room, width = passages.narrowest
        words = [f"narrowest passage that the base takes: {width:.2f} m, into {shown(room)}"]
    if passages.shut:
        words.append(f"it does not get into {shown(', '.join(passages.shut))}")
    beyond = [name for name, reached in passages.reached.items() if not reached]
    count = len(passages.reached)
    words.append(f"it reaches {count - len(beyond)} of {count} receptacles" + (" (not *)" if beyond else ""))
    return "; ".join(words)


def _table(drawn: Home, passages: Passages) -> Table:
    area = sum(room.area for room in drawn.stage.rooms)
    title = f"home {shown(drawn.name)}: {len(drawn.stage.rooms)} rooms, {area:.0f} m2"
    table = Table(title=title, show_lines=True)
    for heading in ("room", "m2", "way in", "receptacles", "decor", "objects"):
        table.add_column(heading, overflow="fold")
    for room in drawn.stage.rooms:
        inside = [instance for instance in drawn.instances if instance.room == room.name]
        receptacles = [i for i in inside if i.category in RECEPTACLE_CATEGORIES and not i.movable]
        decor = [i for i in inside if i.category not in RECEPTACLE_CATEGORIES and not i.movable]
        objects = [i for i in inside if i.movable]
        columns = (_counted(receptacles, passages), _counted(decor, passages), _counted(objects, passages))
        width = passages.widths.get(room.name)
        table.add_row(shown(room.name), f"{room.area:.1f}", "" if width is None else f"{width:.2f} m", *columns)
    return table


def _counted(instances: list[Instance], passages: Passages) -> str:
    """Return the instances by kind; a receptacle that the base does not get to is marked with a star."""
    kinds = (i.category.replace("_", " ") + ("" if passages.reached.get(i.name, True) else "*") for i in instances)
    counts = Counter(kinds)
    return shown(", ".join(name if number == 1 else f"{number} {name}" for name, number in sorted(counts.items())))
