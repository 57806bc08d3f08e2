"""Floor and wall textures: those of the source package made into square tiles, and plain ones drawn here."""

import hashlib
import json
import re
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

from assets_build.drawn_textures import DRAWN
from assets_build.images import encode_jpeg
from assets_build.sources import DEFAULT_TEXTURES, read_properties

LIMIT = 512

# What each texture of the source package suits, and a factor on the size its catalogue gives, judged by eye.
CHOSEN: dict[str, tuple[list[str], float]] = {
    "woodenFloor": (["floor"], 2.0),
    "greyTile": (["floor"], 1.0),
    "blueTiles": (["wall"], 1.0),
    "redTiles": (["floor"], 1.0),
    "stoneTiles": (["floor"], 1.0),
    "blackAndWhiteTiles": (["floor"], 1.0),
    "pebbles": (["wall"], 2.0),
    "stoneWall": (["wall"], 1.0),
    "stone2Wall": (["wall"], 1.0),
    "oldWoodenFloor": (["floor"], 2.0),
    "roughcast": (["wall"], 2.0),
    "pavingStone": (["floor"], 1.0),
    "smallBricks": (["wall"], 1.0),
    "beigeTile": (["floor"], 1.5),
    "lightBlueTile": (["floor", "wall"], 1.0),
    "darkBlueTile": (["floor"], 1.0),
    "wallBeigeTile": (["wall"], 1.0),
    "stone3Wall": (["wall"], 1.0),
    "marbleWall": (["floor", "wall"], 1.5),
    "smallRedBricks": (["wall"], 1.0),
    "smallWhiteBricks": (["wall"], 1.0),
}


def build_textures(source_root: Path, folder: Path) -> None:
    """Write every texture and the list of them."""
    folder.mkdir(parents=True, exist_ok=True)
    listed: dict[str, Any] = {}
    for entry in read_properties(source_root / DEFAULT_TEXTURES).values():
        key = entry["id"].split("#")[1]
        if key not in CHOSEN:
            continue
        kinds, factor = CHOSEN[key]
        image = cv2.imread(str(source_root / entry["image"].lstrip("/")))[..., ::-1]
        tile, size = _square(image, factor * float(entry["width"]) / 100, factor * float(entry["height"]) / 100)
        name = re.sub(r"([a-z0-9])([A-Z])", r"\1_\2", key).lower()
        listed[name] = {"kinds": kinds, "size": round(size, 3), "title": entry["name"].lower()} | _write(
            folder, name, tile
        )
        listed[name] |= {
            "source": "Sweet Home 3D default textures",
            "creator": entry["creator"],
            "licence": "CC-BY-3.0",
        }
    for name, drawn in DRAWN.items():
        image = drawn.draw(np.random.default_rng(sum(name.encode())))
        listed[name] = {"kinds": list(drawn.kinds), "size": drawn.size, "title": name.replace("_", " ")}
        listed[name] |= _write(folder, name, image) | {"source": "drawn", "creator": "uniteam", "licence": "CC0-1.0"}
    (folder / "textures.json").write_text(json.dumps(listed, indent=1, sort_keys=True) + "\n", encoding="utf-8")


def _write(folder: Path, name: str, image: NDArray[np.uint8]) -> dict[str, str]:
    data = encode_jpeg(image, 85)
    (folder / f"{name}.jpg").write_bytes(data)
    return {"checksum": hashlib.sha256(data).hexdigest()}


def _square(image: NDArray[np.uint8], width: float, height: float) -> tuple[NDArray[np.uint8], float]:
    """Return repeats of an image that make a square of about 1 m, and the square's side (m)."""
    options = [(a, b) for a in range(1, 9) for b in range(1, 9) if max(a * width, b * height) < 1.6 or (a, b) == (1, 1)]
    across, down = min(
        options, key=lambda o: (abs(np.log(o[0] * width / (o[1] * height))) > 0.08, abs(o[0] * width - 1.0))
    )
    tiled = np.tile(image, (down, across, 1))
    return cv2.resize(tiled, (LIMIT, LIMIT), interpolation=cv2.INTER_AREA), (across * width + down * height) / 2
