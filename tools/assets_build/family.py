"""A family of drawn models: one way to draw a thing, and as many instances as are wanted of it."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from assets_build.instance import Piece
from assets_build.primitives import Drawing
from assets_build.selection import Entry
from assets_build.variation import Pool, Variation

Draw = Callable[[Drawing, Variation], None]


@dataclass(frozen=True)
class Family:
    """What a family's instances are.

    Attributes:
        category, name: as in the catalogue of the pack.
        draw: draws one instance.
        density: kg for each m3 of the bounding box.
        train, test: how many instances each pool gets.
        collision, boxes, role: as in an `Entry`.
    """

    category: str
    name: str
    draw: Draw
    density: float
    train: int = 6
    test: int = 3
    collision: str = "hull"
    boxes: int = 8
    role: str = "object"

    def pieces(self) -> Iterator[Piece]:
        """Yield the instances, those for training first."""
        yield from self._series(self.category, "train", self.train)
        yield from self._series(self.category, "test", self.test)

    def more(self, count: int) -> Iterator[Piece]:
        """Yield other instances, for training, of a family that trains."""
        if self.train:
            yield from self._series(f"{self.category}_more", "train", count)

    def _series(self, series: str, pool: Pool, count: int) -> Iterator[Piece]:
        for index in range(count):
            yield self._piece(f"{series}_{pool}_{index}", Variation(series, pool, index, count), pool)

    def _piece(self, model_id: str, variation: Variation, pool: Pool) -> Piece:
        drawing = Drawing()
        self.draw(drawing, variation)
        entry = Entry(model_id, self.role, self.category, self.name, collision=self.collision, boxes=self.boxes)
        provenance = {"source": "drawn", "source_id": model_id, "creator": "uniteam", "licence": "CC0-1.0"}
        return Piece(drawing, entry, self.density, provenance, pool)
