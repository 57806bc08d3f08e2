"""`uniteam assets`: what the pack of models holds, as a table and as contact sheets."""

from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from rich.table import Table

from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError, UnknownNameError
from uniteam.files import try_folder
from uniteam.world.assets.catalogue import Catalogue, load_catalogue, load_library
from uniteam.world.assets.model import Model

PER_SHEET = 48


def assets(
    category: str | None = None,
    sheet: Path | None = None,
    shapes: bool = False,
    counts: bool = False,
    library: Path | None = None,
) -> None:
    """List the models of a library and draw contact sheets of them.

    Without a category the table has a line a category, with one a line a model.

    Args:
        category: show only this class of furniture, object or decor.
        sheet: write contact sheets (PNG, 48 models each) into this folder.
        shapes: draw collision shapes and support surfaces on the sheets instead of the models' looks.
        counts: list how many models each class of objects and receptacles has to train and to test with.
        library: folder of a library of your own; the package's pack where none is given.
    """
    catalogue = load_catalogue() if library is None else load_library(library)
    models = _chosen(catalogue, category)
    if sheet is not None:
        try_folder(sheet)
    console = make_console()
    if counts:
        console.print(_count_table(models, catalogue))
    else:
        console.print(_category_table(models, catalogue) if category is None else _model_table(models))
    if sheet is not None:
        for path in write_sheets(models, sheet, shapes):
            console.print(f"wrote {shown(path)}", soft_wrap=True)


def write_sheets(models: Sequence[Model], folder: Path, shapes: bool) -> list[Path]:
    """Draw contact sheets of the models into a folder and return their paths; raises UnwritableError."""
    from uniteam.visualization.contact_sheet import draw_sheet
    from uniteam.visualization.picture_file import write_png

    paths = []
    for first in range(0, len(models), PER_SHEET):
        page = draw_sheet(models[first : first + PER_SHEET], shapes=shapes)
        paths.append(folder / f"sheet_{first // PER_SHEET:02d}.png")
        write_png(paths[-1], page)
    return paths


def _chosen(catalogue: Catalogue, category: str | None) -> list[Model]:
    models = sorted(catalogue.models.values(), key=lambda m: (m.role, m.category, m.id))
    if not models:
        raise InvalidInputError("the library holds no model")
    if category is None:
        return models
    found = [m for m in models if m.category == category]
    if not found:
        raise UnknownNameError("category", category, {m.category for m in models})
    return found


def _count_table(models: Sequence[Model], catalogue: Catalogue) -> Table:
    """Return a line a class that an episode may name, and a last one of sums."""
    numbers = Counter((m.role, m.category, m.pool) for m in models if m.role in ("object", "receptacle"))
    classes = sorted({(role, category) for role, category, _ in numbers})
    table = Table(title=f"{len(classes)} classes of objects and receptacles", show_footer=True)
    table.add_column("role", "all")
    table.add_column("class")
    for pool in ("train", "test"):
        table.add_column(pool, str(sum(n for key, n in numbers.items() if key[2] == pool)), justify="right")
    table.add_column("unseen in training")
    for role, category in classes:
        unseen = "yes" if role == "object" and category in catalogue.unseen_categories else ""
        table.add_row(
            role, shown(category), *(str(numbers[role, category, pool]) for pool in ("train", "test")), unseen
        )
    return table


def _category_table(models: Sequence[Model], catalogue: Catalogue) -> Table:
    table = Table(title=f"{len(models)} models")
    for heading in ("role", "category"):
        table.add_column(heading)
    for heading in ("models", "train", "test"):
        table.add_column(heading, justify="right")
    table.add_column("unseen in training")
    groups: dict[tuple[str, str], list[Model]] = {}
    for model in models:
        groups.setdefault((model.role, model.category), []).append(model)
    for (role, category), group in groups.items():
        train = sum(m.pool == "train" for m in group)
        unseen = "yes" if role == "object" and category in catalogue.unseen_categories else ""
        table.add_row(role, shown(category), str(len(group)), str(train), str(len(group) - train), unseen)
    return table


def _model_table(models: Sequence[Model]) -> Table:
    table = Table(title=f"{len(models)} models of {shown(models[0].category)}")
    table.add_column("id", no_wrap=True)
    for heading in ("size (cm)", "mass (kg)", "pool", "surfaces at (cm)"):
        table.add_column(heading)
    for m in models:
        size = "x".join(f"{100 * s:.0f}" for s in m.size)
        heights = " ".join(f"{100 * h:.0f}" for h in sorted({round(s.height, 2) for s in m.surfaces}))
        table.add_row(m.id, size, f"{m.mass:.3g}", m.pool, heights)
    return table
