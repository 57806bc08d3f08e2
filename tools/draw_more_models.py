"""Draw more models for training than the pack has room for: a library that adds to it, for `uniteam train --library`.

A network that saw few models of a class tells the models, not the class. The families that the pack's models come from
draw as many more as are wanted, all from what training may draw from: no shape, finish or seed of a test model.

    pip install '.[assets]'
    python tools/draw_more_models.py --count 16 --out more_models
    uniteam train segmenter --library more_models

With `--generated`, what Infinigen made is added (see `export_generated.py`, whose `--more` must be the same number).
"""

import argparse
import json
import shutil
from collections.abc import Iterator
from pathlib import Path

from assets_build.families import FAMILIES
from assets_build.generated import generated_pieces
from assets_build.generated_plan import PLAN
from assets_build.instance import Piece
from assets_build.kept import Kept


def main() -> None:
    """Read the arguments and draw."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--count", type=int, default=16, help="models of each family (default: 16)")
    parser.add_argument("--generated", type=Path, help="folder of what Infinigen generated")
    parser.add_argument("--out", type=Path, required=True, help="folder of the library")
    arguments = parser.parse_args()
    kept = Kept(arguments.out / "built")
    models = [kept.build(piece.key(), piece.write) for piece in _pieces(arguments.count, arguments.generated)]
    folder = arguments.out / "models"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for model in models:
        shutil.copy(kept.folder / model.pop("file"), folder / f"{model['id']}.glb")
    content = json.dumps({"adds_to_pack": True, "models": models}, separators=(",", ":"))
    (arguments.out / "catalogue.json").write_text(content, encoding="utf-8")
    print(f"{len(models)} models in {arguments.out}")


def _pieces(count: int, generated: Path | None) -> Iterator[Piece]:
    for family in FAMILIES:
        yield from family.more(count)
    if generated is not None:
        for planned in PLAN:
            yield from generated_pieces(planned.more(count), generated)


if __name__ == "__main__":
    main()
