"""What goes into the pack: the hand-made list of `selection.json`, read into entries."""

import json
import re
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any


@dataclass(frozen=True)
class Entry:
    """One model to build.

    Attributes:
        source: identifier in a source catalogue.
        role, category: as in the catalogue of the pack.
        name: what a person would call it; the source's own name where empty.
        turn: degrees about z that bring the front to -y, where the source has it elsewhere.
        scale: factor on the real size, where the source is a scale wrong.
        size: (width, depth, height) in m in place of the source's, where set.
        budget: most triangles.
        texture: most pixels of a texture's side.
        collision: "boxes", "solid" (filled below every top), "hull", "hollow" (open at the top) or "none".
        boxes: most boxes; by category where 0.
        mass: kg; estimated from the category where 0.
    """

    source: str
    role: str
    category: str
    name: str = ""
    turn: float = 0.0
    scale: float = 1.0
    size: tuple[float, float, float] | None = None
    budget: int = 0
    texture: int = 0
    collision: str = ""
    boxes: int = 0
    mass: float = 0.0

    @property
    def id(self) -> str:
        """The model's id in the pack."""
        slug = re.sub(
            r"[^a-z0-9]+", "_", re.sub(r"([a-z])([A-Z])", r"\1_\2", self.source.split("#")[-1]).lower()
        ).strip("_")
        library = {
            "Scopia": "sc",
            "Kator Legaz": "kl",
            "Blend Swap CC-0": "b0",
            "Blend Swap CC-BY": "bb",
            "eTeks": "et",
        }
        return f"{self.category}_{library[self.source.split('#')[0]]}_{slug}"


def read_selection(path: Path) -> list[Entry]:
    """Return the entries of a file: role -> category -> list of sources, each a name or a table with `source`."""
    known = {f.name for f in fields(Entry)}
    entries = []
    for role, categories in json.loads(path.read_text(encoding="utf-8")).items():
        for category, items in categories.items():
            for item in items:
                data: dict[str, Any] = {"source": item} if isinstance(item, str) else dict(item)
                unknown = set(data) - known
                if unknown:
                    raise ValueError(f"{data['source']}: unknown fields {unknown}")
                entries.append(Entry(role=role, category=category, **data))
    return entries
