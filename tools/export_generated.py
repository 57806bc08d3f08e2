r"""Export the instances that Infinigen generates, as plain triangles for `build_assets.py`; they are no part of git.

Infinigen (BSD-3-Clause) runs in Blender's Python module, so that it has an environment of its own (Python 3.11):

    python3.11 -m venv /tmp/infinigen && . /tmp/infinigen/bin/activate
    pip install bpy==4.2.0 && pip install --no-deps infinigen==1.15.5
    pip install "numpy<2" "opencv-python-headless<4.11" scipy shapely trimesh networkx gin-config tqdm pandas \
        matplotlib pillow imageio scikit-image scikit-learn psutil pyyaml rtree OpenEXR coacd frozendict attrs submitit
    nice -n 15 python tools/export_generated.py --out /tmp/generated

What is there already is not generated again, and a seed at which a factory fails is noted and not tried again. A seed
gives the same shape every time, its triangles perhaps in another order.
"""

import argparse
import importlib
import traceback
from pathlib import Path
from typing import Any

import bpy  # type: ignore[import-not-found]
import numpy as np
from assets_build.generated_plan import PLAN, Generated
from infinigen.core.util.math import FixedSeed  # type: ignore[import-not-found]

MOST_FACES = 24_000


def main() -> None:
    """Read the arguments and export what is missing."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, required=True, help="folder for the triangles")
    parser.add_argument("--more", type=int, default=0, help="export so many others for training instead (default: 0)")
    arguments = parser.parse_args()
    out = arguments.out
    out.mkdir(parents=True, exist_ok=True)
    plan = [planned.more(arguments.more) for planned in PLAN] if arguments.more else PLAN
    wanted = [(planned, seed) for planned in plan for seed in planned.seeds]
    for planned, seed in sorted(wanted, key=lambda pair: pair[1] % 10_000):
        path = out / f"{planned.file(seed)}.npz"
        failed = path.with_suffix(".failed")
        if path.exists() or failed.exists():
            continue
        try:
            export(planned, seed, path)
        except Exception:  # a factory may fail in any way, and the others are still wanted
            failed.write_text(traceback.format_exc())
        print(path.stem, "failed" if failed.exists() else "done", flush=True)


def export(planned: Generated, seed: int, path: Path) -> None:
    """Write one instance: corners (T, 3, 3), materials (T,), and of each material its shader's name."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    module = importlib.import_module(f"infinigen.assets.objects.{planned.module}")
    with FixedSeed(seed):
        factory = getattr(module, planned.factory)(seed)
        made = factory.spawn_asset(seed)
        factory.finalize_assets([made])
    corners, owners, names = [], [], []
    for thing in (made, *made.children_recursive):
        part, slots = triangles(thing)
        corners.append(part)
        owners.append(slots + len(names))
        materials = list(thing.data.materials) if thing.type == "MESH" else []
        names += [material.name if material else "" for material in materials] or [""]
    unfinished = path.with_suffix(".part")
    with unfinished.open("wb") as file:
        np.savez_compressed(
            file,
            corners=np.concatenate(corners).astype(np.float32),
            materials=np.concatenate(owners).astype(np.int32),
            names=np.array(names),
        )
    unfinished.rename(path)


def triangles(thing: Any) -> tuple[np.ndarray, np.ndarray]:
    """Return a Blender object's triangles (T, 3, 3) in the world and the material slot of each (T,)."""
    if thing.type != "MESH" or not len(thing.data.polygons):
        return np.zeros((0, 3, 3)), np.zeros(0, np.int32)
    if len(thing.data.polygons) > MOST_FACES:
        modifier = thing.modifiers.new("fewer", "DECIMATE")
        modifier.ratio = MOST_FACES / len(thing.data.polygons)
    mesh = thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    mesh.calc_loop_triangles()
    points = np.zeros(3 * len(mesh.vertices))
    mesh.vertices.foreach_get("co", points)
    points = np.c_[points.reshape(-1, 3), np.ones(len(mesh.vertices))] @ np.array(thing.matrix_world).T
    indices = np.zeros(3 * len(mesh.loop_triangles), np.int32)
    mesh.loop_triangles.foreach_get("vertices", indices)
    slots = np.zeros(len(mesh.loop_triangles), np.int32)
    mesh.loop_triangles.foreach_get("material_index", slots)
    return points[:, :3][indices.reshape(-1, 3)], np.minimum(slots, max(0, len(mesh.materials) - 1))


if __name__ == "__main__":
    main()
