"""`uniteam figures`: the figures of the UniTeam report, from runs of our agents."""

from pathlib import Path
from typing import Literal

from uniteam.cli.progress import counting
from uniteam.cli.terminal import make_console, shown
from uniteam.errors import InvalidInputError
from uniteam.files import try_folder
from uniteam.visualization.figures.drawing import write_figure

Name = Literal["search-panel", "floor-as-table", "goal-map"]


def figures(
    out: Path = Path("figures"), only: tuple[Name, ...] = ("search-panel", "floor-as-table", "goal-map")
) -> None:
    """Draw the figures of the UniTeam report (arXiv 2312.08611) from runs of our agents, on fixed episodes.

    search-panel is its Figure 1: camera, third person and map in a step of the search. floor-as-table has a frame in
    which floor is taken for furniture, without and with the floor filter. goal-map has the frontier and the points
    around start receptacles. Each is a run of some seconds, up to the first step that shows what it is about.

    Args:
        out: Directory for the pictures.
        only: Which ones; all by default.
    """
    if not only:
        raise InvalidInputError("--only needs at least one name, such as --only search-panel")
    try_folder(out)
    console, written = make_console(), []
    names = tuple(dict.fromkeys(only))
    with counting(console, "playing and drawing", len(names)) as advance:
        for name in names:
            written.append(write_figure(name, out))
            advance()
    for path in written:
        console.print(f"{shown(path)} ({path.stat().st_size / 1e3:.0f} kB)", soft_wrap=True)
