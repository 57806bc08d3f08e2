r"""Export the instances that Infinigen generates, as plain triangles for `build_assets.py`; they are no part of git.

Infinigen (BSD-3-Clause) runs in Blender's Python module, so that it has an environment of its own (Python 3.11):

    python3.11 -m venv /tmp/infinigen && . /tmp/infinigen/bin/activate
    pip install bpy==4.2.0 && pip install --no-deps infinigen==1.15.5
    pip install "numpy<2" "opencv-python-headless<4.11" scipy shapely trimesh networkx gin-config tqdm pandas \
        matplotlib pillow imageio scikit-image scikit-learn psutil pyyaml rtree OpenEXR coacd frozendict attrs submitit
    nice -n 15 python tools/export_generated.py --out /tmp/generated

What is there already is not generated again, and a seed at which a factory fails is noted and not tried again.
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
NODES_OF_COLOR = ("BSDF_PRINCIPLED", "VALTORGB", "RGB", "MIX", "BSDF_DIFFUSE", "BSDF_GLASS", "BSDF_GLOSSY")


def main() -> None:
    """Read the arguments and export what is missing."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, required=True, help="folder for the triangles")
    out = parser.parse_args().out
    out.mkdir(parents=True, exist_ok=True)
    wanted = [(planned, seed) for planned in PLAN for seed in planned.seeds]
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
    """Write one instance: corners (T, 3, 3), materials (T,), and of each material its shader's name and colour."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    module = importlib.import_module(f"infinigen.assets.objects.{planned.module}")
    with FixedSeed(seed):
        factory = getattr(module, planned.factory)(seed)
        made = factory.spawn_asset(seed)
        factory.finalize_assets([made])
    corners, owners, names, colors = [], [], [], []
    for thing in (made, *made.children_recursive):
        part, slots = triangles(thing)
        corners.append(part)
        owners.append(slots + len(names))
        materials = list(thing.data.materials) if thing.type == "MESH" else []
        names += [material.name if material else "" for material in materials] or [""]
        colors += [base_color(material) for material in materials] or [(0.7, 0.7, 0.7)]
    unfinished = path.with_suffix(".part")
    with unfinished.open("wb") as file:
        np.savez_compressed(
            file,
            corners=np.concatenate(corners).astype(np.float32),
            materials=np.concatenate(owners).astype(np.int32),
            names=np.array(names),
            colors=np.array(colors, np.float32),
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


def base_color(material: Any) -> tuple[float, float, float]:
    """Return the mean of the linear colours that a shader mixes, sRGB; grey where it names none."""
    found: list[tuple[float, ...]] = []
    if material is not None and material.use_nodes:
        for node in material.node_tree.nodes:
            if node.type == "VALTORGB":
                found += [tuple(element.color)[:3] for element in node.color_ramp.elements]
            elif node.type == "RGB":
                found.append(tuple(node.outputs[0].default_value)[:3])
            elif node.type in NODES_OF_COLOR:
                inputs = [i for i in node.inputs if i.type == "RGBA" and not i.is_linked and i.name in COLOR_INPUTS]
                found += [tuple(i.default_value)[:3] for i in inputs]
    if not found:
        return (0.7, 0.7, 0.7)
    linear = np.clip(np.mean(np.array(found), axis=0), 0.0, 1.0)
    r, g, b = np.where(linear < 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return (float(r), float(g), float(b))


COLOR_INPUTS = ("Base Color", "Color", "A", "B", "Color1", "Color2")


if __name__ == "__main__":
    main()
