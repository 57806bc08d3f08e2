"""Models that were built before are found again, so that only what changed is built."""

import hashlib
import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

CONVERSION = (
    "convert",
    "geometry",
    "glb",
    "hollow",
    "images",
    "instance",
    "masses",
    "sampling",
    "shapes",
    "surfaces",
    "voxels",
    "wavefront",
)


class Kept:
    """Models built before, found again by what they were built from.

    Attributes:
        folder: where they are kept.
    """

    def __init__(self, folder: Path) -> None:
        """Take the folder that keeps them."""
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)
        self._code = "".join((Path(__file__).parent / f"{name}.py").read_text() for name in CONVERSION)

    def build(self, key: str, make: Callable[[Path], dict[str, Any]]) -> dict[str, Any]:
        """Return the catalogue entry of a model, building it only where its key or the conversion changed."""
        path = self.folder / f"{hashlib.sha256((self._code + key).encode()).hexdigest()[:24]}.json"
        if not path.exists():
            model = make(self.folder)
            print(model["id"], flush=True)
            path.write_text(json.dumps(model))
            shutil.copy(self.folder / f"{model['id']}.glb", path.with_suffix(".glb"))
        model = json.loads(path.read_text())
        return model | {"file": path.with_suffix(".glb").name}
