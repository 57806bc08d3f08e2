"""A model that is drawn here rather than converted."""

from collections.abc import Callable
from dataclasses import dataclass

from assets_build.primitives import Drawing


@dataclass(frozen=True)
class Drawn:
    """A model drawn here: what it is and how it is drawn; `collision`, `boxes`, `mass`, `budget` as in an `Entry`."""

    role: str
    category: str
    slug: str
    name: str
    draw: Callable[[Drawing], None]
    collision: str = ""
    boxes: int = 0
    mass: float = 0.0
    budget: int = 0
