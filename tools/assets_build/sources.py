"""The catalogues of the source packages: where each model's files lie, its real size, and whom to thank."""

import re
import subprocess
import zipfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

LIBRARIES = {
    "scopia": ("Scopia", "CC-BY-3.0"),
    "blendswap-cc-0": ("BlendSwap-CC-0", "CC0-1.0"),
    "blendswap-cc-by": ("BlendSwap-CC-BY", "CC-BY-3.0"),
    "katorlegaz": ("KatorLegaz", "CC-BY-3.0-US"),
}
DEFAULT_CATALOGUE = "com/eteks/sweethome3d/io/DefaultFurnitureCatalog.properties"
DEFAULT_TEXTURES = "com/eteks/sweethome3d/io/DefaultTexturesCatalog.properties"


@dataclass(frozen=True)
class SourceModel:
    """An entry of a source catalogue; `size`: (width, depth, height) in m; `rotation`: (3, 3), of y-up vertices."""

    source: str
    source_id: str
    name: str
    creator: str
    licence: str
    obj_path: Path
    size: tuple[float, float, float]
    rotation: NDArray[np.float64]


def extract_package(deb: Path, work: Path) -> Path:
    """Unpack a Debian package and the archives within it that hold models, and return the folder; done once."""
    folder = work / deb.name.split("_")[0]
    if (folder / "complete").exists():
        return folder
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run(["ar", "x", str(deb.resolve())], cwd=folder, check=True)
    subprocess.run(["tar", "xf", str(next(folder.glob("data.tar.*")))[len(str(folder)) + 1 :]], cwd=folder, check=True)
    for archive in (
        *folder.glob("usr/share/sweethome3d/furniture/*.sh3f"),
        *folder.glob("usr/share/sweethome3d/*.jar"),
    ):
        with zipfile.ZipFile(archive) as file:
            names = [n for n in file.namelist() if archive.suffix == ".sh3f" or "/io/" in n]
            file.extractall(folder / "models" / archive.stem, names)
    (folder / "complete").touch()
    return folder


def read_properties(path: Path) -> dict[int, dict[str, str]]:
    """Return the numbered entries of a catalogue: {1: {"id": ..., "name": ...}, ...}."""
    entries: dict[int, dict[str, str]] = {}
    for line in path.read_text(encoding="latin-1").splitlines():
        match = re.match(r"(\w+)#(\d+)\s*=(.*)", line)
        if match:
            entries.setdefault(int(match[2]), {})[match[1]] = match[3].strip().encode().decode("unicode_escape")
    return entries


def _source_model(entry: dict[str, str], root: Path, source: str, licence: str) -> SourceModel:
    rotation = np.array([float(v) for v in entry.get("modelRotation", "1 0 0 0 1 0 0 0 1").split()]).reshape(3, 3)
    size = (float(entry["width"]) / 100, float(entry["depth"]) / 100, float(entry["height"]) / 100)
    path = root / entry["model"].lstrip("/")
    return SourceModel(source, entry["id"], entry["name"], entry.get("creator", ""), licence, path, size, rotation)


def read_sources(debs: Path, work: Path) -> dict[str, SourceModel]:
    """Return every model of the two packages by its identifier."""
    furniture = extract_package(next(debs.glob("sweethome3d-furniture_*.deb")), work)
    application = extract_package(next(debs.glob("sweethome3d_*.deb")), work)
    models = []
    for library, licence in LIBRARIES.values():
        root = furniture / "models" / library
        entries = read_properties(root / "PluginFurnitureCatalog.properties").values()
        models += [_source_model(e, root, f"Sweet Home 3D furniture library {library}", licence) for e in entries]
    root = application / "models" / "sweethome3d"
    entries = read_properties(root / DEFAULT_CATALOGUE).values()
    models += [_source_model(e, root, "Sweet Home 3D default furniture", "CC-BY-3.0") for e in entries]
    return {model.source_id: model for model in models}
