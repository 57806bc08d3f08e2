"""Build the pack of models, textures and its catalogue.

Models come from two Debian packages, from Infinigen's generators (see `export_generated.py`), from two wheels, and from
what is drawn here. Those that were looked at and are not what they are called stand in `assets_build/rejected.json`.

    apt-get download sweethome3d-furniture sweethome3d
    pip download --no-deps robosuite==1.5.2 metaworld==3.1.1
    pip install '.[assets]'
    python tools/build_assets.py --debs . --wheels . --generated /tmp/generated --work /tmp/assets
"""

import argparse
import hashlib
import json
import shutil
from pathlib import Path
from typing import Any

from assets_build.attribution import attribution_text
from assets_build.borrowed import borrowed_pieces
from assets_build.convert import build_drawn, build_model
from assets_build.drawn_decor import DECOR
from assets_build.drawn_furniture import FURNITURE
from assets_build.drawn_objects import OBJECTS
from assets_build.families import FAMILIES
from assets_build.floors_and_walls import build_textures
from assets_build.generated import generated_pieces
from assets_build.generated_plan import PLAN
from assets_build.kept import Kept
from assets_build.pools import assign_pools
from assets_build.selection import read_selection
from assets_build.sources import read_sources

BUILD = Path(__file__).parent / "assets_build"
PACK = Path(__file__).parents[1] / "src/uniteam/world/assets/pack"


def main() -> None:
    """Read the arguments and build."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--debs", type=Path, required=True, help="folder of the two Debian packages")
    parser.add_argument("--wheels", type=Path, required=True, help="folder of the two wheels")
    parser.add_argument("--generated", type=Path, required=True, help="folder of what Infinigen generated")
    parser.add_argument("--work", type=Path, required=True, help="folder for what is unpacked and kept between runs")
    parser.add_argument("--pack", type=Path, default=PACK)
    arguments = parser.parse_args()
    sources = read_sources(arguments.debs, arguments.work)
    kept = Kept(arguments.work / "built")
    models = []
    for entry in read_selection(BUILD / "selection.json"):
        source = sources[entry.source]
        models.append(kept.build(f"{entry!r}", lambda folder, e=entry, s=source: build_model(s, e, folder)))
    for drawn in (*FURNITURE, *OBJECTS, *DECOR):
        models.append(kept.build(_drawing_key(drawn), lambda folder, d=drawn: build_drawn(d, folder)))
    for family in FAMILIES:
        models += [kept.build(piece.key(), piece.write) for piece in family.pieces()]
    for planned in PLAN:
        models += [kept.build(piece.key(), piece.write) for piece in generated_pieces(planned, arguments.generated)]
    models += [kept.build(piece.key(), piece.write) for piece in borrowed_pieces(arguments.wheels)]
    rejected = frozenset(json.loads((BUILD / "rejected.json").read_text()))
    models = [model for model in models if model["id"] not in rejected]
    _write_pack(arguments.pack, models, kept.folder, arguments.work / "sweethome3d/models/sweethome3d")


def _drawing_key(drawn: Any) -> str:
    """Return what a drawing depends on: its triangles, textures and options."""
    from assets_build.primitives import Drawing

    drawing = Drawing()
    drawn.draw(drawing)
    content = hashlib.sha256()
    for array in (*drawing.corners, *drawing.uvs):
        content.update(array.tobytes())
    for finish in drawing.finishes:
        content.update(repr(finish).encode())
    options = (
        drawn.role,
        drawn.category,
        drawn.slug,
        drawn.name,
        drawn.collision,
        drawn.boxes,
        drawn.mass,
        drawn.budget,
    )
    return f"{options} {content.hexdigest()}"


def _write_pack(pack: Path, models: list[dict[str, Any]], built: Path, textures: Path) -> None:
    shutil.rmtree(pack / "models", ignore_errors=True)
    (pack / "models").mkdir(parents=True)
    for model in models:
        shutil.copy(built / model.pop("file"), pack / "models" / f"{model['id']}.glb")
    build_textures(textures, pack / "textures")
    unseen = frozenset(json.loads((BUILD / "unseen_categories.json").read_text()))
    unseen &= {m["category"] for m in models if m["role"] == "object"}
    listed = assign_pools(models, unseen)
    lines = ",\n".join(json.dumps(m, separators=(",", ":")) for m in listed)
    (pack / "catalogue.json").write_text(
        f'{{"unseen_categories":{json.dumps(sorted(unseen))},\n"models":[\n{lines}\n]}}\n', encoding="utf-8"
    )
    described = json.loads((pack / "textures/textures.json").read_text())
    robot = (BUILD / "robot_attribution.md").read_text()
    (pack / "ATTRIBUTION.md").write_text(attribution_text(listed, described, robot), encoding="utf-8")


if __name__ == "__main__":
    main()
