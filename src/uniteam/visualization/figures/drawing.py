"""The figures by name: each is played, drawn and written."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from uniteam.visualization.canvas import Image
from uniteam.visualization.figures import floor_as_table, goal_map, search_panel
from uniteam.visualization.figures.moment import Moment, Scene
from uniteam.visualization.picture_file import write_jpeg, write_png


@dataclass(frozen=True)
class Figure:
    """A figure: its moment, how that is drawn, and the kind of file that suits it."""

    scene: Scene
    draw: Callable[[Moment], Image]
    suffix: str
    write: Callable[[Path, Image], None]

    def make(self) -> Image:
        """Play up to the moment and return the (H, W, 3) RGB figure; raises UniteamError where it never comes."""
        return self.draw(self.scene.play())


FIGURES: Mapping[str, Figure] = {
    "search-panel": Figure(search_panel.SCENE, search_panel.draw_search_panel, ".jpg", write_jpeg),
    "floor-as-table": Figure(floor_as_table.SCENE, floor_as_table.draw_floor_as_table, ".jpg", write_jpeg),
    "goal-map": Figure(goal_map.SCENE, goal_map.draw_goal_map, ".png", write_png),
}
"""By the names of their files."""


def write_figure(name: str, directory: Path) -> Path:
    """Make a figure of `FIGURES`, write it into a directory and return its path.

    Raises:
        UniteamError: what it shows never comes.
        UnwritableError: the directory cannot be written into.
    """
    figure = FIGURES[name]
    path = directory / f"{name}{figure.suffix}"
    figure.write(path, figure.make())
    return path
